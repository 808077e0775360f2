// The emulated multiply-add gives the bits of a fused one. Mirrors sdf/distance/lanes/fma-inl.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/sdf/distance/lanes/fma_test.cpp"
#include <hwy/foreach_target.h>
#include "sdf/distance/lanes/fma-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

void EmulatedFma(const float* x, const float* y, const float* z, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(Emulated(hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i)), d, out + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>
#include "sdf/distance/instruction_sets.h"

#include <bit>
#include <cmath>
#include <random>
#include <vector>

namespace mien::batch {
HWY_EXPORT(EmulatedFma);
namespace {

TEST(Fma, EmulationGivesTheFusedBits) {
  constexpr size_t kCount = 1 << 20;
  std::mt19937_64 bits(1);
  std::vector<float> x(kCount), y(kCount), z(kCount), out(kCount);
  for (size_t i = 0; i < kCount; ++i) {
    // Few mantissa bits and near cancellation in turn: exact ties are where double rounding shows.
    const auto number = [&](int mantissa) {
      const double m = double(bits() >> (64 - mantissa)) + 1;
      return float(std::ldexp(bits() & 1 ? m : -m, int(bits() % 40) - mantissa - 20));
    };
    const int width = i % 3 == 0 ? 13 : 24;
    x[i] = number(width), y[i] = number(width), z[i] = number(24);
    if (i % 5 == 0) z[i] = -x[i] * y[i];
    if (i % 7 == 0) z[i] = std::ldexp(x[i] * y[i], 24 + int(bits() % 3));
  }
  for (const InstructionSet& set : instruction_sets()) {
    SCOPED_TRACE(set.name);
    use_instruction_set(set.id);
    HWY_DYNAMIC_DISPATCH(EmulatedFma)(x.data(), y.data(), z.data(), kCount, out.data());
    size_t wrong = 0;
    for (size_t i = 0; i < kCount; ++i) {
      const float fused = std::fma(x[i], y[i], z[i]);
      wrong += std::bit_cast<uint32_t>(out[i]) != std::bit_cast<uint32_t>(fused) &&
               !(out[i] == 0 && fused == 0);
    }
    EXPECT_EQ(wrong, 0u);
  }
  use_instruction_set(0);
}

}  // namespace
}  // namespace mien::batch
#endif
