#include <mien/recipe.h>
#include <mien/relatives.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

const FaceCode kAda{.seed = 11}, kBen{.seed = 77};

TEST(Relatives, BetweenBeginsAndEndsWithThePeople) {
  const Recipe a = recipe_from_code(kAda).value(), b = recipe_from_code(kBen).value();
  const Recipe begin = recipe_from_code(code_between(kAda, kBen, 0).value()).value();
  const Recipe end = recipe_from_code(code_between(kAda, kBen, 1).value()).value();
  EXPECT_EQ(begin.parts, a.parts);
  EXPECT_EQ(begin.numbers, a.numbers);
  EXPECT_EQ(end.parts, b.parts);
  EXPECT_EQ(end.numbers, b.numbers);
  const Recipe middle = recipe_from_code(code_between(kAda, kBen, 0.5).value()).value();
  for (const auto& [name, value] : middle.numbers)
    EXPECT_NEAR(value, 0.5 * (a.numbers.at(name) + b.numbers.at(name)), 0.1) << name;
}

TEST(Relatives, NearIsNearer) {
  EXPECT_EQ(recipe_from_code(code_near(kAda, 0, 5).value()).value().parts,
            recipe_from_code(kAda).value().parts);
  double near = 0, far = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    near += difference(kAda, code_near(kAda, 0.1, seed).value()).value();
    far += difference(kAda, code_near(kAda, 0.8, seed).value()).value();
  }
  EXPECT_LT(2 * near, far);
  EXPECT_GT(near, 0);
}

TEST(Relatives, ChildrenAreChildrenOfTheirParents) {
  const Recipe a = recipe_from_code(kAda).value(), b = recipe_from_code(kBen).value();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Recipe child = recipe_from_code(code_of_child(kAda, kBen, seed).value()).value();
    EXPECT_LT(child.numbers.at("age"), 16);
    for (const char* family : {"eyes", "nose", "iris"})
      EXPECT_TRUE(child.parts.at(family) == a.parts.at(family) ||
                  child.parts.at(family) == b.parts.at(family));
  }
}

TEST(Relatives, DifferenceIsADistance) {
  EXPECT_EQ(difference(kAda, kAda).value(), 0);
  EXPECT_EQ(difference(kAda, kBen).value(), difference(kBen, kAda).value());
  EXPECT_GT(difference(kAda, kBen).value(), 1);
  EXPECT_FALSE(difference(kAda, {.held = {{999, 0}}}));
  EXPECT_FALSE(code_near({.held = {{999, 0}}}, 0.5, 1));
}

}  // namespace
}  // namespace mien
