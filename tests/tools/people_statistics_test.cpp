// What the sampling law gives, beside what is asked of it.

#include "tools/mien/people/people_statistics.h"

#include <mien/crowd.h>
#include <mien/recipe.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace mien::command {
namespace {

const PeopleStatistics& measured() {
  static const PeopleStatistics all = people_statistics(crowd("statistics", 100));
  return all;
}

bool is_drawn(const std::string& family, const std::string& begin) {
  return std::ranges::any_of(part_families(), [&](const PartFamily& one) {
    return one.name == family && std::ranges::any_of(one.parts, [&](const auto& part) {
             return part.starts_with(begin);
           });
  });
}

TEST(PeopleStatistics, TheLawGivesWhatIsAsked) {
  int asked = 0;
  for (const PeopleCount& one : measured().counts) {
    asked += one.asked.has_value();
    if (one.name == "eye_patch" && !is_drawn("aid", "eye_patch")) continue;
    EXPECT_FALSE(one.missed()) << one.group << " " << one.name << ": " << one.law.share();
  }
  EXPECT_EQ(asked, 5 + 10 + 2 + 3 + 2 + 4);
  EXPECT_GE(measured().least_difference, 3.5);
  EXPECT_GT(measured().median_difference, 6);
}

TEST(PeopleStatistics, EverybodyIsInOneLineOfAGroup) {
  std::map<std::string, int> here, law;
  for (const PeopleCount& one : measured().counts)
    here[one.group] += one.here.count, law[one.group] += one.law.count;
  for (const PartFamily& family : part_families()) {
    EXPECT_EQ(here[family.name], 100) << family.name;
    EXPECT_EQ(law[family.name], measured().drawn) << family.name;
  }
  for (const char* group : {"age", "skin.tone", "lean"}) EXPECT_EQ(here[group], 100) << group;
}

TEST(PeopleStatistics, AMissIsSeen) {
  PeopleCount one{"worn", "hats", {}, {1800, 10000}, AskedShare{0.18, 0.18}};
  EXPECT_FALSE(one.missed());
  one.law.count = 1800 + 110;  // three standard errors are 115
  EXPECT_FALSE(one.missed());
  one.law.count = 1800 + 120;
  EXPECT_TRUE(one.missed());
  one.asked.reset();
  EXPECT_FALSE(one.missed());
}

TEST(PeopleStatistics, OnePersonHasNoDifference) {
  const PeopleStatistics one = people_statistics(crowd("1", 1));
  EXPECT_EQ(one.least_difference, 0);
  EXPECT_EQ(statistics_table(one).find("difference"), std::string::npos);
}

}  // namespace
}  // namespace mien::command
