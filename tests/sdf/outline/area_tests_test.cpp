#include "sdf/outline/area_tests.h"

#include "lib/base/watch.h"
#include "tests/support/process/runs_true.h"
#include "tests/support/random/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace mien::test {
namespace {

using Kind = AreaStep::Kind;

/// Outlines of two words: 0 to 3 and 64 to 67.
void add_random(Random& r, int depth, std::vector<AreaStep>& to) {
  if (depth == 0 || r.chance(0.2)) {
    if (r.chance(0.05))
      to.push_back({Kind::nothing});
    else
      to.push_back({Kind::outline, r.below(4) + (r.chance(0.3) ? 64 : 0)});
  } else {
    add_random(r, depth - 1, to);
    add_random(r, depth - 1, to);
    to.push_back({r.chance(0.5) ? Kind::and_ : Kind::or_});
  }
  if (r.chance(0.25)) to.push_back({Kind::not_});
}

TEST(AreaTests, HoldWhereTheProgramDoes) {
  Random r(5);
  AreaTests tests;
  for (int k = 0; k < 3000; ++k) {
    std::vector<AreaStep> program;
    add_random(r, 1 + k % 6, program);
    if (k % 50 == 0) tests.clear();
    const AreaTests::Start start = tests.add(program);
    for (std::uint64_t bits = 0; bits < 256; ++bits) {
      const std::uint64_t inside[] = {bits & 15, bits >> 4};
      ASSERT_EQ(tests.holds(start, inside), runs_true(program, inside)) << k << ' ' << bits;
    }
  }
}

/// How many tests the answer takes, as work.
std::int64_t asked(const AreaTests& tests, AreaTests::Start start, std::uint64_t inside) {
  Watch watch;
  {
    const Watching here(&watch);
    tests.holds(start, &inside);
  }
  return watch.steps();
}

TEST(AreaTests, AUnionCutToAnAreaTakesATestForTheUnionAndOneForWhatCuts) {
  const std::vector<AreaStep> program{{Kind::outline, 0}, {Kind::outline, 1}, {Kind::or_},
                                      {Kind::outline, 2}, {Kind::or_},        {Kind::outline, 3},
                                      {Kind::and_},       {Kind::outline, 4}, {Kind::outline, 5},
                                      {Kind::or_},        {Kind::not_},       {Kind::and_}};
  AreaTests tests;
  const AreaTests::Start start = tests.add(program);
  EXPECT_EQ(asked(tests, start, 0), 1) << "outside of the union nothing else is asked";
  EXPECT_EQ(asked(tests, start, 0b001010), 2);
}

TEST(AreaTests, AUnionOfCutAreasTakesTwoTestsForEach) {
  std::vector<AreaStep> program;
  for (int i = 0; i < 8; ++i) {
    program.insert(program.end(), {{Kind::outline, 3 * i},
                                   {Kind::outline, 3 * i + 1},
                                   {Kind::and_},
                                   {Kind::outline, 3 * i + 2},
                                   {Kind::not_},
                                   {Kind::and_}});
    if (i > 0) program.push_back({Kind::or_});
  }
  AreaTests tests;
  const AreaTests::Start start = tests.add(program);
  EXPECT_EQ(asked(tests, start, 0), 8) << "an intersection is one test";
  EXPECT_EQ(asked(tests, start, 0b011), 1);
}

TEST(AreaTests, AProgramMayBeAsDeepAsItLikes) {
  constexpr int kDepth = 300000;
  std::vector<AreaStep> program;
  for (int i = 0; i < kDepth; ++i) program.push_back({Kind::outline, i % 64});
  for (int i = 1; i < kDepth; ++i) program.push_back({i % 3 ? Kind::or_ : Kind::and_});
  AreaTests tests;
  const AreaTests::Start start = tests.add(program);
  for (const std::uint64_t inside : {std::uint64_t{0}, ~std::uint64_t{0}, std::uint64_t{0x5555}})
    EXPECT_EQ(tests.holds(start, &inside), runs_true(program, &inside)) << inside;
}

TEST(AreaTests, WithoutAStepAllIsInside) {
  AreaTests tests;
  const std::uint64_t nothing = 0;
  EXPECT_TRUE(tests.holds(tests.add({}), &nothing));
}

}  // namespace
}  // namespace mien::test
