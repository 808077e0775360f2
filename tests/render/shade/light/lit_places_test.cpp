// What sixteen places see, on every instruction set: distance, gradient, and the ridge where another branch takes over.
// Mirrors render/shade/light/lit_places-inl.h, whose places see by render/shade/nearest/near_area-inl.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/shade/light/lit_places_test.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/nearest/near_area-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

void SeeSixteen(NearArea& area, float cx, float cy, float r, const float* x, const float* y,
                BranchPair& to) {
  std::vector<NearBranches> near(area.leaf_count());
  FindFeetOf(area);
  EnterSquare(area, nullptr, cx, cy, r, near.data());
  LookAround(area, near.data(), cx, cy, x, y, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien::batch {
HWY_EXPORT(SeeSixteen);
namespace {

constexpr glm::dvec2 kAround{24.0, 24.0};

/// Sixteen places of a square in a disc of 12 px, and what they see of an area.
struct Sixteen {
  double half = 2.0;  ///< of the square's side [px]
  std::array<float, 16> x{}, y{};
  BranchPair seen{};

  bool look(const AreaDistance& distance, test::Random& random) {
    const FeetArea feet(distance, {0, 0});
    NearArea area;
    area.narrow(feet, kAround, 12.0);
    if (area.crowded()) return false;
    const glm::dvec2 middle =
        random.between(0.0, std::max(0.0, 12.0 - 1.5 * half)) * random.direction();
    for (std::size_t k = 0; k < 16; ++k) {
      x[k] = float(middle.x + random.between(-half, half));
      y[k] = float(middle.y + random.between(-half, half));
    }
    HWY_DYNAMIC_DISPATCH(SeeSixteen)
    (area, float(middle.x), float(middle.y), float(1.4143 * half), x.data(), y.data(), seen);
    return true;
  }
  glm::dvec2 place(std::size_t k) const { return kAround + glm::dvec2{x[k], y[k]}; }
  glm::dvec2 to_ridge(std::size_t k) const { return {seen.ex[k], seen.ey[k]}; }
};

glm::dvec2 gradient(const BranchPair::Values& v, std::size_t k) {
  return {v.nx[k], v.ny[k]};
}

AreaDistance random_triangle(test::Random& random) {
  Path path{{Path::Loop{}}, FillRule::nonzero};
  const double turn = random.between(0, 6);
  const auto corner = [&](int i) {
    const double at = turn + 2.0943951023931953 * (i % 3);
    return kAround + 9.0 * glm::dvec2{std::cos(at), std::sin(at)};
  };
  for (int i = 0; i < 3; ++i)
    path.loops[0].sides.push_back({corner(i), 0.5 * (corner(i) + corner(i + 1)), corner(i + 1)});
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  const Area area = scene.shape(path);
  return AreaDistance(std::move(scene).finish(), area, {});
}

constexpr std::array kHalves{0.5, 2.0, 8.0};

TEST(LitPlaces, NearestBranchesAreTheAreasOwn) {
  test::on_every_set([] {
    test::Random random(31);
    int looked = 0;
    for (int k = 0; k < 2000; ++k) {
      const AreaDistance area =
          test::random_area(random, k % test::kLitShapes, random.between(6, 60));
      Sixteen at{.half = kHalves[std::size_t(k / test::kLitShapes % 3)]};
      if (!at.look(area, random)) continue;
      ++looked;
      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(at.seen.best.d[i], area.at(at.place(i)), 2e-3)
            << k << " " << at.place(i).x << " " << at.place(i).y;
        EXPECT_NEAR(glm::length(gradient(at.seen.best, i)), 1.0, 1e-3) << k;
        // Away from ridges and the outline, where it may jump, the gradient is what the distance changes by.
        constexpr double kStep = 0.01;
        if (at.seen.off[i] < 0.1f || std::abs(at.seen.best.d[i]) < 0.1f) continue;
        const glm::dvec2 n = gradient(at.seen.best, i), p = at.place(i);
        EXPECT_NEAR(area.at(p + kStep * n) - area.at(p - kStep * n), 2 * kStep, 0.02 * kStep) << k;
      }
    }
    EXPECT_GT(looked, 1900);
  });
}

/// Both branches are equally far on the ridge, to first order, and the area's distance goes on by the other one.
TEST(LitPlaces, RidgesLieWhereBothBranchesAreEquallyFar) {
  test::on_every_set([] {
    test::Random random(32);
    int ridges = 0, off = 0;
    for (int k = 0; k < 400; ++k) {
      const AreaDistance area = random_triangle(random);
      Sixteen at;
      ASSERT_TRUE(at.look(area, random));
      for (std::size_t i = 0; i < 16; ++i) {
        const double way = at.seen.off[i];
        if (way > 3.0 || at.seen.best.d[i] > 0.0f) continue;
        const auto goes_on = [&](const BranchPair::Values& v, double by) {
          return v.d[i] + by * glm::dot(gradient(v, i), at.to_ridge(i));
        };
        EXPECT_NEAR(goes_on(at.seen.best, way), goes_on(at.seen.beyond, way), 2e-3) << k;
        constexpr double kBeyond = 0.2;
        const double own = area.at(at.place(i) + (way + kBeyond) * at.to_ridge(i));
        ++ridges, off += std::abs(own - goes_on(at.seen.beyond, way + kBeyond)) > 0.02;
      }
    }
    EXPECT_GT(ridges, 500);
    EXPECT_LT(off, 0.1 * ridges);  // a third side, or a corner, may be nearer there
  });
}

}  // namespace
}  // namespace mien::batch
#endif
