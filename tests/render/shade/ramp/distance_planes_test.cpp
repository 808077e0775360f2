#include "render/shade/ramp/distance_planes.h"
#include "render/shade/paint_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// How far the mean over pixel (10, 10), by cells, is from that of many places, as a share of what may be: of a picture
/// of 20 × 20 px.
template <class Distance>
double off_in_the_middle(SceneBuilder build, Area area, const Distance& distance) {
  std::vector<Stop> stops;
  for (int i = 0; i <= 50; ++i) stops.push_back({i / 50.0, {i * i / 2500.0, 0, 0, 1}});
  build.layer("all", build.everywhere(),
              {.color = {0, 0, 0, 1},
               .gradient = shared(Gradient{DistanceGradient{area, -6, 6}, stops, Extend::pad})});
  PaintTable table;
  table.make(std::move(build).finish(), {.width = 20, .height = 20}, Depth::u16);
  const VariedPaint& varied = table.varied.at(0);
  RampSoftness soft;
  soft.make(varied.paint.field, varied.integral, 1e-4, &*varied.paint.ramp);
  DistancePlanes planes;
  std::vector<RampPlane> cells;
  EXPECT_GE(
      planes.of(table.lit[std::size_t(varied.lit)].gradient_area(), 10, 10, 1, false, soft, cells),
      4);
  double sum = 0, counted = 0;
  for (const RampPlane& cell : cells) sum += cell.t / double(cells.size());
  constexpr int kSide = 400;
  for (int k = 0; k < kSide * kSide; ++k)
    counted +=
        distance(glm::dvec2{10.0 + (k % kSide + 0.5) / kSide, 10.0 + (k / kSide + 0.5) / kSide});
  return std::abs(sum - counted / (kSide * kSide)) / soft.allowed();
}

SceneBuilder twenty_pixels() {
  return SceneBuilder({.box = {{0, 0}, {20, 20}}, .y_up = false}, {1, 1, 1, 1});
}

// Round a point the gradient turns all about, so no cell that holds it has a plane: only its neighbours tell.
TEST(DistancePlanes, HaveTheMeanRoundAPoint) {
  SceneBuilder build = twenty_pixels();
  const glm::dvec2 center{10.4, 10.45};
  const Area disc = build.shape(Disc{center, 5});
  EXPECT_LT(off_in_the_middle(std::move(build), disc,
                              [&](glm::dvec2 p) { return glm::length(p - center) - 5; }),
            1);
}

// Neither the pixel's middle nor a corner of it lies in the wedge, and all five lie on one side of it.
TEST(DistancePlanes, SeeASliverBetweenTwoRidges) {
  SceneBuilder build = twenty_pixels();
  const glm::dvec2 apex{10.6, 10.5};
  const double k = 0.8, by = 2 * k / (k * k + 1);
  const glm::dvec2 left{-1, 0}, up = left + by * glm::dvec2{k, -1}, down{up.x, -up.y};
  const auto plane = [&](glm::dvec2 n) {
    return build.shape(HalfPlane{n, glm::dot(n, apex) + 0.1});
  };
  const Area all = plane(left), upper = plane(up), lower = plane(down);
  const Area both = build.intersect(all, build.unite(upper, lower));
  const auto distance = [&](glm::dvec2 p) {
    const glm::dvec2 q = p - apex;
    return std::max(glm::dot(left, q), std::min(glm::dot(up, q), glm::dot(down, q))) - 0.1;
  };
  EXPECT_LT(off_in_the_middle(std::move(build), both, distance), 1);
}

}  // namespace
}  // namespace mien
