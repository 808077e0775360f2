#include <mien/svg.h>
#include "render/render_error.h"
#include "render/svg/svg_writer_private.h"

#include <fmt/format.h>

#include <new>

namespace mien {

Expected<Svg> svg_text(const Scene& scene, const SvgOptions& options) {
  const auto side = [](double v) { return v > 0.0 && v <= View::kMaxSide; };  // NaN is not
  if (!side(options.width) || !side(options.height))
    return Error{"", fmt::format("a picture's sides are above 0 and at most {} pixels, not {} x {}",
                                 View::kMaxSide, options.width, options.height)};
  if (!(options.tolerance >= SvgOptions::kLeastTolerance && options.tolerance <= 1.0))
    return Error{"", fmt::format("a path's tolerance is {} to 1 pixels, not {}",
                                 SvgOptions::kLeastTolerance, options.tolerance)};
  try {
    return SvgWriter(scene, options).write();
  } catch (const std::bad_alloc&) {
    return Error{"",
                 fmt::format("{}: the scene has {} layers", kMemoryRanOut, scene.layers().size())};
  }
}

}  // namespace mien
