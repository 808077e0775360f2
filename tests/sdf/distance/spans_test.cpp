#include "sdf/distance/spans.h"

#include <gtest/gtest.h>

namespace mien::batch {
namespace {

TEST(Spans, EqualOrApartAreAccepted) {
  float a[8], b[8], c[8];
  require_spans("f", {a, 8, 4}, {b, 8, 4}, {c, 8, 4});
  require_spans("f", {a, 8, 4}, {b, 8, 4}, {a, 8, 4});
  require_spans("f", {a, 4, 4}, {b, 4, 4}, {a + 4, 4, 4});
  require_spans("f", {nullptr, 0, 4}, {nullptr, 0, 4}, {nullptr, 0, 4});
}

TEST(SpansDeathTest, OverlapAndUnequalLengthsEndTheProgramWithASentence) {
  float a[8], b[8], c[8];
  EXPECT_DEATH(require_spans("f", {a, 4, 4}, {b, 4, 4}, {a + 1, 4, 4}),
               "mien::f: the output overlaps");
  EXPECT_DEATH(require_spans("f", {a + 1, 4, 4}, {b, 4, 4}, {a, 4, 4}), "overlaps an input");
  EXPECT_DEATH(require_spans("f", {a, 4, 4}, {b + 3, 4, 4}, {b, 4, 4}), "overlaps an input");
  EXPECT_DEATH(require_spans("f", {a, 4, 4}, {b, 4, 4}, {a, 4, 8}), "overlaps an input");
  EXPECT_DEATH(require_spans("f", {a, 4, 4}, {b, 3, 4}, {c, 4, 4}), "equal length");
}

}  // namespace
}  // namespace mien::batch
