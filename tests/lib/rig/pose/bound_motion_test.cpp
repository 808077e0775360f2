#include <mien/bound_motion.h>

#include <mien/face_model.h>
#include <mien/motion_file.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::sample_face;

Motion take() {
  return *read_motion_text(
      "time,jawOpen,eyeBlinkLeft,tongueOut,mouthPucker,HeadYaw\n0,0,0,0,0,0\n1,1,1,0,0.5,0.2\n");
}

TEST(BoundMotion, PosesAsItsNumbersSay) {
  const Face bruno = sample_face("bruno");
  const BoundMotion bound = bind_motion(take(), bruno);
  Poser poser(bruno);
  for (const double t : {0.25, 1.0, 0.5}) {
    Pose wanted = test::pose_of(bruno, {});
    const std::string half = std::to_string(t * 0.5),
                      yaw = std::to_string(t * -0.2 * 180 / 3.14159265358979);
    for (const std::string& text :
         {"arkit.jawOpen=" + std::to_string(t), "arkit.eyeBlinkLeft=" + std::to_string(t),
          "arkit.mouthPucker=" + half, "yaw=" + yaw})
      wanted.settings.push_back(*read_setting(bruno, text));
    const FaceVector by_settings = pose_face(bruno, wanted).vector;
    const FaceVector by_motion =
        poser.pose({.time = t, .motions = {{.motion = bound.motion}}}).vector;
    ASSERT_EQ(by_motion.size(), by_settings.size());
    for (std::size_t i = 0; i < by_motion.size(); ++i)
      ASSERT_NEAR(by_motion[i], by_settings[i], 1e-4) << "at once, without the law of muscles";
  }
}

TEST(BoundMotion, SaysWhatAFaceDoesNotFollow) {
  EXPECT_EQ(
      bind_motion(take(), sample_face("seed0")).unfollowed,
      (std::vector<std::string>{"arkit.jawOpen", "arkit.eyeBlinkLeft", "arkit.mouthPucker", "yaw"}))
      << "what stays at 0 is not missed";
  const BoundMotion male = bind_motion(take(), sample_face("male"));
  EXPECT_EQ(male.unfollowed, std::vector<std::string>{"yaw"});
}

TEST(BoundMotion, MissesNoSilence) {
  const Motion quiet = *read_motion_text("time,sil,PP\n0,1,0\n1,0,0\n");
  EXPECT_TRUE(bind_motion(quiet, sample_face("seed0")).unfollowed.empty());
}

TEST(BoundMotion, OfAnotherFaceDoesNothingBad) {
  const Face toon = sample_face("toon"), seed0 = sample_face("seed0");
  const BoundMotion bound = bind_motion(take(), toon);
  const Face posed = pose_face(seed0, {.time = 0.5, .motions = {{.motion = bound.motion}}});
  EXPECT_EQ(posed.vector.size(), seed0.vector.size());
}

TEST(BoundMotion, RunsWithoutLivelinessAndOverClips) {
  const Face bruno = sample_face("bruno");
  const BoundMotion bound = bind_motion(take(), bruno);
  const Pose still{.time = 1, .motions = {{.motion = bound.motion}}, .liveliness = 0};
  const Pose lively{.time = 1, .motions = {{.motion = bound.motion}}};
  EXPECT_EQ(pose_face(bruno, still).vector, pose_face(bruno, lively).vector);
  EXPECT_NE(pose_face(bruno, still).vector, bruno.vector);
  const Pose later{.time = 3, .motions = {{.motion = bound.motion, .begin = 2}}};
  EXPECT_EQ(pose_face(bruno, later).vector, pose_face(bruno, lively).vector);
  const Pose without{.motions = {{.motion = bound.motion}}};
  EXPECT_EQ(pose_face(bruno, without).vector, bruno.vector) << "no time, no motion";
}

TEST(BoundMotion, GivesSettingsOfAMoment) {
  const Face bruno = sample_face("bruno");
  const BoundMotion bound = bind_motion(take(), bruno);
  const Pose by_settings{.settings = settings_at(*bound.motion, 0.5)};
  const Pose by_motion{.time = 0.5, .motions = {{.motion = bound.motion}}};
  EXPECT_EQ(pose_face(bruno, by_settings).vector, pose_face(bruno, by_motion).vector);
}

}  // namespace
}  // namespace mien
