#include "bench/whole/thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "bench/whole/frame_drawer.h"

namespace mien::bench {
namespace {

constexpr int kCount = 1000;
constexpr int kWidth = 128, kHeight = 72;
constexpr int kRounds = 5;  // at most, without --rounds
constexpr unsigned kSeed = 1;

const FrameCase kThumbnail{'C', "toon", {}, true, kWidth, kHeight};

/// A number in lo … hi, the same on every machine.
double number(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * double(random()) / 4294967296.0;
}

/// A face looking somewhere, turned a little, glad, sad or neither.
std::vector<Pose> poses(const Face& face) {
  std::mt19937 random(kSeed);
  std::vector<Pose> made(kCount);
  const auto set = [&](Pose& pose, const char* name, double value) {
    pose.settings.push_back(*read_setting(face, fmt::format("{}={:.6f}", name, value)));
  };
  for (Pose& pose : made) {
    set(pose, "gaze.x", number(random, -0.06, 0.06));
    set(pose, "gaze.y", number(random, -0.04, 0.04));
    set(pose, "yaw", number(random, -15, 15));
    set(pose, "blink", number(random, 0, 0.5));
    const double mood = number(random, -1, 1);
    set(pose, mood < 0 ? "emotion.sadness" : "emotion.joy", std::abs(mood));
  }
  return made;
}

using Drawers = std::vector<std::unique_ptr<FrameDrawer>>;

/// Every drawer on a thread of its own; each takes the next pose that nobody has.
void draw_all(const Drawers& drawers, const Face& face, const std::vector<Pose>& at) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> threads;
  for (const auto& drawer : drawers)
    threads.emplace_back([&] {
      for (std::size_t i; (i = next++) < at.size();) drawer->frame(face, at[i]);
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace

void thumbnails(const Options& options) {
  const Subject subject(kThumbnail);
  const Face face = subject.face(0);
  const std::vector<Pose> at = poses(face);
  const int threads =
      options.threads ? options.threads : int(std::max(1u, std::thread::hardware_concurrency()));
  Drawers drawers;
  for (int i = 0; i < threads; ++i)
    drawers.push_back(std::make_unique<FrameDrawer>(kThumbnail, subject, 1));
  std::vector<double> times;
  const double end = now_ms() + 1000 * options.seconds;
  const int rounds = options.rounds ? options.rounds : kRounds;
  for (int i = 0; i < rounds && (i == 0 || options.rounds || now_ms() < end); ++i)
    times.push_back(ms_of([&] { draw_all(drawers, face, at); }));
  const double seconds = median(times) / 1000;
  if (options.json)
    fmt::print(
        "{{\"thumbnails\": {}, \"width\": {}, \"height\": {}, \"threads\": {}, \"seconds\": "
        "{:.5f}, \"seed\": {}}}\n",
        kCount, kWidth, kHeight, threads, seconds, kSeed);
  else
    fmt::print("{} thumbnails of toon, {} x {}, poses of seed {}, {} threads: {:.3f} s\n", kCount,
               kWidth, kHeight, kSeed, threads, seconds);
}

}  // namespace mien::bench
