#include <mien/svg.h>
#include "lib/base/fingerprint.h"
#include "lib/base/memory_ran_out.h"
#include "render/render_error.h"
#include "render/svg/svg_writer_private.h"
#include "render/watched.h"
#include "sdf/scene/legible.h"

#include <fmt/format.h>

#include <new>

namespace mien {
namespace {

/// A prefix that other pictures do not have: of the scene and what of the options moves its paths.
std::string prefix_of(const Scene& scene, const SvgOptions& options) {
  Fingerprint print;
  print.add(options.width), print.add(options.height), print.add(int(options.fit));
  print.add(options.tolerance);
  for (const char c : scene.text()) print.add(int(c));
  // An id begins with a letter. 40 bits: among a thousand pictures two share one with a probability of 5e-7.
  return fmt::format("m{:08x}-", print.value() >> 24);
}

}  // namespace

Expected<Svg> svg_text(const Scene& scene, const SvgOptions& options) try {
  const auto side = [](double v) { return v > 0.0 && v <= View::kMaxSide; };  // NaN is not
  if (!side(options.width) || !side(options.height))
    return Error{"", fmt::format("a picture's sides are above 0 and at most {} pixels, not {} x {}",
                                 View::kMaxSide, options.width, options.height)};
  if (!(options.tolerance >= SvgOptions::kLeastTolerance && options.tolerance <= 1.0))
    return Error{"", fmt::format("a path's tolerance is {} to 1 pixels, not {}",
                                 SvgOptions::kLeastTolerance, options.tolerance)};
  try {
    double done = 0.0;
    const auto write = [&] {
      const glm::dvec2 size{options.width, options.height};
      const double scale = pixel_from_face(scene.canvas(), size, options.fit).scale();
      const Scene seen = legible_scene(scene, options.legible / scale);
      SvgOptions named = options;
      if (!named.id_prefix) named.id_prefix = prefix_of(seen, options);
      return SvgWriter(seen, named).write(done);
    };
    return watched(options.progress, options.limits, std::int64_t(options.width * options.height),
                   write, [&] { return done; });
  } catch (const std::bad_alloc&) {
    return Error{"",
                 fmt::format("{}: the scene has {} layers", kMemoryRanOut, scene.layers().size())};
  }
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
