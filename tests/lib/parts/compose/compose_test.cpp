#include "lib/parts/compose/compose.h"

#include <mien/composed_face.h>
#include <mien/face_file.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <thread>

namespace mien {
namespace {

/// Whether two trees say the same, wherever members stand.
bool same(const JsonTree& a, const JsonNode& in_a, const JsonTree& b, const JsonNode& in_b) {
  if (in_a.kind != in_b.kind || in_a.count != in_b.count || in_a.number != in_b.number)
    return false;
  if (in_a.kind == JsonKind::string) return a.string(in_a) == b.string(in_b);
  const JsonNode* other = b.first(in_b);
  for (const JsonNode* one = a.first(in_a); one; one = a.next(*one)) {
    if (in_a.kind == JsonKind::object) other = b.member(in_b, a.key(*one));
    if (!other || !same(a, *one, b, *other)) return false;
    if (in_a.kind == JsonKind::array) other = b.next(*other);
  }
  return true;
}

/// A face is read from the tree, its file from the text: both must be one face, for every part and style. The reader
/// of the text refuses, too, what is said twice.
TEST(Compose, TreeAndTextAreOneFace) {
  for (const PartFamily& family : part_families())
    for (const std::string& part : family.parts)
      for (const std::string& style : part_styles()) {
        Recipe recipe = recipe_from_seed(seed_from_word(part));
        recipe.parts[family.name] = part, recipe.style = style;
        recipe.name = "\xC3\xA4 and \xFF, \"broken\"";
        const ChosenParts parts = ChosenParts::read(PartLibrary::shipped(), recipe).value();
        const auto tree = composed_face(parts);
        ASSERT_TRUE(tree) << tree.error().what;
        const std::string text = face_text_from_recipe(recipe).value();
        const auto read = JsonTree::read(text, "text", {});
        ASSERT_TRUE(read) << part << " " << style << ": " << read.error().what;
        EXPECT_TRUE(same(*tree, tree->root(), *read, read->root())) << part << " " << style;
      }
}

TEST(Compose, FacesOfTreeAndTextHaveTheSameNumbers) {
  for (int i = 0; i < 100; ++i) {
    const Recipe recipe = recipe_from_seed(seed_from_word(std::to_string(i)));
    const Face face = face_from_recipe(recipe).value();
    const Face read = read_face_text(face_text_from_recipe(recipe).value(), "text").value();
    EXPECT_EQ(face.vector, read.vector) << i;
    EXPECT_EQ(read_face_text(recipe_text(recipe), "recipe").value().vector, read.vector) << i;
  }
}

TEST(Compose, ManyThreadsMakeTheSameFaces) {
  constexpr int kThreads = 4, kFaces = 40;
  std::vector<std::vector<FaceVector>> made(kThreads);
  const auto make = [&](int thread) {
    for (int i = 0; i < kFaces; ++i)
      made[std::size_t(thread)].push_back(
          face_from_recipe(recipe_from_seed(std::uint64_t(i))).value().vector);
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(make, i);
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<FaceVector>& one : made) EXPECT_EQ(one, made[0]);
}

/// The lips of vinyl are areas of the lips' lines, which a grin has not.
TEST(Compose, AStylesAreasOfWhatAPartLeavesOutAreLeftOut) {
  const auto has_lips = [](const char* mouth) {
    Recipe recipe = recipe_from_seed(1);
    recipe.parts["mouth"] = mouth, recipe.style = "vinyl";
    return face_text_from_recipe(recipe).value().find("lip_upper_body") != std::string::npos;
  };
  EXPECT_TRUE(has_lips("full"));
  EXPECT_FALSE(has_lips("grin"));
}

/// An afro hides ears, and a scarf hides the afro: then ears are seen. Below a hijab they are not.
TEST(Compose, WhatACoveredPartCoversIsSeen) {
  const auto shows_ears = [](const char* headwear) {
    Recipe recipe = recipe_from_seed(7);
    recipe.parts["hair"] = "afro", recipe.parts["headwear"] = headwear;
    return face_from_recipe(recipe).value().model->layout.find("ear.left/points/0") >= 0;
  };
  EXPECT_FALSE(shows_ears("none"));
  EXPECT_TRUE(shows_ears("headscarf"));
  EXPECT_FALSE(shows_ears("hijab"));
}

/// High brows lift the brim above them, and low ones do not.
TEST(Compose, BrimsClearTheBrows) {
  const auto lowest = [](const char* hat, double brow) {
    Recipe recipe = recipe_from_seed(1);
    recipe.parts["hair"] = "bald", recipe.parts["headwear"] = hat;
    recipe.numbers["brow.y"] = brow, recipe.numbers["eye.y"] = 2 * brow;
    recipe.numbers["forehead"] = -0.04;
    const Face face = face_from_recipe(recipe).value();
    double low = 1;
    for (int i = 0;; ++i) {
      const int slice = face.model->layout.find("brim/points/" + std::to_string(i));
      if (slice < 0) return low;
      low = std::min(low, face.vector[std::size_t(face.model->layout[slice].begin) + 1]);
    }
  };
  for (const char* hat : {"bucket", "beanie"}) {
    const double down = lowest(hat, -0.03), up = lowest(hat, 0.035);
    EXPECT_LT(down, 1) << hat;
    EXPECT_GT(up, down + 0.003) << hat;
    EXPECT_LT(up, down + 0.05) << hat;
  }
}

/// A colour of the palette as its text tells it: "#rrggbb".
std::array<int, 3> palette_color(const std::string& face, const std::string& name) {
  const std::size_t at = face.find("\"" + name + "\": \"#") + name.size() + 6;
  std::array<int, 3> levels{};
  for (std::size_t i = 0; i < 3; ++i)
    levels[i] = std::stoi(face.substr(at + 2 * i, 2), nullptr, 16);
  return levels;
}

/// A mouth that is one line has no lips that tell it from the hair around it.
TEST(Compose, AMouthThatIsALineIsSeenInABeard) {
  constexpr int kSeen = 75;  // levels of 255, of the channel that differs most
  for (const char* beard : {"full", "long", "short", "circle"})
    for (const char* hair : {"black", "chestnut", "copper", "silver", "white"}) {
      Recipe recipe = recipe_from_seed(1);
      recipe.parts["mouth"] = "line", recipe.parts["beard"] = beard;
      recipe.parts["hair_color"] = hair;
      const auto text = face_text_from_recipe(recipe);
      ASSERT_TRUE(text) << text.error().what;
      const std::string& face = *text;
      const auto line = palette_color(face, "mouth_line");
      const auto around = palette_color(face, "beard");
      int apart = 0;
      for (std::size_t i = 0; i < 3; ++i) apart = std::max(apart, std::abs(line[i] - around[i]));
      EXPECT_GE(apart, kSeen) << beard << " " << hair;
    }
}

/// What a caller allows holds for what is composed of a recipe, too.
TEST(Compose, LimitsHoldForWhatIsComposed) {
  const std::string text = recipe_text(recipe_from_seed(1));
  EXPECT_TRUE(read_face_text(text, "r"));
  const auto what = [&](const FaceLimits& limits) {
    const auto face = read_face_text(text, "r", limits);
    return face ? "a face" : face.error().what;
  };
  EXPECT_NE(what({.values = 1000}).find("(limit: values)"), std::string::npos);
  EXPECT_NE(what({.features = 10}).find("(limit: features)"), std::string::npos);
  EXPECT_NE(what({.nesting = 3}).find("(limit: nesting)"), std::string::npos);
}

}  // namespace
}  // namespace mien
