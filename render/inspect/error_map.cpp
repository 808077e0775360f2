#include <mien/error_map.h>
#include "lib/base/memory_ran_out.h"
#include "render/blend/transfer.h"
#include "render/rows/drawing.h"
#include "render/watched.h"

#include <algorithm>

namespace mien {
namespace {

ErrorMap map_of(const Scene& scene, const View& view, Depth depth, const Threads& threads) {
  const PixelRect rect = drawn_rect(view);
  ErrorMap map{.width = rect.width, .height = rect.height, .levels = {}, .estimated = {}};
  map.levels.resize(std::size_t(rect.width) * std::size_t(rect.height));
  map.estimated.resize(map.levels.size());
  const ErrorNotes notes{rect, map.levels.data(), map.estimated.data()};
  Drawing drawing;
  drawing.make(scene, view, depth, threads);
  const std::size_t stride = std::size_t(rect.width) * 4 * bytes_per_channel(depth);
  std::vector<std::byte> pixels(stride * std::size_t(rect.height));
  const RowTarget target{pixels.data(), stride, rect};
  const int first = rect.y / Drawing::kRows,
            strips = (rect.y + rect.height + Drawing::kRows - 1) / Drawing::kRows - first;
  parallel_for(strips, threads, [&](int i) {
    StripScratch scratch;
    drawing.draw_strip_with_errors(first + i, target, scratch, notes);
  });
  for (const float level : map.levels) map.worst = std::max(map.worst, level);
  return map;
}

}  // namespace

Expected<ErrorMap> error_map(const Scene& scene, const View& view, const RenderOptions& how) try {
  return watched(
      how.progress, how.limits, view.width * std::int64_t(view.height),
      [&] { return map_of(scene, view, how.depth, how.threads); }, [] { return 0.0; });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

long long ErrorMap::estimated_pixels() const {
  return std::count(estimated.begin(), estimated.end(), 1);
}

Image ErrorMap::image() const {
  Image image{.width = width, .height = height};
  image.bytes.resize(image.stride() * std::size_t(height));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto grey = std::byte(worst > 0 ? level(double(levels[i] / worst), 255) : 0);
    std::fill_n(image.bytes.begin() + std::ptrdiff_t(4 * i), 3, grey);
    if (estimated[i]) image.bytes[4 * i + 2] = std::byte(128 + std::to_integer<int>(grey) / 2);
    image.bytes[4 * i + 3] = std::byte{255};
  }
  return image;
}

}  // namespace mien
