#include "bench/whole/modes.h"

#include <fmt/format.h>

#include "bench/whole/frame_drawer.h"

namespace mien::bench {
namespace {

constexpr int kWarmUp = 2;  // rounds

const char* blend_word(Blend blend) {
  return blend == Blend::linear ? "linear" : "srgb";
}

const char* depth_word(Depth depth) {
  return depth == Depth::u8 ? "8" : depth == Depth::u16 ? "16" : "float";
}

}  // namespace

void beside_encoded(const Options& options, const FrameCase& c) {
  const Subject subject(c);
  FrameDrawer mode(c, subject, options.threads, options.blend, options.depth);
  FrameDrawer encoded(c, subject, options.threads);
  std::vector<double> modes, encodeds;
  const Rounds rounds(options.rounds, options.seconds, mode.pixel_count());
  for (int i = -kWarmUp; rounds.go_on(i); ++i) {
    const Face face = subject.face(i + kWarmUp);
    const double m = mode.frame(face, subject.pose());
    const double e = encoded.frame(face, subject.pose());
    if (i >= 0) modes.push_back(m), encodeds.push_back(e);
  }
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"blend\": \"{}\", "
        "\"depth\": \"{}\", \"frame_ms\": {:.5f}, \"encoded_ms\": {:.5f}, \"face\": \"{}\", "
        "\"rounds\": {}}}\n",
        c.scene, c.width, c.height, options.threads, blend_word(options.blend),
        depth_word(options.depth), median(modes), median(encodeds), c.face, modes.size());
  } else {
    fmt::print("{} {:>6} x {:<6}{:16.4f}{:16.4f}{:>10}\n", c.scene, c.width, c.height,
               median(modes), median(encodeds), ratio_text(median(modes), median(encodeds)));
  }
}

std::string beside_encoded_head(const Options& options) {
  const std::string mode =
      fmt::format("{} {} ms", blend_word(options.blend), depth_word(options.depth));
  return fmt::format("{:17}{:>16}{:>16}{:>10}\n", "scene, pixels", mode, "srgb 8 ms", "ratio");
}

}  // namespace mien::bench
