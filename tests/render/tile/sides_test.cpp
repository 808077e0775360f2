#include <mien/render/tile/sides.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

using Kind = Step::Kind;

TEST(SidesOf, IsTheProgramOnEverySquareAtOnce) {
  // Squares by bit: 0 in both, 1 in a alone, 2 in b alone, 3 out of both, 4 unknown in a and in b,
  // 5 unknown in a and out of b.
  const std::vector<Sides> outlines{{0b000011, 0b001100}, {0b010101, 0b101010}};
  std::vector<Sides> stack;
  const auto run = [&](std::vector<Step> steps) { return sides_of(steps, outlines, stack); };
  const Step a{Kind::outline, 0}, b{Kind::outline, 1};
  const auto low = [](std::uint64_t bits) { return bits & 0b111111; };

  const Sides both = run({a, b, {Kind::and_}});
  EXPECT_EQ(low(both.in), 0b000001u);
  EXPECT_EQ(low(both.out), 0b101110u);
  EXPECT_EQ(low(both.unknown()), 0b010000u);

  const Sides either = run({a, b, {Kind::or_}});
  EXPECT_EQ(low(either.in), 0b010111u);
  EXPECT_EQ(low(either.out), 0b001000u);

  const Sides without = run({a, b, {Kind::not_}, {Kind::and_}});
  EXPECT_EQ(low(without.in), 0b000010u);
  EXPECT_EQ(low(without.out), 0b011101u);

  EXPECT_EQ(run({}).in, ~std::uint64_t{0});
  EXPECT_EQ(run({{Kind::nothing}}).out, ~std::uint64_t{0});
}

}  // namespace
}  // namespace mien
