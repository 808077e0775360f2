// Heads are of kinds: what archetypes say moves together, age picks two of them, and the library can grow.

#include "lib/parts/recipe/person_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "lib/parts/recipe/sample.h"
#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

using test::SmallLibrary;
using test::with;

/// The shares of a person of this age, by archetype.
std::map<std::string, double> shares_at(double years, std::uint64_t seed) {
  const PartLibrary& library = PartLibrary::shipped();
  const PersonAxes axes = person_axes(library, KeyedChance(seed), 0.5, years);
  std::map<std::string, double> shares;
  for (std::size_t i = 0; i < axes.archetypes.size(); ++i)
    if (axes.archetypes[i] > 0) shares[library.archetypes()[i].name] = axes.archetypes[i];
  return shares;
}

TEST(PersonAxes, AgePicksTheSmallChildAndTheAged) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    EXPECT_NEAR(shares_at(5, seed).at("small_child"), 1, 1e-12);
    EXPECT_FALSE(shares_at(5, seed).contains("aged"));
    EXPECT_NEAR(shares_at(85, seed).at("aged"), 1, 1e-12);
    EXPECT_FALSE(shares_at(85, seed).contains("small_child"));
    const auto grown = shares_at(30, seed);
    EXPECT_FALSE(grown.contains("small_child") || grown.contains("aged"));
  }
}

TEST(PersonAxes, PeopleAreMostlyOneOfTwoArchetypes) {
  std::map<std::string, int> first;
  constexpr int kPeople = 2000;
  for (std::uint64_t seed = 0; seed < kPeople; ++seed) {
    const auto shares = shares_at(30, seed);
    ASSERT_EQ(shares.size(), 2u) << seed;
    const auto most =
        std::max_element(shares.begin(), shares.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_GE(most->second, 0.7);
    EXPECT_NEAR(shares.begin()->second + shares.rbegin()->second, 1, 1e-12);
    ++first[most->first];
  }
  for (const Archetype& one : PartLibrary::shipped().archetypes())
    if (one.drawn) {
      EXPECT_GT(first[one.name], kPeople / 40) << one.name;
      EXPECT_LT(first[one.name], kPeople / 4) << one.name;
    }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto mean = [](const std::vector<double>& of) {
    return std::accumulate(of.begin(), of.end(), 0.0) / double(of.size());
  };
  const double of_a = mean(a), of_b = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    ab += (a[i] - of_a) * (b[i] - of_b), aa += (a[i] - of_a) * (a[i] - of_a),
        bb += (b[i] - of_b) * (b[i] - of_b);
  return ab / std::sqrt(aa * bb);
}

// Chins low, eyes high, noses long, necks long: long heads are long in all of it.
TEST(PersonAxes, NumbersOfAHeadMoveTogether) {
  std::map<std::string, std::vector<double>> of;
  for (int i = 0; i < 1000; ++i) {
    const Recipe recipe = recipe_from_seed(std::uint64_t(i));
    if (recipe.numbers.at("age") < 20) continue;
    for (const char* name : {"chin", "eye.y", "nose.length", "neck.length", "eye.size", "cheek"})
      of[name].push_back(recipe.numbers.at(name));
  }
  EXPECT_LT(correlation(of["chin"], of["nose.length"]), -0.4);
  EXPECT_LT(correlation(of["chin"], of["neck.length"]), -0.3);
  EXPECT_LT(correlation(of["chin"], of["eye.y"]), -0.3);
  EXPECT_LT(correlation(of["eye.y"], of["eye.size"]), -0.3);
  EXPECT_GT(correlation(of["chin"], of["cheek"]), 0.3);
}

/// Two kinds of heads; a third, which only wide ones have.
std::string with_archetypes(const std::string& more) {
  return with(
      SmallLibrary{}.topology, "\"skin_tones\"",
      R"("archetypes": {"wide": {"number": 1, "tickets": {"any": 8}, "numbers": {"size": 2}},
      "low": {"number": 2, "tickets": {"any": 8}, "numbers": {"apart": -1}})" +
          more + "}, \"skin_tones\"");
}

PersonAxes person_of(const PartLibrary& library, std::uint64_t seed) {
  return person_axes(library, KeyedChance(seed), 0.5, 30);
}

TEST(PersonAxes, AnArchetypeMoreChangesOnlyWhoeverWinsIt) {
  SmallLibrary small;
  small.topology = with_archetypes("");
  const auto two = small.read().value();
  small.topology =
      with_archetypes(R"(, "high": {"number": 3, "tickets": {"any": 4}, "numbers": {"apart": 1}})");
  const auto three = small.read().value();
  int won = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const PersonAxes before = person_of(*two, seed), after = person_of(*three, seed);
    if (after.archetypes[2] > 0) {
      ++won;
      continue;
    }
    EXPECT_EQ(after.archetypes[0], before.archetypes[0]);
    EXPECT_EQ(archetypes_add(*three, after, 1), archetypes_add(*two, before, 1));
  }
  EXPECT_GT(won, 300);
  EXPECT_LT(won, 700);
}

TEST(PersonAxes, LawsMaySpeakOfArchetypes) {
  SmallLibrary small;
  small.topology = with(with_archetypes(""), "\"spread\": 0.5", "\"wide\": 0.25");
  const auto library = small.read().value();
  const LibraryNumber& size = *library->find_number("size");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PersonAxes person = person_of(*library, seed);
    EXPECT_EQ(person.sum(*library, size.law.in(), *size.law.node), 0.25 * person.archetypes[0]);
  }
  small.topology = with(with_archetypes(""), "\"spread\": 0.5", "\"wode\": 0.25");
  const auto wrong = small.read().value();
  const LibraryNumber& law = *wrong->find_number("size");
  try {
    person_of(*wrong, 1).sum(*wrong, law.law.in(), *law.law.node);
    FAIL() << "an unknown axis was read";
  } catch (const Refusal& refusal) {
    EXPECT_NE(refusal.error.what.find("did you mean \"wide\""), std::string::npos)
        << refusal.error.what;
  }
}

}  // namespace
}  // namespace mien
