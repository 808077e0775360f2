#include <mien/recipe_between.h>

#include <mien/composed_face.h>
#include <mien/relatives.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mien {
namespace {

const Recipe kFirst = recipe_from_seed(11), kLast = recipe_from_seed(77);

Recipe at_place(double at, std::optional<double> parts_at = {}) {
  return recipe_between(kFirst, kLast, at, parts_at).value();
}

TEST(RecipeBetween, BeginsAndEndsWithThePeople) {
  EXPECT_EQ(at_place(0).parts, kFirst.parts);
  EXPECT_EQ(at_place(0).numbers, kFirst.numbers);
  EXPECT_EQ(at_place(1).parts, kLast.parts);
  for (const auto& [name, value] : at_place(1).numbers)
    EXPECT_NEAR(value, kLast.numbers.at(name), 1e-12) << name;
  EXPECT_EQ(face_from_recipe(at_place(0)).value().vector, face_from_recipe(kFirst).value().vector);
  // Beyond them there is nobody.
  EXPECT_EQ(at_place(-0.5).numbers, at_place(0).numbers);
  EXPECT_EQ(at_place(1.5).numbers, at_place(1).numbers);
}

TEST(RecipeBetween, NumbersAndColoursGoEvenly) {
  const Recipe middle = at_place(0.25);
  for (const auto& [name, value] : middle.numbers)
    EXPECT_NEAR(value, 0.75 * kFirst.numbers.at(name) + 0.25 * kLast.numbers.at(name), 1e-12);
  EXPECT_EQ(middle.parts.at("hair_color"), "between/hair_color");
  ASSERT_TRUE(face_from_recipe(middle));
  // Many small steps: no colour jumps, though the first and the last differ much.
  std::set<std::string> colors;
  for (int i = 1; i < 10; ++i)
    colors.insert(at_place(i / 10.0).own_parts.at("between/hair_color").text);
  EXPECT_EQ(colors.size(), kFirst.parts.at("hair_color") == kLast.parts.at("hair_color") ? 1u : 9u);
}

TEST(RecipeBetween, PartsChangeAtAPlace) {
  EXPECT_EQ(at_place(0.49, 0.5).parts.at("hair"), kFirst.parts.at("hair"));
  EXPECT_EQ(at_place(0.5, 0.5).parts.at("hair"), kLast.parts.at("hair"));
  // Without one, where relatives by code change.
  for (const double at : {0.2, 0.5, 0.8}) {
    const auto code = code_between({.seed = 11}, {.seed = 77}, at);
    const Recipe by_code = recipe_from_code(*code).value();
    for (const char* family : {"hair", "nose", "eyes", "clothes", "mouth"})
      EXPECT_EQ(at_place(at).parts.at(family), by_code.parts.at(family)) << family << at;
  }
}

TEST(RecipeBetween, PeopleMayHavePartsOfTheirOwn) {
  Recipe first = kFirst, last = kLast;
  const auto color = [](double lightness) {
    return R"({"format": "mien-part", "format_version": 1, "family": "hair_color", "name": "mine", "color": [)" +
           std::to_string(lightness) + ", 0.1, 350]}";
  };
  first.parts["hair_color"] = last.parts["hair_color"] = "mine.part.json";
  first.own_parts["mine.part.json"] = {"mine.part.json", color(0.25)};
  last.own_parts["mine.part.json"] = {"mine.part.json", color(0.75)};
  const Recipe middle = recipe_between(first, last, 0.5).value();
  EXPECT_NE(middle.own_parts.at("between/hair_color").text.find("[0.5"), std::string::npos);
  EXPECT_TRUE(face_from_recipe(middle));
  EXPECT_TRUE(face_from_recipe(recipe_between(first, last, 1).value()));
}

TEST(RecipeBetween, WhatIsUnknownIsSaid) {
  Recipe wrong = kFirst;
  wrong.parts["hair"] = "bbo";
  EXPECT_NE(recipe_between(wrong, kLast, 0.5).error().what.find("did you mean \"bob\""),
            std::string::npos);
}

}  // namespace
}  // namespace mien
