#include "lib/parts/code/appearance.h"

#include <mien/recipe.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

Recipe somebody() {
  return recipe_from_seed(11);
}

double difference_to_somebody(const Recipe& other) {
  return difference(appearance_of(somebody()), appearance_of(other));
}

TEST(Appearance, OtherHairCountsOneAndAgeByThirtyYears) {
  Recipe other = somebody();
  other.parts["hair"] =
      other.parts.contains("hair") && other.parts["hair"] == "bob" ? "afro" : "bob";
  EXPECT_DOUBLE_EQ(difference_to_somebody(other), 1.0);
  Recipe older = somebody();
  older.numbers["age"] += older.numbers["age"] > 50 ? -15 : 15;
  EXPECT_NEAR(difference_to_somebody(older), 0.5, 1e-12);
}

TEST(Appearance, IsADistance) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Appearance a = appearance_of(recipe_from_seed(seed)),
                     b = appearance_of(recipe_from_seed(seed + 100)),
                     c = appearance_of(recipe_from_seed(seed + 200));
    EXPECT_EQ(difference(a, a), 0.0);
    EXPECT_EQ(difference(a, b), difference(b, a));
    EXPECT_LE(difference(a, c), difference(a, b) + difference(b, c) + 1e-12);
  }
}

TEST(Appearance, TellsPeopleApartBySkinAndHairColor) {
  Recipe other = somebody();
  double& tone = other.numbers["skin.tone"];
  tone = tone > 5 ? 2 : 9;
  EXPECT_GT(difference_to_somebody(other), 1.0);
}

}  // namespace
}  // namespace mien
