#include <mien/slice.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mien {
namespace {

constexpr SliceKind kAllKinds[] = {SliceKind::point, SliceKind::length, SliceKind::ratio,
                                   SliceKind::angle, SliceKind::frame,  SliceKind::parabola,
                                   SliceKind::color};

int size_of(SliceKind kind) {
  return kind == SliceKind::color                                ? 4
         : kind == SliceKind::length || kind == SliceKind::angle ? 1
                                                                 : 2;
}

TEST(MirrorValues, TwiceIsNothing) {
  for (const SliceKind kind : kAllKinds) {
    std::vector<double> values{0.25, 0.5, 0.125, 1};
    values.resize(std::size_t(size_of(kind)));
    std::vector<double> mirrored = values;
    mirror_values(kind, mirrored, 1);
    mirror_values(kind, mirrored, 1);
    EXPECT_EQ(mirrored, values) << kind_name(kind);
  }
}

TEST(MirrorValues, TakesPointsAcrossTheAxis) {
  std::vector<double> point{0.25, 7};
  mirror_values(SliceKind::point, point, 1);
  EXPECT_EQ(point, (std::vector<double>{0.75, 7}));
  mirror_differences(SliceKind::point, point, 1);
  EXPECT_EQ(point, (std::vector<double>{-0.75, 7}));
}

TEST(MirrorValues, LeavesNoNegativeZero) {
  std::vector<double> point{0, 0};
  mirror_values(SliceKind::point, point, 0);
  EXPECT_FALSE(std::signbit(point[0]));
}

/// q of the mirrored frame at the mirrored x is −q, and a parabola in q² does not mind.
TEST(MirrorValues, TakesFramesAcrossTheAxis) {
  std::vector<double> frame{1.8, -0.42};
  mirror_values(SliceKind::frame, frame, 1);
  for (double x = -1; x <= 2; x += 0.125)
    EXPECT_NEAR(frame[0] * (1 - x) + frame[1], 1.8 * x - 0.42, 1e-15);
}

TEST(SliceKind, HasUnitsAndNumberNames) {
  EXPECT_EQ(unit_name(SliceKind::point, "mm"), "mm");
  EXPECT_EQ(unit_name(SliceKind::color, "mm"), "linear light");
  EXPECT_EQ(component_name(SliceKind::point, 1), "y");
  EXPECT_EQ(component_name(SliceKind::color, 3), "a");
  EXPECT_EQ(component_name(SliceKind::length, 2), "2");
  for (const SliceKind kind : kAllKinds)
    EXPECT_FALSE(unit_name(kind, "u").empty() || kind_name(kind).empty());
}

}  // namespace
}  // namespace mien
