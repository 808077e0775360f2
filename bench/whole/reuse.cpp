#include "bench/whole/reuse.h"

#include <fmt/format.h>

#include "bench/whole/frame_drawer.h"

namespace mien::bench {
namespace {

constexpr int kWarmUp = 2;  // rounds

}  // namespace

void reuse(const Options& options, const FrameCase& c) {
  const Subject subject(c);
  FrameDrawer drawer(c, subject, options.threads);
  std::vector<double> cold, same, eyes;
  const Rounds rounds(options.rounds, options.seconds, drawer.pixel_count());
  for (int i = -kWarmUp; rounds.go_on(i); ++i) {
    const Face face = subject.face(i + kWarmUp);
    const double first = drawer.frame(face, subject.pose());
    const double again = drawer.frame(face, subject.pose());
    const double moved = subject.has_gaze() ? drawer.frame(face, subject.pose(i + kWarmUp + 1)) : 0;
    if (i < 0) continue;
    cold.push_back(first), same.push_back(again), eyes.push_back(moved);
  }
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"cold_ms\": {:.5f}, "
        "\"same_ms\": {:.5f}, \"eyes_ms\": {}, \"face\": \"{}\", \"rounds\": {}}}\n",
        c.scene, c.width, c.height, options.threads, median(cold), median(same),
        json_number(median(eyes)), c.face, cold.size());
  } else {
    fmt::print("{} {:>6} x {:<6}{:10.4f}{:>14}{:>14}\n", c.scene, c.width, c.height, median(cold),
               ratio_text(median(same), median(cold)), ratio_text(median(eyes), median(cold)));
  }
}

std::string reuse_head() {
  return fmt::format("{:17}{:>10}{:>14}{:>14}\n", "scene, pixels", "cold ms", "same/cold",
                     "eyes/cold");
}

}  // namespace mien::bench
