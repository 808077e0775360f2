// The same code is the same vector everywhere: with every compiler, optimiser and instruction set, on every machine.

#include "lib/parts/recipe/sample.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "lib/base/fingerprint.h"
#include "lib/parts/compose/compose.h"
#include "lib/parts/compose/composed_text.h"
#include "lib/parts/library/edition_files.h"

namespace mien {
namespace {

constexpr int kSeeds = 1000;

// Whoever changes the parts, or how they are composed, changes the faces of all its codes, and
// writes here what the test then says.
constexpr std::uint64_t kVectors = 0xf8646de0e8fa3692, kComposed = 0xaa1c411504091b23;

void add_text(Fingerprint& to, std::string_view text) {
  to.add(int(text.size()));
  for (const char c : text) to.add(int(c));
}

FaceCode person(int number) {
  return {.edition = kTrialEdition, .seed = seed_from_word(std::to_string(number)), .held = {}};
}

const PartLibrary& trial() {
  return *PartLibrary::shipped(kTrialEdition);
}

TEST(Sample, VectorsHaveTheSameBitsEverywhere) {
  Fingerprint bits;
  for (int i = 0; i < kSeeds; ++i) {
    const Recipe recipe = sampled_recipe(trial(), person(i));
    for (const auto& [family, part] : recipe.parts) add_text(bits, family), add_text(bits, part);
    for (const auto& [name, value] : recipe.numbers) add_text(bits, name), bits.add(value);
  }
  EXPECT_EQ(bits.value(), kVectors) << "0x" << std::hex << bits.value();
}

/// Every number, name and colour of the composed faces, in the order of their files.
TEST(Sample, ComposedFacesHaveTheSameBitsEverywhere) {
  Fingerprint bits;
  const std::vector<std::string>& styles = trial().styles();
  for (int i = 0; i < kSeeds; ++i) {
    Recipe recipe = sampled_recipe(trial(), person(i));
    recipe.style = styles[std::size_t(i) % styles.size()];
    const auto tree = composed_face(ChosenParts::read(trial(), recipe).value());
    ASSERT_TRUE(tree) << tree.error().where << ": " << tree.error().what;
    add_text(bits, composed_text(*tree));
  }
  EXPECT_EQ(bits.value(), kComposed) << "0x" << std::hex << bits.value();
}

// A part more changes the faces that win it, and none else: the promise that lets an edition grow.

constexpr const char* kAdded = "added";
constexpr int kSampled = 2000;

/// The edition and one part more, which stands before all others: a copy of the family's first, with a number of its own.
std::unique_ptr<PartLibrary> with_part(const std::string& text) {
  std::vector<PartLibrary::Text> texts{{"added.part.json", text}};
  for (const ShippedPart& part : edition_files(shipped_folders(), kTrialEdition))
    texts.push_back({part.name, part.text});
  auto library = PartLibrary::read(texts);
  EXPECT_TRUE(library) << library.error().where << ": " << library.error().what;
  return *std::move(library);
}

std::string part_of(const Recipe& recipe, const std::string& family) {
  const auto part = recipe.parts.find(family);
  return part == recipe.parts.end() ? "" : part->second;
}

/// How many of the people get the part; expects that it changes nobody else, and of them only what may depend on it.
int changed_faces(const PartLibrary& more, const Family& family) {
  const PartLibrary& edition = trial();
  int changed = 0;
  for (int i = 0; i < kSampled; ++i) {
    const Recipe before = sampled_recipe(edition, person(i));
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
              composed_text(*composed_face(ChosenParts::read(edition, before).value())));
  }
  return changed;
}

TEST(Sample, AnAddedPartChangesOnlyTheFacesThatWinIt) {
  std::string counts;
  for (const Family& family : trial().families()) {
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
