#include "lib/parts/compose/styled_recipe.h"

#include <gtest/gtest.h>

#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

/// A recipe with a snub nose and these numbers, in a style that says this.
Recipe in_style(const std::string& style, std::map<std::string, double> numbers = {}) {
  test::SmallLibrary small;
  small.topology = test::with(small.topology, "\"soft\": {}", "\"soft\": {" + style + "}");
  const auto library = small.read().value();
  return styled(*library, Recipe{.name = {},
                                 .code = {},
                                 .parts = {{"head", "oval"}, {"nose", "snub"}},
                                 .numbers = std::move(numbers)});
}

std::string why_refused(const std::string& style) {
  try {
    in_style(style);
  } catch (const Refusal& refusal) {
    return refusal.error.what;
  }
  return "it is taken";
}

TEST(StyledRecipe, PartsAreTheStyles) {
  EXPECT_EQ(in_style("").parts.at("nose"), "snub");
  EXPECT_EQ(in_style(R"("parts": {"nose": "long"})").parts.at("nose"), "long");
  EXPECT_FALSE(in_style(R"("parts": {"nose": null})").parts.contains("nose"));
  EXPECT_EQ(in_style(R"("parts": {"nose": null})").parts.at("head"), "oval");
}

TEST(StyledRecipe, NumbersMoveWithinTheirRange) {
  const char* bigger = R"("numbers": {"size": {"times": 1.5, "adds": 0.1}})";
  EXPECT_DOUBLE_EQ(in_style(bigger, {{"size", 0.5}}).numbers.at("size"), 0.85);
  EXPECT_DOUBLE_EQ(in_style(bigger).numbers.at("size"), 1.6) << "from rest";
  EXPECT_DOUBLE_EQ(in_style(bigger, {{"size", 1.9}}).numbers.at("size"), 2);
  EXPECT_FALSE(in_style(bigger).numbers.contains("apart"));
}

TEST(StyledRecipe, WhatTheLibraryHasNotIsRefused) {
  EXPECT_NE(why_refused(R"("parts": {"noze": "long"})").find("did you mean \"nose\"?"),
            std::string::npos);
  EXPECT_NE(why_refused(R"("parts": {"nose": "lang"})").find("did you mean \"long\"?"),
            std::string::npos);
  EXPECT_NE(why_refused(R"("numbers": {"sise": {"adds": 1}})").find("did you mean \"size\"?"),
            std::string::npos);
}

}  // namespace
}  // namespace mien
