#include <mien/sdf/edge/classify_frame.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

const QuadBezier kSpine{{10, 20}, {40, 70}, {90, 20}};

TEST(ClassifyFrame, IsRelativeToTheOrigin) {
  const auto f = classify_frame({HalfPlane{{0.6, 0.8}, 1e6 + 0.25}}, {0.6e6, 0.8e6});
  EXPECT_EQ(std::get<HalfPlaneSquares>(f).offset, 0.25f);
  const auto disc = std::get<SegmentSquares>(classify_frame({Disc{{1e7, 3}, 2}, 1.5}, {1e7, 0}));
  EXPECT_EQ(disc.x0, 0);
  EXPECT_EQ(disc.y0, 3);
  EXPECT_EQ(disc.length, 0);
  EXPECT_EQ(disc.half_width, 3.5f);
}

TEST(ClassifyFrame, AStrokeKnowsItsWidestPlaceAndItsSteepestOne) {
  const auto even = std::get<StrokeSquares>(classify_frame({QuadStroke{kSpine, 3}}, {0, 0}));
  EXPECT_FLOAT_EQ(even.widest, 3);
  EXPECT_FLOAT_EQ(even.keep, 1);
  const TaperedStroke swelling{kSpine, {1, 9, 3}};
  const auto f = std::get<StrokeSquares>(classify_frame({swelling}, {0, 0}));
  double widest = 0, steepest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0, s = 1 - t;
    widest = std::max(widest, s * s * 1 + 2 * s * t * 9 + t * t * 3);
    const glm::dvec2 v = tangent(kSpine, t);
    steepest = std::max(steepest, std::abs(2 * (s * 8 - t * 6)) / std::hypot(v.x, v.y));
  }
  EXPECT_NEAR(f.widest, widest, 1e-4);
  EXPECT_GE(f.widest, widest);
  EXPECT_LE(f.keep, 1 - 2 * steepest);
  EXPECT_GE(f.keep, 1 - 2.2 * steepest);
}

TEST(ClassifyFrame, WhatHasNoFloatFormKeepsItsOwnDistance) {
  const auto any = [](const OffsetShape& s) {
    return std::holds_alternative<AnySquares>(classify_frame(s, {0, 0}));
  };
  EXPECT_TRUE(any({Triangle{{0, 0}, {1, 0}, {0, 1}}}));
  EXPECT_TRUE(any({Ellipse{{0, 0}, {3, 2}}, 0.5}));
  EXPECT_TRUE(any({Ellipse{{0, 0}, {3, 0}}}));
  EXPECT_FALSE(any({Ellipse{{0, 0}, {3, 2}}}));
  EXPECT_FALSE(any({QuadStroke{{{1, 1}, {1, 1}, {1, 1}}, 2}}));
}

}  // namespace
}  // namespace mien
