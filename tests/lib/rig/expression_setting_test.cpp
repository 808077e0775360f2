#include <mien/lib/rig/expression_setting.h>

#include <mien/lib/face/face_model.h>

#include <gtest/gtest.h>

#include "tests/support/faces.h"

namespace mien {
namespace {

std::string said(std::string_view set, std::string_view text, OutOfRange out = OutOfRange::refuse) {
  const Face face = test::face_named("male");
  const auto setting = read_expression(face, set, text, out);
  if (!setting) return sentence(setting.error());
  return face.model->controls[std::size_t(setting->index)].name + " " +
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
  EXPECT_EQ(said("mood", "x=1"), "x=1: this face has no set \"mood\"");
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
