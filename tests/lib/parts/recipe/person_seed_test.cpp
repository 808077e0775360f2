#include "lib/parts/recipe/person_seed.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(PersonSeed, IsTheSameInEveryStyle) {
  Recipe recipe = recipe_from_seed(3);
  const std::uint64_t seed = person_seed(recipe);
  recipe.style = "ink";
  EXPECT_EQ(person_seed(recipe), seed);
  recipe.code.clear();
  const std::uint64_t written = person_seed(recipe);
  recipe.style = "soft";
  EXPECT_EQ(person_seed(recipe), written) << "without a code, too";
}

TEST(PersonSeed, IsThePersonsOwn) {
  Recipe recipe = recipe_from_seed(3), other = recipe_from_seed(4);
  EXPECT_NE(person_seed(recipe), person_seed(other));
  recipe.code.clear();
  const std::uint64_t before = person_seed(recipe);
  recipe.numbers["age"] = 77;
  EXPECT_NE(person_seed(recipe), before) << "of what it is made of";
}

TEST(PersonSeed, DoesNotDependOnHowACodeIsWritten) {
  Recipe recipe = recipe_from_seed(3);
  const std::uint64_t seed = person_seed(recipe);
  std::erase(recipe.code, '-');
  for (char& sign : recipe.code)
    if (sign >= 'A' && sign <= 'Z') sign = char(sign - 'A' + 'a');
  EXPECT_EQ(person_seed(recipe), seed);
}

}  // namespace
}  // namespace mien
