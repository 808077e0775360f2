#include <mien/poser.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/support/faces/posing.h"
#include "tests/support/process/allocations.h"

namespace mien {
namespace {

std::vector<Pose> some_poses(const Face& face) {
  std::vector<Pose> poses;
  for (const double time : {0.0, 0.9, -3.3, 1e6}) poses.push_back({.time = time});
  poses.push_back({});
  poses.push_back({.time = 2.2, .look_at = glm::dvec3{0.3, 0.2, 1}});
  for (const Control& control : face.model->controls) {
    const Channel& channel = control.channels[0].in(face.model->channels);
    const Expected<Setting> setting =
        read_setting(face, fmt::format("{}={}", control.name, channel.hi));
    poses.push_back({.time = 0.3, .settings = {*setting}});
    if (!face.model->clips.empty())
      poses.back().motions = {{.clip = {0}, .weight = 0.5, .begin = 0.2},
                              {.clip = {0}, .begin = -1}};
  }
  return poses;
}

TEST(Poser, PosesAsPoseFaceDoesWhateverCameBefore) {
  for (const char* name : {"toon", "seed0", "male"}) {
    const Face face = test::sample_face(name);
    const std::vector<Pose> poses = some_poses(face);
    Poser poser(face);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(poser.pose(poses[i]).vector, pose_face(face, poses[i]).vector) << name << " " << i;
      EXPECT_EQ(poser.pose(poses[i * 7 % poses.size()]).vector,
                pose_face(face, poses[i * 7 % poses.size()]).vector);
    }
  }
}

std::vector<int> kept;

TEST(Poser, AllocatesNothingAfterTheFirstPoses) {
  for (const char* name : {"toon", "seed0", "male"}) {
    const Face face = test::sample_face(name);
    const std::vector<Pose> poses = some_poses(face);
    Poser poser(face);
    for (const Pose& pose : poses) poser.pose(pose);
    const long before = test::allocations();
    for (const Pose& pose : poses) poser.pose(pose);
    EXPECT_EQ(test::allocations() - before, 0) << name;
  }
  const long before = test::allocations();
  std::vector<int>(std::size_t(before) % 7 + 1).swap(kept);
  if (test::kCountsAllocations) {
    EXPECT_GE(test::allocations() - before, 1) << "the counter counts";
  }
}

}  // namespace
}  // namespace mien
