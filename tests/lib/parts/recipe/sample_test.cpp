// One version draws the same vector of a code everywhere: with every compiler, optimiser and instruction set, on every
// machine. The hashes promise nothing to later versions: until 1.0 codes may mean other people. Whoever changes the parts,
// their laws or how they are composed renews sample_hashes.txt (tools/renew_expected).

#include "lib/parts/recipe/sample.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "lib/base/fingerprint.h"
#include "lib/parts/compose/compose.h"
#include "lib/parts/compose/composed_text.h"
#include "lib/parts/compose/part_palette.h"

namespace mien {
namespace {

constexpr int kSeeds = 1000;

/// Whether the file has this hash under this name. To be renewed, it is given it.
void expect_hash(const std::string& name, std::uint64_t hash) {
  const std::string path = MIEN_SOURCE_DIR "/tests/lib/parts/recipe/sample_hashes.txt";
  std::map<std::string, std::string> hashes;
  std::ifstream file(path);
  for (std::string key, value; file >> key >> value;) hashes[key] = value;
  const std::string found = fmt::format("{:016x}", hash);
  if (!std::getenv("MIEN_RENEW")) {
    EXPECT_EQ(found, hashes[name]) << name;
    return;
  }
  hashes[name] = found;
  std::ofstream renewed(path);
  for (const auto& [key, value] : hashes) renewed << key << ' ' << value << '\n';
}

void add_text(Fingerprint& to, std::string_view text) {
  to.add(int(text.size()));
  for (const char c : text) to.add(int(c));
}

FaceCode person(int number) {
  return {.seed = seed_from_word(std::to_string(number)), .held = {}};
}

TEST(Sample, VectorsHaveTheSameBitsEverywhere) {
  Fingerprint bits;
  for (int i = 0; i < kSeeds; ++i) {
    const Recipe recipe = sampled_recipe(PartLibrary::shipped(), person(i));
    for (const auto& [family, part] : recipe.parts) add_text(bits, family), add_text(bits, part);
    for (const auto& [name, value] : recipe.numbers) add_text(bits, name), bits.add(value);
  }
  expect_hash("vectors", bits.value());
}

/// Every number, name and colour of the composed faces, in the order of their files.
TEST(Sample, ComposedFacesHaveTheSameBitsEverywhere) {
  Fingerprint bits;
  const std::vector<std::string>& styles = PartLibrary::shipped().styles();
  for (int i = 0; i < kSeeds; ++i) {
    Recipe recipe = sampled_recipe(PartLibrary::shipped(), person(i));
    recipe.style = styles[std::size_t(i) % styles.size()];
    const auto tree = composed_face(ChosenParts::read(PartLibrary::shipped(), recipe).value());
    ASSERT_TRUE(tree) << tree.error().where << ": " << tree.error().what;
    add_text(bits, composed_text(*tree));
  }
  expect_hash("composed", bits.value());
}

// At 48 px a head is what stands off from its backdrop.
TEST(Sample, BackdropsStandOffFromSkinAndHair) {
  constexpr double kApart = 0.2, kLeast = 0.16;
  constexpr int kPeople = 500;
  const PartLibrary& library = PartLibrary::shipped();
  int near = 0;
  for (int i = 0; i < kPeople; ++i) {
    const Recipe recipe = sampled_recipe(library, person(i));
    const Oklch backdrop = color_of(*chosen_part(library, recipe, "backdrop")),
                hair = color_of(*chosen_part(library, recipe, "hair_color")),
                skin = skin_color(library, recipe.numbers.at("skin.tone"),
                                  recipe.numbers.at("skin.undertone"));
    const double least = std::min(apart(backdrop, skin), apart(backdrop, hair));
    EXPECT_GE(least, kLeast) << recipe.name;
    near += least < kApart;
  }
  EXPECT_LE(near, kPeople / 100);
}

// Styles without lines have nothing else that tells a hairline.
TEST(Sample, HairStandsOffFromSkin) {
  constexpr double kApart = 0.07;
  const PartLibrary& library = PartLibrary::shipped();
  for (int i = 0; i < 500; ++i) {
    const Recipe recipe = sampled_recipe(library, person(i));
    const Oklch skin =
        skin_color(library, recipe.numbers.at("skin.tone"), recipe.numbers.at("skin.undertone"));
    EXPECT_GE(apart(color_of(*chosen_part(library, recipe, "hair_color")), skin), kApart)
        << recipe.name;
  }
}

// A part more changes the faces that win it, and none else: so the library can grow.

constexpr const char* kAdded = "added";
constexpr int kSampled = 2000;

/// The library and one part more, which stands before all others: a copy of the family's first, with a number of its own.
std::unique_ptr<PartLibrary> with_part(const std::string& text) {
  std::vector<ShippedPart> files{{"added.part.json", text}};
  for (const ShippedPart& part : shipped_parts()) files.push_back(part);
  auto library = PartLibrary::read(files);
  EXPECT_TRUE(library) << library.error().where << ": " << library.error().what;
  return *std::move(library);
}

std::string part_of(const Recipe& recipe, const std::string& family) {
  const auto part = recipe.parts.find(family);
  return part == recipe.parts.end() ? "" : part->second;
}

/// How many of the people get the part; expects that it changes nobody else, and of them only what may depend on it.
int changed_faces(const PartLibrary& more, const Family& family) {
  const PartLibrary& shipped = PartLibrary::shipped();
  int changed = 0;
  for (int i = 0; i < kSampled; ++i) {
    const Recipe before = sampled_recipe(shipped, person(i));
    Recipe after = sampled_recipe(more, person(i));
    EXPECT_EQ(after.numbers.erase("head.added"), family.name == "head" ? 1u : 0u);
    EXPECT_EQ(after.numbers, before.numbers) << i;
    if (part_of(after, family.name) == kAdded) {
      ++changed;
      continue;
    }
    EXPECT_EQ(after.parts, before.parts) << i << " is changed without the part";
    if (i % 100 != 0) continue;
    EXPECT_EQ(composed_text(*composed_face(ChosenParts::read(more, after).value())),
              composed_text(*composed_face(ChosenParts::read(shipped, before).value())));
  }
  return changed;
}

TEST(Sample, AnAddedPartChangesOnlyTheFacesThatWinIt) {
  std::string counts;
  for (const Family& family : PartLibrary::shipped().families()) {
    const std::string number = family.name == "head"
                                   ? R"(, "numbers": {"added": {"number": 1000, "range": [0, 1],
                                   "rest": 0.5, "sampled": {"spread": 0.5}}})"
                                   : "";
    const std::string text = fmt::format(
        R"({{"format": "mien-part", "family": "{}", "name": "{}", "number": 900, "color": [0.6, 0.1, 200],
            "tickets": {{"any": 8}}{}}})",
        family.name, kAdded, number);
    const auto more = with_part(text);
    const int changed = changed_faces(*more, family);
    counts += fmt::format(" {} {}", family.name, changed);
    EXPECT_GT(changed, 0) << family.name;
    EXPECT_LT(changed, kSampled / 2) << family.name;
  }
  std::cout << "faces of " << kSampled << " that an added part changes:" << counts << "\n";
}

}  // namespace
}  // namespace mien
