#include "render/image/png/deflate_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "tests/support/pictures/unpacked.h"

namespace mien {
namespace {

using Tokens = std::vector<DeflateToken>;

std::vector<std::byte> written(const Tokens& tokens, std::size_t at_once = 1 << 20) {
  DeflateWriter writer;
  for (std::size_t i = 0; i < tokens.size(); i += at_once)
    writer.add(std::span(tokens).subspan(i, std::min(at_once, tokens.size() - i)));
  writer.finish();
  return writer.bytes();
}

void expect_unpacks(const Tokens& tokens) {
  const std::string wanted = test::expanded(tokens);
  EXPECT_TRUE(test::unpacked(written(tokens), wanted.size()) == wanted) << tokens.size();
}

TEST(DeflateWriter, EveryLengthAndDistance) {
  std::mt19937 dice(5);
  Tokens tokens;
  for (std::size_t i = 0; i < kDeflateWindow; ++i) tokens.push_back(DeflateToken(dice() & 255));
  for (std::size_t n = 3; n <= kDeflateLongest; ++n) tokens.push_back(deflate_match(n, n));
  for (std::size_t d = 1; d <= kDeflateWindow; ++d) tokens.push_back(deflate_match(3, d));
  expect_unpacks(tokens);
}

TEST(DeflateWriter, NothingOneThingAndNoDistances) {
  expect_unpacks({});
  expect_unpacks({65});
  expect_unpacks(Tokens(100, 65));
  expect_unpacks({65, deflate_match(258, 1)});
  expect_unpacks(Tokens(1 << 14, 7));
}

/// Counts that grow like Fibonacci's numbers want words of one bit more each.
TEST(DeflateWriter, WordsAreNeverTooLong) {
  Tokens tokens;
  for (std::size_t byte = 0, now = 1, next = 1; byte < 20; ++byte) {
    tokens.insert(tokens.end(), now, DeflateToken(byte));
    now = std::exchange(next, now + next);
  }
  std::shuffle(tokens.begin(), tokens.end(), std::mt19937(3));
  expect_unpacks(tokens);
}

TEST(DeflateWriter, IsWithinAHairOfTheEntropy) {
  std::mt19937 dice(9);
  Tokens tokens;
  std::array<double, 64> counts{};
  for (int i = 0; i < 1 << 14; ++i) {
    const auto byte = std::min<unsigned>(unsigned(std::geometric_distribution(0.1)(dice)), 63);
    tokens.push_back(byte), ++counts[byte];
  }
  double bits = 0;
  for (const double n : counts) bits -= n > 0 ? n * std::log2(n / double(tokens.size())) : 0;
  EXPECT_LT(double(written(tokens).size()), 1.01 * bits / 8 + 100);
}

TEST(DeflateWriter, HowTokensComeChangesNoByte) {
  std::mt19937 dice(2);
  Tokens tokens;
  for (int i = 0; i < 40'000; ++i)
    tokens.push_back(dice() % 3 ? DeflateToken(dice() % 90) : deflate_match(9, 1));
  for (const std::size_t at_once : {1, 77, 16'384, 30'000})
    EXPECT_EQ(written(tokens, at_once), written(tokens));
}

}  // namespace
}  // namespace mien
