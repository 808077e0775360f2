#include "tests/support/random/fuzzed_picture.h"

#include <mien/render.h>
#include "render/reference/square_resolver.h"

#include <fmt/format.h>

#include "tests/support/exact/exact_compare.h"
#include "tests/support/exact/exact_truth.h"
#include "tests/support/random/changed_scene.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random_plain_scene.h"
#include "tests/support/random/random_scene.h"
#include "tests/support/scenes/huge_scene.h"
#include "tests/support/scenes/stroke_scene.h"

namespace mien::test {
namespace {

constexpr double kSure = 0.75;  // of what is allowed: the reference may be off by the rest
constexpr double kTolerance = 0x1p-15;

struct Drawn {
  Image image;
  int top;
  double allowed;
};

/// A picture at both depths, and the reference beside it.
void judge_blend(const Scene& scene, const View& view, const ExactTruth& truth, FuzzTally& tally) {
  RenderStats stats;
  const Drawn drawn[] = {{drawn_image(scene, view, Depth::u8, &stats), 255, 1.0},
                         {drawn_image(scene, view, Depth::u16, &stats), 65535, 32.0}};
  tally.pictures += 2, tally.doubted += stats.doubts > 0;
  tally.resolved += long(stats.resolved_pixels);
  PaintTable paints;
  paints.make(scene, view, Depth::u16);
  SquareResolver resolver(scene, view, paints, kTolerance);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      ++tally.pixels;
      const Resolved found = resolver.pixel(x, y);
      const glm::dvec4 by_reference = levels_of({found.mix, found.mix}, view.blend, 1);
      bool asked = false;
      glm::dvec4 exact;
      for (const Drawn& d : drawn) {
        const glm::dvec4 levels = drawn_levels(d.image, x, y);
        // Encoding linear light is steepest, 12.92, in the dark.
        const double may_be_off =
            found.bound * (view.blend == Blend::linear ? 12.92 : 1.0) * d.top / d.allowed;
        const double beside = apart(levels, double(d.top) * by_reference, d.top) / d.allowed;
        if (beside <= kSure) continue;
        if (!asked) exact = truth.levels(x, y, 1), ++tally.asked, asked = true;
        const double off = apart(levels, double(d.top) * exact, d.top) / d.allowed;
        // What is thinner than the truth's lines may fall between them; the reference sees it.
        if (off > 1.0 && beside <= 1.0) ++tally.disputed;
        const double sure = std::min(off, beside - may_be_off);
        tally.worst = std::max(tally.worst, sure);
        if (sure <= 1.0) continue;
        ++tally.over;
        tally.where =
            fmt::format("({}, {}) of {} px, {} {}: {:.2f} of what is allowed", x, y, view.width,
                        view.blend == Blend::linear ? "linear" : "srgb", d.top, sure);
      }
    }
}

}  // namespace

bool fuzzed_scene(std::string_view kind, std::uint64_t seed, Scene& scene) {
  constexpr double kJitters[] = {1e-13, 1e-6, 1e-3};
  if (kind == "lattice")
    scene = degenerate_scene(seed, 0.0);
  else if (kind == "jittered")
    scene = degenerate_scene(seed, kJitters[seed % 3]);
  else if (kind == "generic")
    scene = random_plain_scene(seed);
  else if (kind == "huge")
    scene = huge_scene(seed);
  else if (kind == "strokes")
    scene = stroke_scene(seed);
  else if (kind == "painted")
    scene = random_painted_scene(seed);
  else if (kind == "mixed")
    scene = mixed_scene(seed % 2 ? random_painted_scene(seed) : degenerate_scene(seed, 1e-6), seed);
  else
    return false;
  return true;
}

void judge_fuzzed(const Scene& scene, int side, FuzzTally& tally, std::optional<Blend> only) {
  View view{.width = side, .height = side, .dither = false};
  ++tally.scenes;
  for (const Blend blend : {Blend::srgb, Blend::linear}) {
    if (only.value_or(blend) != blend) continue;
    view.blend = blend;
    judge_blend(scene, view, ExactTruth(scene, view), tally);
  }
}

}  // namespace mien::test
