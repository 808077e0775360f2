#include <mien/render/blend/transfer.h>
#include <mien/render/rows/pixel_format.h>

namespace mien {

EncodeTable::EncodeTable() {
  for (int i = 0; i <= kCells; ++i)
    values_[std::size_t(i)] = float(srgb_from_linear(double(i) / kCells));
}

const EncodeTable& EncodeTable::shared() {
  static const EncodeTable table;
  return table;
}

void PixelFormat::light(const Rgba& mix, std::byte* to) const {
  store({mix.r, mix.g, mix.b, mix.a}, blend_, Depth::f32, to);
}

void fill_pixels(std::byte* to, int count, const std::byte* value, std::size_t bytes) {
  if (bytes == 4) {
    std::uint32_t v;
    std::memcpy(&v, value, 4);
    auto* const pixels = reinterpret_cast<std::uint32_t*>(to);
    for (int i = 0; i < count; ++i) pixels[i] = v;
  } else if (bytes == 8) {
    std::uint64_t v;
    std::memcpy(&v, value, 8);
    auto* const pixels = reinterpret_cast<std::uint64_t*>(to);
    for (int i = 0; i < count; ++i) pixels[i] = v;
  } else {
    for (int i = 0; i < count; ++i) std::memcpy(to + bytes * std::size_t(i), value, bytes);
  }
}

}  // namespace mien
