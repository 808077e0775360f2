// What the library may not have: a name or a permanent number twice. And what becomes of a broken file of it.

#include "lib/parts/library/shipped_parts.h"
#include "lib/parts/library/part_library.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

/// Puts down whose a feature is; two families must not share one.
void note_features(const LibraryNode& of, const std::string& whose,
                   std::map<std::string, std::string, std::less<>>& owners) {
  const Reading& in = of.in();
  const JsonNode* features = in.find(*of.node, "features");
  if (!features) return;
  in.for_each(*features, [&](const JsonNode& feature, int) {
    const std::string name(in.string(in.need(feature, "name")));
    const auto [known, is_new] = owners.emplace(name, whose);
    EXPECT_TRUE(is_new || known->second == whose)
        << name << " is of " << known->second << " and of " << whose;
  });
}

TEST(ShippedParts, NoTwoFamiliesShareAFeature) {
  std::map<std::string, std::string, std::less<>> owners;
  const PartLibrary& library = PartLibrary::shipped();
  note_features(library.topology(), "the topology", owners);
  for (const Family& family : library.families())
    for (const Part& part : family.parts) note_features(part.at, family.name, owners);
  EXPECT_GT(owners.size(), 100u);
}

/// Families and numbers are fields of one code; parts are values of their family's field.
TEST(ShippedParts, NoPermanentNumberIsUsedTwice) {
  std::map<int, std::string> fields;
  const auto note = [&](int number, const std::string& name) {
    const auto [known, is_new] = fields.emplace(number, name);
    EXPECT_TRUE(is_new) << number << " is of " << known->second << " and of " << name;
  };
  const PartLibrary& library = PartLibrary::shipped();
  for (const LibraryNumber& number : library.numbers()) note(number.number, number.name);
  for (const Family& family : library.families()) {
    note(family.number, family.name);
    std::map<int, std::string> parts;
    for (const Part& part : family.parts) {
      const auto [known, is_new] = parts.emplace(part.number, part.name);
      EXPECT_TRUE(is_new) << family.name << ": " << known->second << " and " << part.name;
    }
  }
}

/// What is said of a library whose noses are these.
std::string said_of(const std::string& noses) {
  const test::SmallLibrary small;
  const auto read = PartLibrary::read(
      {{"head.json", small.head}, {"nose/all.json", noses}, {"topology.json", small.topology}});
  return read ? "read" : sentence(read.error());
}

TEST(ShippedParts, OfABrokenFileSaysWhichAndWhere) {
  const std::string good = test::SmallLibrary{}.noses;
  EXPECT_EQ(said_of(good), "read");
  EXPECT_TRUE(said_of("").starts_with("nose/all.json:1:1: ")) << said_of("");
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"number\": 2,", "\"number\": ,"},
           {"\"number\": 2,", "\"number\": 2, \"tickets\": 7,"},
           {"\"number\": 2,", "\"number\": 2, \"tickets\": {\"any\": \"7\"},"},
           {"\"number\": 2,", "\"number\": 1,"},
           {"\"number\": 2,", "\"number\": 2, \"avoids\": [\"nose\"],"},
           {"\"number\": 2,", "\"number\": 2, \"avoids\": [\"head/spare\"],"},
           {"\"name\": \"long\", ", ""}}) {
    const std::string said = said_of(test::with(good, from, to));
    EXPECT_TRUE(said.starts_with("nose/all.json:4:")) << said;
  }
}

TEST(ShippedParts, IsThereOrSaysWhy) {
  const auto read = PartLibrary::shipped_or_why();
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(*read, &PartLibrary::shipped());
}

}  // namespace
}  // namespace mien
