#include "lib/parts/code/code_fields.h"

#include <gtest/gtest.h>

#include "lib/parts/library/part_library.h"

namespace mien {
namespace {

/// The recipe that the code of a recipe makes.
Recipe by_code(const Recipe& recipe) {
  const FaceCode code = code_of_recipe(recipe).value();
  return recipe_from_code(read_face_code(face_code_text(code)).value()).value();
}

TEST(CodeFields, ASeedsRecipeHasTheSeedsCode) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Recipe recipe = recipe_from_seed(seed);
    EXPECT_EQ(face_code_text(code_of_recipe(recipe).value()), recipe.code);
  }
}

TEST(CodeFields, WhatACodeHoldsStaysAsItWasWritten) {
  FaceCode code{.seed = 7, .held = {}};
  for (const char* held : {"eye.size=1.1", "hair=bob", "glasses=none"})
    code.held.push_back(read_held_value(held).value());
  EXPECT_EQ(code_of_recipe(recipe_from_code(code).value()).value(), code);
}

/// Also where one change brings others: an age, numbers; a skin, colours.
TEST(CodeFields, ChangedRecipesComeBack) {
  const std::vector<PartNumber> numbers = part_numbers();
  for (int i = 0; i < 100; ++i) {
    const Recipe other = recipe_from_seed(std::uint64_t(i) + 1000);
    Recipe recipe = recipe_from_seed(std::uint64_t(i));
    for (const char* family : {"hair", "skin", "backdrop", "glasses"}) {
      recipe.parts.erase(family);
      if (other.parts.contains(family)) recipe.parts[family] = other.parts.at(family);
    }
    for (const char* name : {"age", "skin.tone", "chin"})
      recipe.numbers[name] = other.numbers.at(name);
    const Recipe back = by_code(recipe);
    EXPECT_EQ(back.parts, recipe.parts) << i;
    for (const PartNumber& number : numbers)
      EXPECT_NEAR(back.numbers.at(number.name), recipe.numbers.at(number.name),
                  (number.hi - number.lo) / 2046 * 1.001)
          << i << " " << number.name;
  }
}

TEST(CodeFields, WhatARecipeDoesNotSayIsAtRest) {
  const Recipe back = by_code({});
  for (const PartNumber& number : part_numbers())
    EXPECT_NEAR(back.numbers.at(number.name), number.rest, (number.hi - number.lo) / 2046 * 1.001);
  for (const PartFamily& family : part_families()) {
    EXPECT_EQ(back.parts.contains(family.name), !family.optional) << family.name;
    if (family.optional) continue;
    EXPECT_EQ(back.parts.at(family.name), PartLibrary::shipped().find_family(family.name)->usual);
  }
}

TEST(CodeFields, WrongRecipesAreSentences) {
  const auto error =
      code_of_recipe({.name = {}, .code = {}, .parts = {{"hair", "bbo"}}, .numbers = {}});
  EXPECT_NE(error.error().what.find("did you mean \"bob\""), std::string::npos);
}

}  // namespace
}  // namespace mien
