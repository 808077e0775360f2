#include <mien/composed_face.h>
#include <mien/face_model.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/rig/pose/expression_setting.h"

namespace mien {
namespace {

TEST(ComposedFace, HasAllEmotionsAndExpressions) {
  for (int i = 0; i < 20; ++i) {
    const Face face = face_from_recipe(recipe_from_seed(seed_from_word(std::to_string(i)))).value();
    for (const char* feeling : {"joy", "sadness", "anger", "fear", "disgust", "surprise"})
      EXPECT_TRUE(read_expression(face, "emotion", feeling, OutOfRange::refuse)) << feeling;
    EXPECT_TRUE(read_expression(face, "arkit", "jawOpen=1", OutOfRange::refuse));
    EXPECT_EQ(face.model->muscles.muscles.size(), 31u);
  }
}

/// What is beside a point that muscles move, moves with it.
TEST(ComposedFace, PartsRide) {
  Recipe recipe = recipe_from_seed(5);
  recipe.parts["beard"] = "full", recipe.parts["moustache"] = "chevron";
  const Face face = face_from_recipe(recipe).value();
  Pose pose;
  pose.settings.push_back(read_expression(face, "muscle", "jaw=1", OutOfRange::refuse).value());
  Poser poser(face);
  const Face& posed = poser.pose(pose);
  const auto fall = [&](std::string_view name) {
    const int slice = face.model->layout.find(name);
    EXPECT_GE(slice, 0) << name;
    const std::size_t y = std::size_t(face.model->layout[slice].begin) + 1;
    return face.vector[y] - posed.vector[y];
  };
  const double chin = fall("head/points/5");
  EXPECT_GT(chin, 0.03);
  double most = 0;
  for (const Slice& slice : face.model->layout.slices())
    if (slice.kind == SliceKind::point && slice.name.starts_with("beard/points"))
      most = std::max(most, fall(slice.name));
  EXPECT_NEAR(most, chin, 1e-3);
  EXPECT_GT(fall("moustache.left/spine/2"), 0.02);
}

TEST(ComposedFace, WrongCodesAreSentences) {
  EXPECT_NE(face_from_code("Z0000").error().what.find("signs"), std::string::npos);
  EXPECT_FALSE(face_from_code(""));
}

}  // namespace
}  // namespace mien
