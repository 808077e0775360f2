#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/support/fill_floor_simd.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace mien::bench {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// `pixels` is aligned to a vector; what is left over at the end is not worth a figure.
void Ordinary(uint32_t* pixels, size_t count, uint32_t color) {
  const hn::ScalableTag<uint32_t> d;
  const auto v = hn::Set(d, color);
  for (size_t i = 0; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) hn::Store(v, d, pixels + i);
}

void Streaming(uint32_t* pixels, size_t count, uint32_t color) {
  const hn::ScalableTag<uint32_t> d;
  const auto v = hn::Set(d, color);
  for (size_t i = 0; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) hn::Stream(v, d, pixels + i);
  hwy::FlushStream();
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "bench/support/fill_floor.h"

namespace mien::bench {
HWY_EXPORT(Ordinary);
HWY_EXPORT(Streaming);

void fill_ordinary(std::uint32_t* pixels, std::size_t count, std::uint32_t color) {
  HWY_DYNAMIC_DISPATCH(Ordinary)(pixels, count, color);
}
void fill_streaming(std::uint32_t* pixels, std::size_t count, std::uint32_t color) {
  HWY_DYNAMIC_DISPATCH(Streaming)(pixels, count, color);
}

}  // namespace mien::bench
#endif
