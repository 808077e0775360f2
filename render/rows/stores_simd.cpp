// Stores of pixels, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/rows/stores_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <mien/render/rows/stores.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void FillRows(std::uint32_t* pixels, size_t stride, int rows, int count, std::uint32_t value,
              bool streamed) {
  const hn::CappedTag<std::uint32_t, 16> d;
  const auto v = hn::Set(d, value);
  const size_t n = hn::Lanes(d), all = size_t(count);
  for (int row = 0; row < rows; ++row, pixels += stride) {
    size_t i = 0;
    if (streamed) {
      for (; i < all && reinterpret_cast<std::uintptr_t>(pixels + i) % (4 * n) != 0; ++i)
        pixels[i] = value;
      for (; i + n <= all; i += n) hn::Stream(v, d, pixels + i);
    } else {
      for (; i + n <= all; i += n) hn::StoreU(v, d, pixels + i);
    }
    for (; i < all; ++i) pixels[i] = value;
  }
}

void StreamRows(const std::uint32_t* from, int count, int rows, std::uint32_t* pixels,
                size_t stride) {
  const hn::CappedTag<std::uint32_t, 16> d;
  for (int row = 0; row < rows; ++row)
    for (size_t i = 0; i < size_t(count); i += hn::Lanes(d))
      hn::Stream(hn::LoadU(d, from + size_t(row) * size_t(count) + i), d,
                 pixels + size_t(row) * stride + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <hwy/cache_control.h>

namespace mien {
namespace batch {
HWY_EXPORT(FillRows);
HWY_EXPORT(StreamRows);
}  // namespace batch

void fill_rows(std::uint32_t* pixels, std::size_t stride, int rows, int count, std::uint32_t value,
               Stores stores) {
  HWY_DYNAMIC_DISPATCH(batch::FillRows)
  (pixels, stride, rows, count, value, stores == Stores::streamed);
}
void stream_rows(const std::uint32_t* from, int count, int rows, std::uint32_t* pixels,
                 std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(batch::StreamRows)(from, count, rows, pixels, stride);
}
void finish_streams() {
  hwy::FlushStream();
}

}  // namespace mien
#endif
