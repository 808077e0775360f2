#include "lib/rig/pose/drive.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

Layout two_points() {
  Layout layout;
  layout.add("a/0", SliceKind::point, 2);
  layout.add("a/1", SliceKind::point, 2);
  return layout;
}

TEST(Drive, OffsetsFromRest) {
  FaceVector v{1, 2, 3, 4};
  drive({.rest = 1, .lo = 0, .hi = 4, .drives = {Offset{1, {10, -1}}}}, 3, two_points(), v);
  EXPECT_EQ(v, (FaceVector{1, 2, 23, 2}));
}

TEST(Drive, ScalesByItsValue) {
  FaceVector v{1, 2, 3, 4};
  drive({.rest = 1, .lo = 0, .hi = 4, .drives = {Scale{0}}}, 3, two_points(), v);
  EXPECT_EQ(v, (FaceVector{3, 6, 3, 4}));
}

TEST(Drive, KeyShapesAreExactAtKeysAndStraightBetween) {
  const KeyShapes table{{0, 0.3, 1}, {{0, {{.from = 0}, {-1, {7, 8}}, {-1, {0.1, 0.2}}}}}};
  const Channel channel{.rest = 0, .lo = -1, .hi = 2, .drives = {table}};
  const auto at = [&](double value) {
    FaceVector v{1, 2, 3, 4};
    drive(channel, value, two_points(), v);
    return v;
  };
  EXPECT_EQ(at(0), (FaceVector{1, 2, 3, 4}));
  EXPECT_EQ(at(0.15), (FaceVector{4, 5, 3, 4}));
  EXPECT_EQ(at(0.3), (FaceVector{7, 8, 3, 4}));
  EXPECT_EQ(at(1), (FaceVector{0.1, 0.2, 3, 4}));
  EXPECT_EQ(at(-1), at(0));
  EXPECT_EQ(at(2), at(1));
}

/// Two slices may change places: a table reads all before it writes any.
TEST(Drive, KeyShapesFollowOtherSlices) {
  const KeyShapes swap{{0, 1}, {{0, {{.from = 0}, {.from = 1}}}, {1, {{.from = 1}, {.from = 0}}}}};
  FaceVector v{1, 2, 3, 4};
  drive({.rest = 0, .lo = 0, .hi = 1, .drives = {swap}}, 1, two_points(), v);
  EXPECT_EQ(v, (FaceVector{3, 4, 1, 2}));
}

TEST(Drive, ActsInOrder) {
  const Channel channel{.rest = 1, .lo = 0, .hi = 4, .drives = {Offset{0, {1, 1}}, Scale{0}}};
  FaceVector v{1, 2, 0, 0};
  drive(channel, 2, two_points(), v);
  EXPECT_EQ(v, (FaceVector{4, 6, 0, 0}));
}

}  // namespace
}  // namespace mien
