#include "lib/file/motion/take_names.h"

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

std::string channel(std::string_view name) {
  const auto targets = take_targets(name);
  return targets.empty() ? "" : targets[0].channel;
}

TEST(TakeNames, AreReadInEverySpelling) {
  for (const char* name : {"EyeBlinkLeft", "eyeBlink_L", "eyeBlink.l", "eyeblinkleft"})
    EXPECT_EQ(channel(name), "arkit.eyeBlinkLeft") << name;
  EXPECT_EQ(channel("viseme_PP"), "viseme.PP");
  EXPECT_EQ(channel("ih"), "viseme.I");
  EXPECT_EQ(channel("AU01_r"), "facs.AU1");
  EXPECT_EQ(channel("vrm.joy"), "vrm.happy");
  EXPECT_EQ(channel("emotion.joy"), "emotion.joy");
  EXPECT_EQ(channel("HeadYaw"), "yaw");
  for (const char* name : {"", "pose_Tx", "x_0", "vrm.", "foo.bar", "_neutral", "LeftEyeYaw"})
    EXPECT_EQ(channel(name), "") << name;
}

TEST(TakeNames, HaveUnits) {
  EXPECT_EQ(take_targets("AU12_r")[0].factor, 0.2);
  EXPECT_EQ(take_targets("AU12_c")[0].factor, 1);
  EXPECT_EQ(take_targets("HeadPitch")[0].unit, TakeUnit::degrees);
  EXPECT_LT(take_targets("HeadPitch")[0].factor, 0);
  EXPECT_EQ(take_targets("gaze_angle_x").size(), 2u) << "left and right are two action units";
}

TEST(TakeNames, KnowWhatStandsBesideTheFace) {
  for (const char* name :
       {"BlendShapeCount", "frame", "face_id", "_neutral", "LeftEyeYaw", "headYaw"})
    EXPECT_TRUE(is_beside_the_face(name)) << name;
  EXPECT_FALSE(is_beside_the_face("jawOpen"));
  EXPECT_TRUE(is_turn_of_head_or_eye("HeadRoll"));
  EXPECT_FALSE(is_turn_of_head_or_eye("frame"));
}

}  // namespace
}  // namespace mien
