#include "lib/rig/pose/expression_setting.h"

#include <mien/face_model.h>
#include "lib/face/standard_names.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

std::string said(std::string_view set, std::string_view text, OutOfRange out = OutOfRange::refuse) {
  const Face face = test::face_named("male");
  const auto setting = read_expression(face, set, text, out);
  if (!setting) return sentence(setting.error());
  return std::string(face.model->controls[std::size_t(setting->index)].name) + " " +
         std::to_string(setting->values[0]).substr(0, 4);
}

TEST(ExpressionSetting, ReadsEmotionsMusclesAndStandardNames) {  // M7, M10
  EXPECT_EQ(said("emotion", "joy=0.8"), "emotion.joy 0.80");
  EXPECT_EQ(said("emotion", "left.joy=0.4"), "emotion.left.joy 0.40");
  EXPECT_EQ(said("muscle", "zygomaticus"), "muscle.zygomaticus 1.00");
  EXPECT_EQ(said("arkit", "jawOpen=+.5"), "arkit.jawOpen 0.50");
}

TEST(ExpressionSetting, NamesTheNearest) {
  EXPECT_EQ(said("emotion", "joi=1"), "joi=1: no emotion named \"joi\"; did you mean \"joy\"?");
  EXPECT_EQ(said("muscle", "zygomatcus=1"),
            "zygomatcus=1: no muscle named \"zygomatcus\"; did you mean \"zygomaticus\"?");
  EXPECT_EQ(said("arkit", "jawOpn=1"),
            "jawOpn=1: no arkit name named \"jawOpn\"; did you mean \"jawOpen\"?");
  EXPECT_EQ(said("mood", "x=1"), "x=1: no set named \"mood\"; did you mean \"emotion\"?");
  const Face bruno = test::face_named("bruno"), seed = test::face_named("seed0");
  EXPECT_EQ(sentence(read_expression(bruno, "muscle", "left.jaw=1").error()),
            "left.jaw=1: \"jaw\" has no left and right: it is one");
  EXPECT_EQ(sentence(read_expression(seed, "emotion", "joy").error()),
            "joy: this face has no emotions");
  EXPECT_EQ(sentence(read_expression(seed, "arkit", "jawOpen").error()),
            "jawOpen: this face has no table of arkit names");
}

/// Names of points off the axis that differ between two poses of a face.
std::vector<std::string> moved_points(const Face& before, const Face& after) {
  const double axis = 0.5 * before.model->canvas.twice_axis();
  std::vector<std::string> names;
  for (const Slice& slice : before.model->layout.slices()) {
    if (slice.kind != SliceKind::point) continue;
    const auto i = std::size_t(slice.begin);
    if (before.vector[i] != axis &&
        (before.vector[i] != after.vector[i] || before.vector[i + 1] != after.vector[i + 1]))
      names.emplace_back(slice.name);
  }
  return names;
}

/// "Left" is the subject's own: on the right of a picture that faces us, x beyond the axis.
TEST(ExpressionSetting, LeftIsTheSubjectsLeft) {  // M10
  int moved = 0;
  for (const char* name : {"male", "bruno", "toon"}) {
    const Face face = test::face_named(name);
    const double axis = 0.5 * face.model->canvas.twice_axis();
    for (const std::string_view standard : standard_names("arkit")) {
      std::string part{standard};
      const bool left = part.ends_with("Left");
      if (!left && !part.ends_with("Right")) continue;
      if (part.starts_with("jaw") || part == "mouthLeft" || part == "mouthRight") continue;
      if (std::string_view{name} == "toon" && part.starts_with("mouth")) continue;  // has one mouth
      const Face posed = test::posed(face, {"arkit." + part + "=1"});
      for (const std::string& point : moved_points(face, posed)) {
        if (point.find(".left/") == point.find(".right/")) continue;  // of the middle
        EXPECT_NE(point.find(left ? ".left/" : ".right/"), std::string::npos)
            << name << " " << part << " moves " << point;
        const int slice = face.model->layout.find(point);
        const double x = face.vector[std::size_t(face.model->layout[slice].begin)];
        if (!point.starts_with("frown_fold") && !point.starts_with("opening")) {
          EXPECT_EQ(x > axis, left) << name << " " << point;
        }
        ++moved;
      }
    }
  }
  EXPECT_GT(moved, 150);
}

