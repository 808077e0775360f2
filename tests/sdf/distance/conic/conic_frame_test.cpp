#include "sdf/distance/conic/conic_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mien::batch {
namespace {

TEST(EllipseFrame, TheLongerRadiusComesFirstAndIsAboutOne) {
  for (const double size : {1e-20, 0.3, 1.0, 1e12}) {
    const auto f = ellipse_frame<float>({{1, 2}, {0.25 * size, size}, {1, 0}});
    ASSERT_TRUE(f);
    EXPECT_GE(f->a, 0.5);
    EXPECT_LT(f->a, 1);
    EXPECT_FLOAT_EQ(f->b, 0.25f * f->a);
    EXPECT_FLOAT_EQ(f->focal, f->a * f->a - f->b * f->b);
    EXPECT_EQ(f->axis_x, 0);
    EXPECT_EQ(f->axis_y, 1);
    EXPECT_EQ(f->scale * f->unscale, 1);
  }
}

TEST(EllipseFrame, ThinOnesAndNonsenseHaveNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(ellipse_frame<float>({{0, 0}, {1, 2e-3}}));
  EXPECT_FALSE(ellipse_frame<float>({{0, 0}, {1, 0.5e-3}}));
  EXPECT_FALSE(ellipse_frame<float>({{0, 0}, {0, 0}}));
  EXPECT_FALSE(ellipse_frame<float>({{nan, 0}, {1, 1}}));
  EXPECT_FALSE(ellipse_frame<float>({{0, 0}, {1, nan}}));
}

TEST(ParabolaFrame, AStraightSideHasNoneAndADownwardOneIsMirrored) {
  EXPECT_FALSE(parabola_frame<float>({{0, 0}, {0, 1}, 0}));
  EXPECT_FALSE(parabola_frame<float>({{0, 0}, {0, 1}, std::numeric_limits<double>::infinity()}));
  const auto f = parabola_frame<float>({{0, 0}, {0, 1}, -3});
  ASSERT_TRUE(f);
  EXPECT_TRUE(f->mirrored);
  EXPECT_EQ(f->axis_y, -1);
  EXPECT_EQ(f->scale, 3);
}

}  // namespace
}  // namespace mien::batch
