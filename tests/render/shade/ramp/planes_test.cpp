#include "render/shade/ramp/planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

const std::vector<Stop> kFine{{0, {0, 0, 0, 1}}, {0.01, {1, 1, 1, 1}}};

/// Pixels of 100 a unit, in most of which a stop lies.
struct Planes {
  PaintTable table;
  LitPaint::Scratch scratch;
  RampPlanes planes;

  explicit Planes(const decltype(Gradient::along)& along) {
    SceneBuilder build({.box = {{0, 0}, {2, 2}}, .y_up = false}, {1, 1, 1, 1});
    build.shape(Triangle{{0.205, 0.2}, {1.805, 0.2}, {1.005, 1.8}});  // area 0
    build.layer(
        "all", build.everywhere(),
        {.color = {0, 0, 0, 1}, .gradient = shared(Gradient{along, kFine, Extend::repeat})});
    table.make(std::move(build).finish(), {.width = 200, .height = 200}, Depth::u8);
  }
  struct Cells {
    int side;
    std::vector<RampPlane> planes;
  };
  Cells of(int x, int y, int side = 1) {
    const VariedPaint& paint = table.varied.at(0);
    Cells cells;
    cells.side = planes.add(paint, paint.integral,
                            paint.lit < 0 ? nullptr : &table.lit[std::size_t(paint.lit)], x, y,
                            side, scratch, cells.planes);
    return cells;
  }
};

TEST(RampPlanes, AreOneAlongALine) {
  Planes planes(LinearGradient{{0, 0}, {1, 0}});
  EXPECT_EQ(planes.of(30, 40).side, 1);
  EXPECT_NEAR(planes.of(30, 40).planes[0].t, 30.5, 1e-9);  // a stop a pixel
  EXPECT_NEAR(planes.of(30, 40).planes[0].gx, 1, 1e-9);
  EXPECT_EQ(planes.of(30, 40, 4).planes.size(), 16u);
}

TEST(RampPlanes, AreMoreTheMoreLevelLinesBend) {
  Planes planes(RadialGradient{{1, 1}, {1, 1}});
  EXPECT_LE(planes.of(195, 195).side, 2);
  EXPECT_GE(planes.of(103, 103).side, 8);
  EXPECT_GE(planes.of(100, 100).side, 16);
  const auto cells = planes.of(104, 98);
  double sum = 0, counted = 0;
  for (const RampPlane& plane : cells.planes) sum += plane.t / double(cells.planes.size());
  constexpr int kSide = 200;
  for (int k = 0; k < kSide * kSide; ++k)
    counted += std::hypot(4 + (k % kSide + 0.5) / kSide, -2 + (k / kSide + 0.5) / kSide);
  EXPECT_NEAR(sum, counted / (kSide * kSide), 1e-4);
}

TEST(RampPlanes, AreManyOnARidgeAndOneBesideIt) {
  Planes planes(DistanceGradient{Area{0}, 0, -1});
  const auto beside = planes.of(60, 25);  // above, only the level side is near
  ASSERT_EQ(beside.side, 1);
  EXPECT_NEAR(beside.planes[0].t, 5.5, 1e-4);
  EXPECT_NEAR(beside.planes[0].gx, 0, 1e-4);
  EXPECT_NEAR(beside.planes[0].gy, 1, 1e-4);
  EXPECT_EQ(planes.of(100, 120).side, PartCells::kMostSide);  // equally far from both others
  EXPECT_EQ(planes.of(99, 120).side, 1);
}

}  // namespace
}  // namespace mien
