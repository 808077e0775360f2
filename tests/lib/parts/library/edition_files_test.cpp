// An edition is what its folder holds beside the edition before: it changes the faces that win its parts, and no face
// of an edition before.

#include "lib/parts/library/edition_files.h"

#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <string>

#include "lib/parts/compose/compose.h"
#include "lib/parts/compose/composed_text.h"
#include "lib/parts/library/part_library.h"
#include "lib/parts/recipe/sample.h"
#include "tests/support/effort.h"

namespace mien {
namespace {

constexpr ShippedPart kOld[] = {{"hair/bob", "a"}, {kTopologyFile, "t"}},
                      kMore[] = {{"hair/wig", "b"}},
                      kAnew[] = {{"hair/cap", "c"}, {kTopologyFile, "u"}};
constexpr ShippedFolder kFolders[] = {{'A', kOld}, {'B', kMore}, {'D', kAnew}, {'Z', kOld}};

std::string names_of(char edition) {
  std::string names;
  for (const ShippedPart& part : edition_files(kFolders, edition)) names += std::string(part.text);
  return names;
}

TEST(EditionFiles, AreThoseOfTheEditionsBeforeAndItsOwn) {
  EXPECT_EQ(names_of('A'), "at");
  EXPECT_EQ(names_of('B'), "atb");
  EXPECT_EQ(names_of('D'), "cu");
  EXPECT_EQ(names_of('Z'), "at");
}

// Two editions made here: A is the trial one's files, B has one more hair and one more number.

constexpr int kFaces = test::times(4000);
constexpr ShippedPart kHairOfB[] = {
    {"hair/cowlick.part.json",
     R"({"format": "mien-part", "format_version": 1, "family": "hair", "name": "cowlick", "number": 1000, "tickets": {"any": 9},
         "points": {"hairline": [0.24, 0.45]},
         "features": [{"name": "hair", "slot": "hair", "role": "hair", "in": "scalp", "kind": "ellipse", "turn": 0,
                       "center": [0, 0.5], "radii": [0.4, 0.2], "paint": "hair"}]})"},
    {"numbers.json",
     R"({"format": "mien-numbers", "format_version": 1, "numbers": {
         "tousled": {"number": 1001, "range": [0, 1], "rest": 0, "sampled": {"even": 1}}}})"}};

std::unique_ptr<PartLibrary> library_of(char edition, bool with_b) {
  const std::vector<ShippedPart> trial = edition_files(shipped_folders(), 'A');
  std::vector<ShippedFolder> folders{{'A', trial}};
  if (with_b) folders.push_back({'B', kHairOfB});
  std::vector<PartLibrary::Text> texts;
  for (const ShippedPart& part : edition_files(folders, edition))
    texts.push_back({part.name, part.text});
  auto read = PartLibrary::read(texts);
  EXPECT_TRUE(read) << sentence(read.error());
  return *std::move(read);
}

FaceCode somebody_of(int i, char edition) {
  return {.edition = edition, .seed = seed_from_word(std::to_string(i)), .held = {}};
}

std::string composed(const PartLibrary& library, const Recipe& recipe) {
  return composed_text(composed_face(ChosenParts::read(library, recipe).value()).value());
}

TEST(EditionFiles, AnEditionKeepsTheFacesOfThoseBefore) {
  const auto alone = library_of('A', false), beside = library_of('A', true);
  EXPECT_FALSE(beside->find_family("hair")->find("cowlick"));
  EXPECT_FALSE(beside->find_number("tousled"));
  for (int i = 0; i < kFaces; ++i) {
    const Recipe a = sampled_recipe(*alone, somebody_of(i, 'A')),
                 b = sampled_recipe(*beside, somebody_of(i, 'A'));
    EXPECT_EQ(a.parts, b.parts);
    EXPECT_EQ(a.numbers, b.numbers);
    if (i % 50 == 0) {
      EXPECT_EQ(composed(*alone, a), composed(*beside, b));
    }
  }
}

TEST(EditionFiles, APartOfTheNextChangesTheFacesThatWinIt) {
  const auto a = library_of('A', true), b = library_of('B', true);
  int won = 0;
  for (int i = 0; i < kFaces; ++i) {
    const Recipe before = sampled_recipe(*a, somebody_of(i, 'A'));
    Recipe after = sampled_recipe(*b, somebody_of(i, 'B'));
    EXPECT_EQ(after.edition, 'B');
    EXPECT_EQ(after.numbers.erase("tousled"), 1u);
    EXPECT_EQ(after.numbers, before.numbers);
    if (after.parts.at("hair") == "cowlick") {
      after.parts["hair"] = before.parts.at("hair");
      ++won;
    }
    EXPECT_EQ(after.parts, before.parts) << i;
    if (i % 50 != 0) continue;
    after.name = before.name, after.code = before.code;
    EXPECT_EQ(composed(*b, after), composed(*a, before));
  }
  std::cout << "of " << kFaces << " faces of edition B " << won << " have its new hair\n";
  EXPECT_GT(won, kFaces / 100);
  EXPECT_LT(won, kFaces / 5);
}

}  // namespace
}  // namespace mien
