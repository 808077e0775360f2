#include "sdf/outline/area_clauses.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace mien::test {
namespace {

using Kind = AreaStep::Kind;

bool holds(const AreaClauses& clauses, std::uint64_t inside) {
  bool all = true, any = true;
  for (std::size_t i = 0; i < clauses.literals().size(); ++i) {
    const int literal = clauses.literals()[i];
    if (clauses.begins(i)) all = all && any, any = false;
    const bool in = inside >> (literal < 0 ? ~literal : literal) & 1;
    any = any || in == (literal >= 0);
  }
  return all && any;
}

void add_random(Random& r, int depth, std::vector<AreaStep>& to) {
  if (depth == 0 || r.chance(0.3)) {
    to.push_back({Kind::outline, r.below(8)});
  } else {
    add_random(r, depth - 1, to);
    add_random(r, depth - 1, to);
    to.push_back({r.chance(0.5) ? Kind::and_ : Kind::or_});
  }
  if (r.chance(0.25)) to.push_back({Kind::not_});
}

TEST(AreaClauses, HoldWhereTheProgramDoes) {
  Random r(5);
  int read = 0;
  std::vector<char> stack;
  for (int k = 0; k < 2000; ++k) {
    std::vector<AreaStep> program;
    add_random(r, 3, program);
    for (const bool opposite : {false, true}) {
      AreaClauses clauses;
      if (!clauses.read(program, opposite)) continue;
      ++read;
      for (std::uint64_t inside = 0; inside < 256; ++inside)
        ASSERT_EQ(holds(clauses, inside) != opposite, runs_true(program, &inside, stack))
            << k << ' ' << inside;
    }
  }
  EXPECT_GT(read, 500);
}

TEST(AreaClauses, ReadAUnionCutToAnArea) {
  const std::vector<AreaStep> program{{Kind::outline, 0}, {Kind::outline, 1}, {Kind::or_},
                                      {Kind::outline, 2}, {Kind::or_},        {Kind::outline, 3},
                                      {Kind::and_},       {Kind::outline, 4}, {Kind::outline, 5},
                                      {Kind::or_},        {Kind::not_},       {Kind::and_}};
  AreaClauses clauses;
  ASSERT_TRUE(clauses.read(program));
  EXPECT_EQ(std::vector<int>(clauses.literals().begin(), clauses.literals().end()),
            (std::vector<int>{0, 1, 2, 3, ~4, ~5}));
  const bool begins[] = {true, false, false, true, true, true};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(clauses.begins(i), begins[i]);
}

}  // namespace
}  // namespace mien::test
