#include "bench/whole/reuse.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/whole/frame_drawer.h"

namespace mien::bench {
namespace {

constexpr int kWarmUp = 4;  // rounds: until rows are kept

/// A control at a place of its own in every step; none where the face has no such control.
class Mover {
 public:
  Mover(const Face& face, std::vector<const char*> controls, double middle, double reach)
      : middle_(middle), reach_(reach) {
    for (const char* name : controls)
      if (const auto setting = read_setting(face, fmt::format("{}=0", name)))
        settings_.push_back(*setting);
  }

  bool moves() const { return !settings_.empty(); }
  Pose at(int step) const {
    Pose pose;
    double turn = 0.1 * step;  // at 60 frames a second about once around
    for (Setting setting : settings_) {
      setting.values[0] = middle_ + reach_ * std::sin(turn);
      pose.settings.push_back(setting);
      turn *= 0.6;
    }
    return pose;
  }

 private:
  std::vector<Setting> settings_;
  double middle_, reach_;
};

}  // namespace

/// Each kind of frame has a renderer of its own, and follows upon its like: several in a row, so that
/// caches hold what they hold in a program that draws nothing else. The last of them counts.
void reuse(const Options& options, const FrameCase& c) {
  constexpr int kInARow = 3;
  const Subject subject(c);
  const Face still = subject.face(0);
  const Mover eyes(still, {"gaze.x", "gaze.y"}, 0.0, 0.03), lids(still, {"blink"}, 0.5, 0.4);
  FrameDrawer cold(c, subject, options.threads), cold_lids(c, subject, options.threads),
      same(c, subject, options.threads), looks(c, subject, options.threads),
      blinks(c, subject, options.threads);
  std::vector<double> colds, sames, moved, shut_colds, shut;
  int step = 0;
  const auto take = [&](std::vector<double>& to, int round, const auto& frame) {
    double last = 0;
    for (int i = 0; i < kInARow; ++i) last = frame(step + i);
    if (round >= 0) to.push_back(last);
  };
  const Rounds rounds(options.rounds, options.seconds, cold.pixel_count());
  for (int i = -kWarmUp; rounds.go_on(i); ++i, step += kInARow) {
    take(colds, i, [&](int k) { return cold.frame(subject.face(k), eyes.at(k)); });
    take(sames, i, [&](int) { return same.frame(still, eyes.at(1)); });
    if (eyes.moves()) take(moved, i, [&](int k) { return looks.frame(still, eyes.at(k)); });
    if (!lids.moves()) continue;
    take(shut_colds, i, [&](int k) { return cold_lids.frame(subject.face(k), lids.at(k)); });
    take(shut, i, [&](int k) { return blinks.frame(still, lids.at(k)); });
  }
  const double full = median(colds), full_shut = median(shut_colds);
  if (options.json) {
    fmt::print(
        "{{\"scene\": \"{}\", \"width\": {}, \"height\": {}, \"threads\": {}, \"cold_ms\": {:.5f}, "
        "\"same_ms\": {:.5f}, \"eyes_ms\": {}, \"cold_lids_ms\": {}, \"lids_ms\": {}, \"face\": "
        "\"{}\", \"rounds\": {}}}\n",
        c.scene, c.width, c.height, options.threads, full, median(sames),
        json_number(median(moved)), json_number(full_shut), json_number(median(shut)), c.face,
        colds.size());
  } else {
    fmt::print("{} {:>6} x {:<6}{:10.4f}{:>14}{:>14}{:>14}\n", c.scene, c.width, c.height, full,
               ratio_text(median(sames), full), ratio_text(median(moved), full),
               ratio_text(median(shut), full_shut));
  }
}

std::string reuse_head() {
  return fmt::format("{:17}{:>10}{:>14}{:>14}{:>14}\n", "scene, pixels", "cold ms", "same/cold",
                     "eyes/cold", "lids/cold");
}

}  // namespace mien::bench