/// Looking left is looking to the picture's right, with both eyes; out and in are each eye's own.
TEST(ExpressionSetting, LooksToTheSubjectsLeft) {  // E8
  for (const char* name : {"bruno", "toon"}) {
    const Face face = test::face_named(name);
    const auto way = [&](const std::string& setting, const char* side) {
      const int slice = face.model->layout.find(std::string("limbus.") + side + "/center");
      const auto i = std::size_t(face.model->layout[slice].begin);
      return test::posed(face, {setting}).vector[i] - face.vector[i];
    };
    for (const char* side : {"left", "right"}) {
      EXPECT_GT(way("vrm.lookLeft=1", side), 0.05) << name;
      EXPECT_LT(way("vrm.lookRight=1", side), -0.05) << name;
      EXPECT_GT(way("facs.AU61=1", side), 0.05) << name;
    }
    EXPECT_GT(way("arkit.eyeLookOutLeft=1", "left"), 0.05) << name;
    EXPECT_LT(way("arkit.eyeLookInLeft=1", "left"), -0.05) << name;
    EXPECT_LT(way("arkit.eyeLookOutRight=1", "right"), -0.05) << name;
    EXPECT_EQ(way("arkit.eyeLookOutRight=1", "left"), 0) << name;
  }
}

/// All six feelings, the 52 blend shapes, presets and visemes, in every face that can feel.
TEST(ExpressionSetting, EveryFeelingFaceKnowsTheStandardNames) {  // M10
  for (const char* name : {"male", "bruno", "toon"}) {
    const Face face = test::face_named(name);
    for (const char* emotion : {"joy", "sadness", "anger", "disgust", "fear", "surprise"}) {
      EXPECT_TRUE(read_expression(face, "emotion", emotion)) << name << " " << emotion;
      EXPECT_NE(test::posed(face, {fmt::format("emotion.{}=1", emotion)}).vector, face.vector);
    }
    for (const char* set : {"arkit", "viseme"})
      for (const std::string_view standard : standard_names(set))
        EXPECT_TRUE(read_expression(face, set, standard)) << name << " " << standard;
    for (const char* set : {"facs", "vrm"})
      for (const std::string_view standard : standard_names(set))
        EXPECT_TRUE(read_expression(face, set, standard)) << name << " " << standard;
    EXPECT_EQ(test::posed(face, {"facs.left.AU01_r=1"}).vector,
              test::posed(face, {"facs.left.AU1=1"}).vector)
        << name;
    EXPECT_TRUE(read_expression(face, "facs", "au01")) << name;
    EXPECT_TRUE(read_expression(face, "facs", "AU12=0.5")) << name;
    EXPECT_TRUE(read_expression(face, "vrm", "happy=0.5")) << name;
  }
}

TEST(ExpressionSetting, RefusesOrClampsWhatIsOutOfRange) {  // M7
  EXPECT_EQ(said("emotion", "joy=1.5"), "joy=1.5: \"joy\" goes from 0 to 1, got 1.5");
  EXPECT_EQ(said("emotion", "joy=1.5", OutOfRange::clamp), "emotion.joy 1.00");
  EXPECT_EQ(said("muscle", "jaw=-2", OutOfRange::clamp), "muscle.jaw 0.00");
  EXPECT_EQ(said("muscle", "jaw=nan", OutOfRange::clamp),
            "jaw=nan: expected a finite number, got \"nan\"");
  EXPECT_EQ(said("muscle", "jaw=1x"), "jaw=1x: expected a finite number, got \"1x\"");
}

}  // namespace
}  // namespace mien
