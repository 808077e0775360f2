#include "sdf/arrange/regions.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/shapes/arranged.h"

namespace mien::test {
namespace {

TEST(Regions, TheFirstIsInsideOfNothing) {
  SetRule rule(3);
  Regions regions;
  regions.begin(3, rule);
  EXPECT_EQ(regions.count(), 1);
  EXPECT_EQ(regions.look(0), 0);
  for (int outline = 0; outline < 3; ++outline) EXPECT_FALSE(regions.inside(0, outline));
}

TEST(Regions, CrossingAnOutlineTwiceLeadsBack) {
  SetRule rule(3);
  Regions regions;
  regions.begin(3, rule);
  const int in = regions.across(0, 1);
  EXPECT_TRUE(regions.inside(in, 1));
  EXPECT_FALSE(regions.inside(in, 0));
  EXPECT_EQ(regions.across(in, 1), 0);
}

TEST(Regions, TheOrderOfCrossingsIsOfNoMatter) {
  SetRule rule(200);
  Regions regions;
  regions.begin(200, rule);
  const int there = regions.across(regions.across(regions.across(0, 7), 64), 199);
  EXPECT_EQ(regions.across(regions.across(regions.across(0, 199), 7), 64), there);
  EXPECT_EQ(regions.across(regions.across(regions.across(there, 64), 199), 7), 0);
}

TEST(Regions, EverySetIsOneRegionWithItsOwnLook) {
  constexpr int kOutlines = 130;
  SetRule rule(kOutlines);
  Regions regions;
  regions.begin(kOutlines, rule);
  std::map<std::set<int>, int> known{{{}, 0}};
  Random r(1);
  std::set<int> set;
  for (int i = 0, region = 0; i < 20'000; ++i) {
    const int outline = r.below(kOutlines);
    region = regions.across(region, outline);
    if (!set.erase(outline)) set.insert(outline);
    const auto [at, is_new] = known.try_emplace(set, region);
    ASSERT_EQ(at->second, region);
    ASSERT_EQ(regions.inside(region, outline), set.contains(outline));
    if (set.size() > 6) region = 0, set.clear();
  }
  EXPECT_GT(regions.count(), 5000);  // the table has grown
  EXPECT_EQ(regions.count(), int(known.size()));
  for (const auto& [members, region] : known)
    for (int outline = 0; outline < kOutlines; ++outline)
      ASSERT_EQ(regions.inside(region, outline), members.contains(outline));
  std::set<int> looks;
  for (int i = 0; i < regions.count(); ++i) looks.insert(regions.look(i));
  EXPECT_EQ(int(looks.size()), regions.count());
}

TEST(Regions, TheRuleIsAskedOnceForEach) {
  SetRule rule(8);
  Regions regions;
  regions.begin(8, rule);
  Random r(2);
  for (int i = 0, region = 0; i < 10'000; ++i) region = regions.across(region, r.below(8));
  EXPECT_EQ(regions.count(), 256);
  EXPECT_EQ(rule.asked, 255);
  EXPECT_TRUE(rule.counts_right) << "the words were not those of the region come from";
}

TEST(Regions, BeginningAnewForgetsAll) {
  SetRule many(90), few(2);
  Regions regions;
  regions.begin(90, many);
  for (int i = 0, region = 0; i < 90; ++i) region = regions.across(region, i);
  regions.begin(2, few);
  EXPECT_EQ(regions.count(), 1);
  EXPECT_EQ(regions.look(regions.across(0, 1)), 1);
  EXPECT_EQ(regions.count(), 2);
}

TEST(Regions, APictureWithoutOutlinesHasOne) {
  SetRule rule(0);
  Regions regions;
  regions.begin(0, rule);
  EXPECT_EQ(regions.count(), 1);
}

}  // namespace
}  // namespace mien::test
