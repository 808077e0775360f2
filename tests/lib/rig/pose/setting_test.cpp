#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::face_at;
using test::sample_face;
using test::slice_of;

TEST(SettableNames, AllGoThereAndBack) {
  for (const char* name : {"seed0", "toon", "male"}) {
    const Face face = sample_face(name);
    bool slices_begun = false;
    for (const SettableName& settable : settable_names(face)) {
      slices_begun |= !settable.control;
      EXPECT_EQ(settable.control, !slices_begun) << "controls first";
      EXPECT_FALSE(settable.unit.empty()) << settable.name;
      std::string text = settable.name + "=";
      for (std::size_t i = 0; i < settable.value.size(); ++i) {
        char number[40];
        std::snprintf(number, sizeof number, "%s%.17g", i ? "," : "", settable.value[i]);
        text += number;
      }
      const Expected<Setting> setting = read_setting(face, text);
      ASSERT_TRUE(setting) << sentence(setting.error());
      EXPECT_EQ(setting->values, settable.value);
      EXPECT_EQ(pose_face(face, {.settings = {*setting}}).vector, face.vector) << text;
    }
  }
}

TEST(SettableNames, HaveTheControlsOfBothSidesAndOfEach) {
  for (const char* name : {"seed0", "toon"}) {
    std::vector<std::string> controls;
    const Face face = sample_face(name);
    for (const SettableName& settable : settable_names(face))
      if (settable.control && !settable.pose && settable.unit != "strength")  // of an expression
        controls.push_back(settable.name);
    std::vector<std::string> wanted{
        "gaze.x",   "gaze.left.x",   "gaze.right.x",   "gaze.y", "gaze.left.y", "gaze.right.y",
        "dilation", "dilation.left", "dilation.right", "blink",  "blink.left",  "blink.right"};
    if (name == std::string("toon"))
      wanted.insert(wanted.end(), {"bias", "bias.left", "bias.right", "yaw", "pitch", "roll"});
    EXPECT_EQ(controls, wanted);
  }
}

TEST(ReadSetting, TakesColoursAndSingleNumbers) {
  const Face seed = sample_face("seed0");
  EXPECT_EQ(slice_of(face_at(seed, {"palette/skin=#ffffff"}), "palette/skin"),
            (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(slice_of(face_at(seed, {"palette/skin=0.25,0.5,1"}), "palette/skin"),
            (std::vector<double>{0.25, 0.5, 1, 1}));
  EXPECT_EQ(slice_of(face_at(seed, {"palette/skin=0.25,0.5,1,0"}), "palette/skin"),
            (std::vector<double>{0.25, 0.5, 1, 0}));
  EXPECT_EQ(slice_of(face_at(seed, {"palette/white/a=0.5"}), "palette/white"),
            (std::vector<double>{1, 1, 1, 0.5}));
  EXPECT_EQ(slice_of(face_at(seed, {"pupil.left/center/y=+.25"}), "pupil.left/center"),
            (std::vector<double>{0.76, 0.25}));
}

TEST(ReadSetting, RefusesInASentence) {
  const Face seed = sample_face("seed0");
  const std::pair<const char*, const char*> table[] = {
      {"gaze.z=1", "gaze.z=1: no control or number named \"gaze.z\"; did you mean \"gaze.x\"?"},
      {"pupil.left/centre=1,2",
       "pupil.left/centre=1,2: no control or number named \"pupil.left/centre\"; did you mean "
       "\"pupil.left/center\"?"},
      {"blink", "blink: expected NAME=VALUE"},
      {"", ": expected NAME=VALUE"},
      {"blink=", "blink=: expected a number, got \"\""},
      {"blink=1x", "blink=1x: expected a number, got \"1x\""},
      {"blink=nan", "blink=nan: expected a finite number, got \"nan\""},
      {"blink=inf", "blink=inf: expected a finite number, got \"inf\""},
      {"pupil.left/center=1e999,0",
       "pupil.left/center=1e999,0: \"1e999\" is too large or too small for a number"},
      {"blink=2", "blink=2: \"blink\" goes from 0 to 1, got 2"},
      {"blink=0,1", "blink=0,1: expected 1 number, got 2"},
      {"pupil.left/center=1", "pupil.left/center=1: expected 2 numbers, got 1"},
      {"upper_lid.left/half_width=-1",
       "upper_lid.left/half_width=-1: \"upper_lid.left/half_width\" goes from 0 to 1000000000, got "
       "-1"},
      {"pupil.left/center=2e9,0",
       "pupil.left/center=2e9,0: \"pupil.left/center\" goes from -1000000000 to 1000000000, got "
       "2000000000"},
      {"palette/skin=red", "palette/skin=red: expected a colour like #rrggbb, got \"red\""},
      {"palette/skin=#12345",
       "palette/skin=#12345: expected a colour like #rrggbb, got \"#12345\""},
      {"blink=#ffffff", "blink=#ffffff: expected a number, got \"#ffffff\""},
  };
  for (const auto& [text, expected] : table) {
    const Expected<Setting> setting = read_setting(seed, text);
    ASSERT_FALSE(setting) << text;
    const std::string said = sentence(setting.error());
    EXPECT_EQ(said, *text ? expected : expected + 2) << text;
  }
}

std::string said(const auto& read) {
  return read ? "read" : sentence(read.error());
}

TEST(Names, ThatAreUnknownGetTheNearest) {
  const Face toon = sample_face("toon");
  EXPECT_EQ(said(read_pose(toon, "brow.angyr=1")),
            "brow.angyr=1: no pose named \"brow.angyr\"; did you mean \"brow.angry\"?");
  EXPECT_EQ(said(read_pose(toon, "blink=1")), "blink=1: no pose named \"blink\"");
  EXPECT_EQ(said(read_pose(toon, "brow.angry=1.5")),
            "brow.angry=1.5: \"brow.angry\" goes from 0 to 1, got 1.5");
  EXPECT_EQ(said(read_clip_layer(toon, "idel")),
            "idel: no clip named \"idel\"; did you mean \"idle\"?");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=x")), "idle=x: expected a number, got \"x\"");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=1@")), "idle=1@: expected a number, got \"\"");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=1@2,3")),
            "idle=1@2,3: expected a number, got \"2,3\"");
  EXPECT_EQ(said(read_look_at(toon, "1,2")), "1,2: expected 3 numbers X,Y,Z, got 2");
  EXPECT_EQ(said(read_look_at(sample_face("male"), "1,2,3")),
            "1,2,3: this face has no eyes that look: its file says none under \"eyes\"");
  EXPECT_EQ(read_pose(toon, "lid.sad")->values, (std::vector<double>{1}));
}

}  // namespace
}  // namespace mien
