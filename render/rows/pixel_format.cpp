#include "render/rows/pixel_format.h"

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

}  // namespace mien
