#include "render/image/png/run_matcher.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/pictures/unpacked.h"

namespace mien {
namespace {

struct Told {
  std::string bytes;
  std::vector<DeflateToken> tokens;
};

void add(RunMatcher& matcher, std::string& bytes, std::uint64_t pixel, std::size_t size,
         std::size_t count) {
  matcher.add(pixel, size * count);
  for (std::size_t i = 0; i < size * count; ++i) bytes += char(pixel >> 8 * (i % size) & 255);
}

/// Rows of runs as dice have them: few colours, many of the row above.
Told random_rows(RunMatcher& matcher, std::size_t size, unsigned seed) {
  std::mt19937 dice(seed);
  Told told;
  const std::uint64_t mask = ~std::uint64_t(0) >> (64 - 8 * size);
  const std::size_t longest = std::size_t(1) << dice() % 11;
  std::vector<std::pair<std::uint64_t, std::size_t>> row;
  matcher.begin();
  for (int y = 0; y < 30; ++y) {
    if (y % 3 == 0) row.clear();
    for (int i = 0; i < 20; ++i) {
      if (y % 3 == 0)
        row.push_back({(dice() % 7) * 0x9e3779b97f4a7c15u & mask, 1 + dice() % longest});
      else if (dice() % 5 == 0)
        row[std::size_t(i)].second = 1 + dice() % longest;
    }
    add(matcher, told.bytes, dice() % 3, 1, 1);
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::size_t count = row[i].second;
      while (i + 1 < row.size() && row[i + 1].first == row[i].first) count += row[++i].second;
      add(matcher, told.bytes, row[i].first, size, count);
    }
    matcher.end_row(told.tokens);
  }
  return told;
}

TEST(RunMatcher, TokensAreTheRows) {
  for (const std::size_t size : {3, 4, 6, 8}) {
    RunMatcher matcher(size);
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Told told = random_rows(matcher, size, seed);
      ASSERT_TRUE(test::expanded(told.tokens) == told.bytes) << size << " " << seed;
    }
  }
}

TEST(RunMatcher, AStripStandsForItself) {
  RunMatcher used(3), fresh(3);
  random_rows(used, 3, 1);
  EXPECT_EQ(random_rows(used, 3, 2).tokens, random_rows(fresh, 3, 2).tokens);
}

TEST(RunMatcher, RowsLikeTheOneAboveAreAMatchAndRuns) {
  RunMatcher matcher(3);
  Told told;
  matcher.begin();
  for (int y = 0; y < 2; ++y) {
    told.tokens.clear();
    add(matcher, told.bytes, 0, 1, 1);
    for (const std::uint64_t pixel : {0x112233, 0x445566, 0x778899, 0xaabbcc})
      add(matcher, told.bytes, pixel, 3, 20);
    matcher.end_row(told.tokens);
  }
  EXPECT_EQ(told.tokens, (std::vector{deflate_match(241, 241)}));
}

}  // namespace
}  // namespace mien
