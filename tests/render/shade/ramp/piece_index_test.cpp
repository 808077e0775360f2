#include "render/shade/ramp/piece_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random.h"

namespace mien::test {
namespace {

TEST(PieceIndex, FindsThePieceOfEveryPlace) {
  Random r(3);
  for (int i = 0; i < 300; ++i) {
    std::vector<double> begins{0.0};
    const int count = int(r.between(1, 60));
    // Some lie close together, many in one bucket.
    for (int k = 1; k < count; ++k)
      begins.push_back(begins.back() + std::pow(10, r.between(-6, 0)));
    const bool repeats = i % 2 == 1;
    const double end = begins.back() + 0.5;
    PieceIndex index;
    index.make(begins, repeats ? end : 0.0);
    ASSERT_EQ(index.size(), begins.size());
    for (int k = 0; k < 200; ++k) {
      const double at =
          k % 2 ? r.between(-3 * end, 3 * end) : begins[std::size_t(r.between(0, count - 0.001))];
      const double in = repeats ? at - end * std::floor(at / end) : at;
      double s = at;
      const std::size_t piece = index.find(s);
      ASSERT_NEAR(begins[piece] + s, in, 1e-12);
      ASSERT_TRUE(piece == 0 || s >= 0.0);
      ASSERT_TRUE(piece + 1 == begins.size() || begins[piece + 1] > in - 1e-12);
    }
  }
}

TEST(PieceIndex, TakesWhatIsNoPlaceForSome) {
  PieceIndex index;
  index.make({0.0, 0.5}, 1.0);
  for (double s : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300})
    EXPECT_LT(index.find(s), 2u);
}

}  // namespace
}  // namespace mien::test
