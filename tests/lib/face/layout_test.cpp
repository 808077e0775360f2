#include <mien/layout.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace mien {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndlessRange = std::numeric_limits<double>::infinity();

Layout sample() {
  Layout layout;
  layout.add("brow/spine/0", SliceKind::point, 2);
  layout.add("brow/half_width", SliceKind::length, 1);
  layout.add("iris/tilt", SliceKind::angle, 1);
  layout.add("palette/skin", SliceKind::color, 4);
  return layout;
}

TEST(Layout, NamesEveryNumberOnce) {
  const Layout layout = sample();
  EXPECT_EQ(layout.size(), 8u);
  int next = 0;
  for (std::size_t i = 0; i < layout.slices().size(); ++i) {
    EXPECT_EQ(layout.slices()[i].begin, next);
    EXPECT_EQ(layout.find(layout.slices()[i].name), int(i));
    next += layout.slices()[i].size;
  }
  EXPECT_EQ(layout.find("brow"), -1);
}

TEST(Layout, TakesNamesInPartsAndKeepsThem) {
  Layout copy;
  {
    Layout layout = sample();
    std::string feature = "brow.left";
    EXPECT_EQ(layout.add({feature, "/", "spine/0"}, SliceKind::point, 2), 4);
    feature = "something else";
    copy = layout;
    layout.add("of the first alone", SliceKind::angle, 1);
    copy.add("of the copy alone", SliceKind::angle, 1);
    EXPECT_EQ(layout.find("of the copy alone"), -1);
  }
  EXPECT_EQ(copy[4].name, "brow.left/spine/0");
  EXPECT_EQ(copy.find("brow.left/spine/0"), 4);
  EXPECT_EQ(copy[5].name, "of the copy alone");
  EXPECT_EQ(copy.find("of the first alone"), -1);
}

TEST(Layout, FindsEachOfThousands) {
  Layout layout;
  for (int i = 0; i < 5000; ++i) layout.add(std::to_string(i), SliceKind::ratio, 1);
  for (int i = 0; i < 5000; ++i) EXPECT_EQ(layout.find(std::to_string(i)), i);
  EXPECT_EQ(layout.find("5000"), -1);
}

TEST(Rules, ClampWrapOrLeave) {
  const Layout layout = sample();
  const FaceVector rest{0, 0, 1, 0, 0, 0, 0, 1};
  FaceVector v{-5e8, 5, -0.25, 190, 1.5, -0.5, 0.5, 2};
  apply_rules(layout, rest, v);
  EXPECT_EQ(v, (FaceVector{-5e8, 5, 0, -170, 1, 0, 0.5, 1}));
}

TEST(Rules, MakeAnythingValid) {
  const Layout layout = sample();
  const FaceVector rest{3, 4, 1, 7, 0, 0, 0, 1};
  FaceVector v{kNotANumber,   kEndlessRange, -kEndlessRange, kNotANumber,
               kEndlessRange, kNotANumber,   -kEndlessRange, kNotANumber};
  apply_rules(layout, rest, v);
  EXPECT_EQ(v, (FaceVector{3, 1e9, 0, 7, 1, 0, 0, 1}));
}

TEST(Rules, WrapStaysInRangeAtItsEnds) {
  const Layout layout = sample();
  const FaceVector rest(8, 0.0);
  for (const double angle :
       {180.0, -180.0, 540.0, std::nextafter(-180.0, -181.0), 1e9, -1e9, 179.99999999999997}) {
    FaceVector v = rest;
    v[3] = angle;
    apply_rules(layout, rest, v);
    EXPECT_GE(v[3], -180) << angle;
    EXPECT_LT(v[3], 180) << angle;
  }
}

TEST(Rules, LeaveEveryBitOfWhatIsInRange) {
  const Layout layout = sample();
  FaceVector v{-0.0, 1e-300, 5e-324, -180, 0.1, 0.2, 0.3, 1};
  const FaceVector before = v;
  apply_rules(layout, FaceVector(8, 0.0), v);
  for (std::size_t i = 0; i < v.size(); ++i)
    EXPECT_TRUE(v[i] == before[i] && std::signbit(v[i]) == std::signbit(before[i]));
}

}  // namespace
}  // namespace mien
