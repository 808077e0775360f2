#include "lib/rig/pose/running_motions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace mien {
namespace {

std::string running(const FaceModel& model, const Pose& pose) {
  std::string names;
  for_each_motion(model, pose, [&](const Motion& motion, double, double) { names += motion.name; });
  return names;
}

TEST(RunningMotions, AreThoseAskedForOrTheDefaultClip) {
  FaceModel model;
  model.clips = {{.name = "a"}, {.name = "b"}};
  model.default_clip = {0};
  const auto take = std::make_shared<const Motion>(Motion{.name = "t", .settled = true});
  EXPECT_EQ(running(model, {}), "") << "no time";
  EXPECT_EQ(running(model, {.time = NAN}), "");
  EXPECT_EQ(running(model, {.time = 0}), "a");
  EXPECT_EQ(running(model, {.time = 0, .motions = {{.clip = {1}}, {.motion = take}}}), "bt");
  EXPECT_EQ(
      running(model, {.time = 0, .motions = {{.clip = {7}}, {}, {.motion = take, .weight = NAN}}}),
      "");
  EXPECT_EQ(
      running(model, {.time = 0, .motions = {{.clip = {1}}, {.motion = take}}, .liveliness = 0}),
      "t");
}

}  // namespace
}  // namespace mien
