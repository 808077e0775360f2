#include <mien/render/rows/pixel_format.h>

#include <cstring>

namespace mien {

void scatter_pixels(const std::byte* from, std::span<const int> columns, std::size_t bytes,
                    std::byte* to) {
  const auto scatter = [&]<std::size_t kBytes>() {
    for (std::size_t i = 0; i < columns.size(); ++i)
      std::memcpy(to + std::ptrdiff_t(kBytes) * columns[i], from + kBytes * i, kBytes);
  };
  if (bytes == 4) return scatter.operator()<4>();
  if (bytes == 8) return scatter.operator()<8>();
  scatter.operator()<16>();
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
