#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "lib/rig/pose/expression_setting.h"
#include "tests/support/process/allocations.h"

namespace mien {
namespace {

TEST(ComposedFace, HasAllEmotionsAndExpressions) {
  for (int i = 0; i < 20; ++i) {
    const Face face = face_from_recipe(recipe_from_seed(seed_from_word(std::to_string(i)))).value();
    for (const char* feeling : {"joy", "sadness", "anger", "fear", "disgust", "surprise"})
      EXPECT_TRUE(read_expression(face, "emotion", feeling, OutOfRange::refuse)) << feeling;
    EXPECT_TRUE(read_expression(face, "arkit", "jawOpen=1", OutOfRange::refuse));
    EXPECT_EQ(face.model->muscles.muscles.size(), 33u);
  }
}

/// What is beside a point that muscles move, moves with it.
TEST(ComposedFace, PartsRide) {
  Recipe recipe = recipe_from_seed(5);
  recipe.parts["beard"] = "full", recipe.parts["moustache"] = "chevron";
  recipe.numbers["chin"] = -0.71, recipe.numbers["mouth.y"] = 0;
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

/// Figures of docs/parts.md. Two of each person: what the library makes once is not the first one's.
TEST(ComposedFace, IsCheap) {
  if (!test::kCountsAllocations) GTEST_SKIP();
  constexpr long kMostAllocations = 3000, kMostBytes = 400'000;
  for (const FaceCode& person : crowd("cheap", 100)) {
    const std::string code = face_code_text(person);
    for (const bool again : {false, true}) {
      const long allocations = test::allocations(), bytes = test::held_bytes();
      const auto face = face_from_code(code);
      if (!again) continue;
      EXPECT_LE(test::allocations() - allocations, kMostAllocations) << code;
      EXPECT_LE(test::held_bytes() - bytes, kMostBytes) << code;
      ASSERT_TRUE(face);
    }
  }
}

double first_of(const Face& face, const FaceVector& vector, std::string_view slice, int plus = 0) {
  const int found = face.model->layout.find(slice);
  EXPECT_GE(found, 0) << slice;
  return vector[std::size_t(face.model->layout[found].begin + plus)];
}

std::vector<std::string> parts_of(std::string_view name) {
  for (const PartFamily& family : part_families())
    if (family.name == name) return family.parts;
  return {};
}

/// A fold above a shut lid looked like an open eye without an iris.
TEST(ComposedFace, ShutEyesHaveNoCrease) {
  double widest = 0;
  for (const std::string& eyes : parts_of("eyes")) {
    Recipe recipe = recipe_from_seed(5);
    recipe.parts["eyes"] = eyes, recipe.numbers["folds"] = 1;
    const Face face = face_from_recipe(recipe).value();
    Pose pose;
    pose.settings.push_back(
        read_expression(face, "arkit", "eyeBlinkLeft=1", OutOfRange::refuse).value());
    const std::string middle = "crease.left/half_width";
    widest = std::max(widest, first_of(face, face.vector, middle, 1));
    Poser poser(face);
    EXPECT_EQ(first_of(face, poser.pose(pose).vector, middle, 1), 0) << eyes;
  }
  EXPECT_GT(widest, 0.015);
}

/// A beard's roots: white hair made a pale mask of them on dark skin.
TEST(ComposedFace, ShadowsOfBeardsAreDarkerThanTheSkin) {
  for (const std::string& hair : parts_of("hair_color"))
    for (const double tone : {1.0, 4.0, 7.0, 8.5, 10.0}) {
      Recipe recipe = recipe_from_seed(5);
      recipe.parts["beard"] = "shadow", recipe.parts["hair_color"] = hair;
      recipe.numbers["skin.tone"] = tone;
      const Face face = face_from_recipe(recipe).value();
      const auto light = [&](std::string_view color) {
        return 0.2126 * first_of(face, face.vector, color) +
               0.7152 * first_of(face, face.vector, color, 1) +
               0.0722 * first_of(face, face.vector, color, 2);
      };
      EXPECT_LT(light("palette/beard_shadow"), light("palette/skin")) << hair << " " << tone;
    }
}

TEST(ComposedFace, WrongCodesAreSentences) {
  EXPECT_NE(face_from_code("Z0000").error().what.find("signs"), std::string::npos);
  EXPECT_FALSE(face_from_code(""));
}

/// The frames, at 30 a second, in which a face's eyes are shut.
std::vector<int> blinks(const Face& face, int frames) {
  const int at = face.model->layout.find("opening.left/upper");
  const std::size_t y = std::size_t(face.model->layout[at].begin) + 1;
  Poser poser(face);
  const double open = face.vector[y];
  const double shut =
      pose_face(face, {.settings = {read_setting(face, "blink=1").value()}}).vector[y];
  std::vector<int> found;
  for (int frame = 0; frame < frames; ++frame)
    if (poser.pose({.time = frame / 30.0}).vector[y] < shut + 0.4 * (open - shut))
      found.push_back(frame);
  return found;
}

TEST(ComposedFace, EverybodyBlinksByThemselves) {
  std::vector<std::vector<int>> all;
  std::size_t shut = 0;
  for (const FaceCode& code : crowd("blinks", 24)) {
    all.push_back(blinks(face_from_code(face_code_text(code)).value(), 20 * 30));
    EXPECT_GE(all.back().size(), 6u) << "twice in 20 s";
    EXPECT_LE(all.back().size(), 60u);
    shut += all.back().size();
  }
  std::size_t together = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_NE(all[i], all[k]);
      std::vector<int> both;
      std::set_intersection(all[i].begin(), all[i].end(), all[k].begin(), all[k].end(),
                            std::back_inserter(both));
      together += both.size();
    }
  const double mean = double(shut) / 24, pairs = 24 * 23 / 2;
  EXPECT_LT(double(together) / pairs, 2 * mean * mean / 600) << "as often as chance has it";
}

TEST(ComposedFace, HasATimeOfItsOwn) {
  const std::string code = face_code_text({.seed = 7, .held = {}});
  Recipe recipe = recipe_from_code(read_face_code(code).value()).value();
  const std::uint64_t own = face_from_code(code).value().model->seed;
  EXPECT_EQ(own, seed_from_word(code));
  recipe.style = "ink";
  EXPECT_EQ(face_from_recipe(recipe).value().model->seed, own) << "in every style";
  recipe.code.clear();
  const std::uint64_t without = face_from_recipe(recipe).value().model->seed;
  EXPECT_NE(without, own);
  recipe.style = "flat";
  EXPECT_EQ(face_from_recipe(recipe).value().model->seed, without);
  recipe.numbers["age"] = 61;
  EXPECT_NE(face_from_recipe(recipe).value().model->seed, without);
}

TEST(ComposedFace, WithoutLivelinessRests) {
  const Face face = face_from_recipe(recipe_from_seed(5)).value();
  for (const double time : {0.0, 0.7, 3.3, 1e6})
    EXPECT_EQ(pose_face(face, {.time = time, .liveliness = 0}).vector, face.vector);
}

/// The idle clip moves eyes, head, shoulders and mouth, never far.
TEST(ComposedFace, IsIdleWithinBounds) {
  const Face face = face_from_recipe(recipe_from_seed(5)).value();
  Poser poser(face);
  const auto range = [&](std::string_view name) {
    const int slice = face.model->layout.find(name);
    EXPECT_GE(slice, 0) << name;
    const std::size_t y = std::size_t(face.model->layout[slice].begin) + 1;
    double least = 9, most = -9;
    for (double t = 0; t < 20; t += 0.1) {
      const double now = poser.pose({.time = t}).vector[y];
      least = std::min(least, now), most = std::max(most, now);
    }
    return most - least;
  };
  EXPECT_NEAR(range("neck/points/1"), 0.008, 0.0017) << "breath";
  const double chin = range("head/points/5");
  EXPECT_GT(chin, 0.005);
  EXPECT_LT(chin, 0.06);
}

}  // namespace
}  // namespace mien
