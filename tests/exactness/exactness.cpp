// mien_exactness: how exact the pictures of the sample faces are, pixel by pixel.
#include <mien/scene_from_face.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "tests/exactness/arguments.h"
#include "tests/support/exact/exact_truth.h"
#include "tests/support/exact/exact_windows.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/sample_poses.h"

namespace mien::test {
namespace {

constexpr int kSizes[] = {48, 97, 333, 640, 1920};
constexpr int kLargestWhole = 333;  // [px] wide: larger pictures take hours
constexpr int kWindow = 16;         // [px]
constexpr int kEachRelief = 6;      // windows
constexpr int kClearSize = 48;      // [px] drawn without a background, too

/// One scene at one size.
struct Combination {
  std::string face, pose;
  int size;
  bool clear;  ///< over a transparent background
};

bool asked_for(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

std::vector<Combination> combinations(const ExactnessArguments& asked) {
  std::vector<int> sizes = asked.sizes;
  if (sizes.empty()) sizes.assign(std::begin(kSizes), std::end(kSizes));
  std::vector<Combination> list;
  for (const int size : sizes)
    for (const std::string face : kSampleFaces) {
      if (!asked_for(asked.faces, face)) continue;
      for (const NamedPose& pose : sample_poses(face_named(face)))
        if (asked_for(asked.poses, pose.name))
          for (const bool clear : {false, true})
            if (!clear || size == kClearSize) list.push_back({face, pose.name, size, clear});
    }
  return list;
}

Scene scene_of(const Combination& c) {
  const Face face = face_named(c.face);
  const std::vector<NamedPose> poses = sample_poses(face);
  return scene_from_face(pose_face(face, std::ranges::find(poses, c.pose, &NamedPose::name)->pose));
}

Tallies judge(const Combination& c, const ExactnessArguments& asked) {
  const Scene scene = scene_of(c);
  const glm::dvec2 canvas = scene.canvas().box.size();
  View view{.width = c.size,
            .height = std::max(kWindow, int(std::lround(c.size * canvas.y / canvas.x))),
            .dither = false};
  if (c.clear) view.background = Color{0, 0, 0, 0};
  const ExactTruth truth(scene, view, ExactTruth::kLit);
  const Choice choice = [&](int x, int y) {
    return (x + 7 * y + int(asked.seed)) % asked.every == 0 && (asked.lit || !truth.lit(x, y));
  };
  std::vector<PixelRect> windows{{0, 0, view.width, view.height}};
  if (c.size > kLargestWhole)
    windows = windows_of(scene, view, kWindow, asked.windows, kEachRelief, asked.seed);
  Tallies tallies;
  for (const PixelRect& window : windows)
    judge_window(scene, view, window, truth, asked.storages, choice, tallies);
  return tallies;
}

/// One line for each storage; whether all is within what is allowed.
bool print(int number, const Combination& c, const ExactnessArguments& asked,
           const Tallies& tallies, double seconds) {
  bool right = true;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Tally& tally = tallies[i];
    if (!asked.storages[i]) continue;
    right &= tally.over == 0;
    fmt::print("{:4} {:6} {:12} {:5} {:7} {:10} {:8} {:9.2f} {:6}  {}\n", number, c.face, c.pose,
               c.size, c.clear ? "clear" : "opaque", kStorages[i].name, tally.judged, tally.worst,
               tally.over, tally.where);
  }
  fmt::print("     {:.0f} s\n", seconds);
  std::fflush(stdout);
  return right;
}

int run(const ExactnessArguments& asked) {
  const std::vector<Combination> list = combinations(asked);
  if (list.empty()) {
    fmt::print(stderr, "no sample face has such a pose\n{}", kExactnessUse);
    return 2;
  }
  fmt::print("{:>4} {:6} {:12} {:>5} {:7} {:10} {:>8} {:>9} {:>6}  {}\n", "", "face", "pose",
             "size", "ground", "stored", "pixels", "worst", "over", "where");
  bool right = true;
  long judged = 0, over = 0;
  double worst[2] = {};  // of 255, and of 65535
  for (int i = asked.first - 1; i < int(list.size()); ++i) {
    if (i % asked.processes != asked.process) continue;
    const auto begin = std::chrono::steady_clock::now();
    const Tallies tallies = judge(list[std::size_t(i)], asked);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    right &= print(i + 1, list[std::size_t(i)], asked, tallies, took.count());
    for (std::size_t k = 0; k < tallies.size(); ++k) {
      judged += tallies[k].judged, over += tallies[k].over;
      double& of_depth = worst[kStorages[k].top > 255];
      of_depth = std::max(of_depth, tallies[k].worst);
    }
  }
  fmt::print("{} judged, {} over; worst {:.2f} of 255, {:.1f} of 65535\n", judged, over, worst[0],
             worst[1]);
  return right ? 0 : 1;
}

}  // namespace
}  // namespace mien::test

int main(int count, char** words) {
  try {
    const auto asked = mien::test::read_exactness_arguments(count, words);
    return asked ? mien::test::run(*asked) : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
