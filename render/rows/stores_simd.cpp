// Stores of pixels, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/rows/stores_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/rows/stores.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pixel is as long as a part of 16 bytes, and so is any whole number of them: the same vector is right from wherever
/// a pixel begins.
void FillRun(std::uint8_t* to, size_t size, const std::uint8_t* pattern, size_t bytes,
             bool streamed) {
  constexpr size_t kLine = 64, kWorth = 8 * kLine;
  const hn::CappedTag<std::uint8_t, kLine> d;
  const size_t lanes = hn::Lanes(d);
  const auto v = hn::LoadU(d, pattern);
  size_t i = 0;
  const bool wide = lanes >= 16;  // else a vector is shorter than a pixel
  if (streamed && wide && size >= kWorth && reinterpret_cast<std::uintptr_t>(to) % bytes == 0) {
    i = (kLine - reinterpret_cast<std::uintptr_t>(to) % kLine) % kLine;
    std::memcpy(to, pattern, i);
    for (const size_t end = i + (size - i) / kLine * kLine; i < end; i += lanes)
      hn::Stream(v, d, to + i);
  }
  const bool went_past_caches = i > 0;  // what bypassed them would have to be read back
  for (; wide && i + lanes <= size; i += lanes) hn::StoreU(v, d, to + i);
  if (wide && size >= lanes && !went_past_caches)
    return hn::StoreU(v, d, to + size - lanes);  // the rest, with some again
  for (; i + 16 <= size; i += 16) std::memcpy(to + i, pattern, 16);
  if (i + 8 <= size) std::memcpy(to + i, pattern, 8), i += 8;
  if (i + 4 <= size) std::memcpy(to + i, pattern, 4);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <hwy/cache_control.h>

namespace mien {
namespace batch {
HWY_EXPORT(FillRun);
}  // namespace batch

void fill_run(std::byte* to, int count, const RunPattern& pattern, std::size_t bytes,
              Stores stores) {
  MIEN_DISPATCH(FillRun)
  (reinterpret_cast<std::uint8_t*>(to), std::size_t(count) * bytes,
   reinterpret_cast<const std::uint8_t*>(pattern.data()), bytes, stores == Stores::streamed);
}
void finish_streams() {
  hwy::FlushStream();
}

}  // namespace mien
#endif
