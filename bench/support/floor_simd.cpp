#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/support/floor_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::bench {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// `rounds` times op on 16 independent vectors, enough to hide its latency. Returns the lanes per
/// vector.
template <class Op>
HWY_INLINE size_t Busy(size_t rounds, float* sink, Op op) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  // All different, or the compiler would compute one of them.
  const auto start = [&](float k) HWY_ATTR { return hn::Iota(d, k); };
  V v0 = start(1), v1 = start(2), v2 = start(3), v3 = start(4), v4 = start(5), v5 = start(6);
  V v6 = start(7), v7 = start(8), v8 = start(9), v9 = start(10), va = start(11), vb = start(12);
  for (size_t i = 0; i < rounds; ++i) {
    v0 = op(v0), v1 = op(v1), v2 = op(v2), v3 = op(v3), v4 = op(v4), v5 = op(v5);
    v6 = op(v6), v7 = op(v7), v8 = op(v8), v9 = op(v9), va = op(va), vb = op(vb);
  }
  const V sum =
      hn::Add(hn::Add(hn::Add(v0, v1), hn::Add(v2, v3)), hn::Add(hn::Add(v4, v5), hn::Add(v6, v7)));
  hn::StoreU(hn::Add(sum, hn::Add(hn::Add(v8, v9), hn::Add(va, vb))), d, sink);
  return hn::Lanes(d);
}

size_t BusyFma(size_t rounds, float* sink) {
  const hn::ScalableTag<float> d;
  const auto a = hn::Set(d, 0.5f), b = hn::Set(d, 0.7f);
  return Busy(rounds, sink, [=](auto v) HWY_ATTR { return hn::MulAdd(v, a, b); });
}
size_t BusyDiv(size_t rounds, float* sink) {
  const auto a = hn::Set(hn::ScalableTag<float>(), 1.7f);
  return Busy(rounds, sink, [=](auto v) HWY_ATTR { return hn::Div(a, v); });
}
size_t BusySqrt(size_t rounds, float* sink) {
  return Busy(rounds, sink, [](auto v) HWY_ATTR { return hn::Sqrt(v); });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <benchmark/benchmark.h>
#include "sdf/distance/instruction_sets.h"

#include "bench/support/floor.h"

namespace mien::bench {
HWY_EXPORT(BusyFma);
HWY_EXPORT(BusyDiv);
HWY_EXPORT(BusySqrt);

void register_floor() {
  const auto add = [](const std::string& name, long long set, auto busy) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      constexpr size_t kRounds = 1000, kVectors = 12;
      batch::use_instruction_set(set);
      float sink[64];
      size_t lanes = 1;
      for (auto _ : state) {
        lanes = busy(kRounds, sink);
        benchmark::DoNotOptimize(sink);
      }
      state.counters["ns"] =
          benchmark::Counter(double(state.iterations() * kRounds * kVectors * lanes) * 1e-9,
                             benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
      batch::use_instruction_set(0);
    })->MinTime(0.05);
  };
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    const auto id = set.id;
    add("floor fma/" + set.name, id,
        [](size_t n, float* s) { return HWY_DYNAMIC_DISPATCH(BusyFma)(n, s); });
    add("floor divide/" + set.name, id,
        [](size_t n, float* s) { return HWY_DYNAMIC_DISPATCH(BusyDiv)(n, s); });
    add("floor square root/" + set.name, id,
        [](size_t n, float* s) { return HWY_DYNAMIC_DISPATCH(BusySqrt)(n, s); });
  }
}

}  // namespace mien::bench
#endif
