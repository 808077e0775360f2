// The parts that are named are those that were made faulty.

#include "tools/mien/people/parts_at_fault.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mien::command {
namespace {

/// People, and in whom something is wrong.
struct Blamed {
  std::vector<Recipe> people;
  std::vector<char> faulty;

  std::vector<PartAtFault> parts() const {
    std::vector<const Recipe*> all;
    for (const Recipe& one : people) all.push_back(&one);
    return parts_at_fault(all, faulty);
  }
};

template <class IsFaulty>
Blamed hundred_people(IsFaulty&& is_faulty) {
  Blamed blamed;
  for (int i = 0; i < 100; ++i) {
    blamed.people.push_back(recipe_from_seed(seed_from_word("blamed/" + std::to_string(i))));
    blamed.faulty.push_back(is_faulty(blamed.people.back()));
  }
  return blamed;
}

bool has(const Recipe& recipe, const std::string& family, const std::string& part) {
  const auto own = recipe.parts.find(family);
  return own != recipe.parts.end() && own->second == part;
}

TEST(PartsAtFault, NamesOnePart) {
  const Blamed blamed =
      hundred_people([](const Recipe& recipe) { return has(recipe, "nose", "straight"); });
  const std::vector<PartAtFault> parts = blamed.parts();
  ASSERT_EQ(parts.size(), 1u) << "it explains all of them";
  EXPECT_EQ(parts[0].family + "=" + parts[0].part, "nose=straight");
  EXPECT_GE(parts[0].faulty, 2);
  EXPECT_EQ(parts[0].faulty, std::ranges::count(blamed.faulty, char{1}));
  EXPECT_EQ(parts[0].faulty, parts[0].all);
}

TEST(PartsAtFault, NamesEachOfTwo) {
  const std::vector<PartAtFault> parts =
      hundred_people([](const Recipe& recipe) {
        return has(recipe, "nose", "soft") || has(recipe, "mouth", "soft");
      }).parts();
  ASSERT_GE(parts.size(), 2u);
  for (const char* name : {"nose=soft", "mouth=soft"})
    EXPECT_TRUE(std::ranges::any_of(parts, [&](const PartAtFault& one) {
      return one.family + "=" + one.part == name;
    })) << name;
}

TEST(PartsAtFault, NamesNothingWhereAllOrNoneOrOneIsFaulty) {
  EXPECT_TRUE(hundred_people([](const Recipe&) { return true; }).parts().empty());
  EXPECT_TRUE(hundred_people([](const Recipe&) { return false; }).parts().empty());
  bool first = true;
  EXPECT_TRUE(
      hundred_people([&](const Recipe&) { return std::exchange(first, false); }).parts().empty());
  EXPECT_TRUE(parts_at_fault({}, {}).empty());
}

}  // namespace
}  // namespace mien::command
