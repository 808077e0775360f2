// What sixteen places see, on every instruction set: distance, gradient, and the ridge where another branch takes over.
// Mirrors render/shade/light/lit_places-inl.h, whose places see by render/shade/nearest/near_squares-inl.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/shade/light/lit_places_test.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/nearest/near_squares-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

void SeeSixteen(NearArea& area, float cx, float cy, float r, const float* x, const float* y,
                BranchPair& to) {
  std::vector<NearNode> near(area.nodes().size());
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

#include "tests/support/scenes/lit_scene.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::batch {
HWY_EXPORT(SeeSixteen);
namespace {

constexpr glm::dvec2 kAround{24.0, 24.0};

/// Sixteen places of a square in a disc of 12 px, and what they see of an area.
struct Sixteen {
  double half = 2.0;  ///< of the square's side [px]
  std::array<float, 16> x{}, y{};
  BranchPair seen{};
  glm::dvec2 middle{0.0};

  bool look(const AreaDistance& distance, test::Random& random) {
    const FeetArea feet(distance, {0, 0});
    NearArea area;
    area.narrow(feet, kAround, 12.0);
    if (area.crowded()) return false;
    middle = random.between(0.0, std::max(0.0, 12.0 - 1.5 * half)) * random.direction();
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

AreaDistance area_of_loop(const Path::Loop& loop) {
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  const Area area = scene.shape(Path{{loop}, FillRule::nonzero});
  return AreaDistance(std::move(scene).finish(), area, {});
}

AreaDistance random_polygon(test::Random& random, int corners) {
  Path::Loop loop;
  const double turn = random.between(0, 6), step = 6.283185307179586 / corners;
  std::vector<glm::dvec2> at;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + step * (i + random.between(0.0, 0.8));
    at.push_back(kAround + glm::dvec2{9.0 * std::cos(angle), 5.0 * std::sin(angle)});
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const glm::dvec2 next = at[(i + 1) % at.size()];
    loop.sides.push_back({at[i], 0.5 * (at[i] + next), next});
  }
  return area_of_loop(loop);
}

/// A thin parabola, whose vertex is the middle of its side, closed by a line.
struct ThinParabola {
  glm::dvec2 tip, way;
  AreaDistance area;
};
ThinParabola random_parabola(test::Random& random) {
  const glm::dvec2 way = random.direction(), across{-way.y, way.x};
  const glm::dvec2 tip = kAround + random.between(0, 4) * random.direction();
  const double half = random.between(0.3, 3.0);
  const glm::dvec2 begin = tip + 30.0 * way + half * across, end = tip + 30.0 * way - half * across;
  return {tip, way,
          area_of_loop({{{begin, tip - 30.0 * way, end}, {end, 0.5 * (begin + end), begin}}})};
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
      const AreaDistance area = random_polygon(random, 3);
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

/// Sides that end at an obtuse corner come nearest beyond its bisector without a foot here, and whose ridge is nearest
/// need not be the second nearest.
TEST(LitPlaces, NoRidgeIsNearerThanTheOneThatIsSeen) {
  test::on_every_set([] {
    test::Random random(33);
    int looked = 0;
    for (int k = 0; k < 400; ++k) {
      const AreaDistance area = random_polygon(random, 5 + k % 4);
      Sixteen at{.half = kHalves[std::size_t(k % 2)]};
      ASSERT_TRUE(at.look(area, random));
      for (std::size_t i = 0; i < 16; ++i) {
        if (at.seen.best.d[i] > -0.01f) continue;
        const double way = std::min(0.98 * double(at.seen.off[i]), 2.0);
        for (int turn = 0; turn < 8; ++turn) {
          const double angle = 0.7853981633974483 * turn;
          const glm::dvec2 to = way * glm::dvec2{std::cos(angle), std::sin(angle)};
          const double on = at.seen.best.d[i] + glm::dot(gradient(at.seen.best, i), to);
          const glm::dvec2 out = at.place(i) + to - kAround - at.middle;
          if (on > 0.0 || std::max(std::abs(out.x), std::abs(out.y)) > at.half) continue;
          ++looked;
          EXPECT_NEAR(area.at(at.place(i) + to), on, 2e-3) << k << " " << i << " " << turn;
        }
      }
    }
    EXPECT_GT(looked, 10000);
  });
}

/// Within a thin parabola each half has a foot of its own.
TEST(LitPlaces, HalvesOfAParabolaHaveFeetOfTheirOwn) {
  test::on_every_set([] {
    test::Random random(34);
    int inside = 0;
    for (int k = 0; k < 600; ++k) {
      const ThinParabola thin = random_parabola(random);
      Sixteen at{.half = kHalves[std::size_t(k % 3)]};
      if (!at.look(thin.area, random)) continue;
      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(at.seen.best.d[i], thin.area.at(at.place(i)), 2e-3) << k << " " << i;
        // The other half is as far from the axis.
        const glm::dvec2 from = at.place(i) - thin.tip;
        const double along = glm::dot(from, thin.way);
        const glm::dvec2 on_axis = thin.tip + along * thin.way - kAround - at.middle;
        if (at.seen.best.d[i] > 0.0f || along < 1.0 ||
            std::max(std::abs(on_axis.x), std::abs(on_axis.y)) > at.half)
          continue;
        ++inside;
        const double axis = std::abs(from.x * thin.way.y - from.y * thin.way.x);
        EXPECT_NEAR(at.seen.off[i], axis, 0.02 + 0.1 * axis) << k << " " << i;
      }
    }
    EXPECT_GT(inside, 100);
  });
}

AreaDistance area_of_stroke(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, double half_width) {
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  const Area area = scene.shape(QuadStroke{{a, b, c}, half_width});
  return AreaDistance(std::move(scene).finish(), area, {});
}

/// Where a parabola's vertex lies beyond a stroke's end, the end is a least distance beside the one within.
TEST(LitPlaces, EndsOfAStrokeAreBranchesOfTheirOwn) {
  test::on_every_set([] {
    test::Random random(35);
    int beside = 0;
    for (int k = 0; k < 300; ++k) {
      const glm::dvec2 way = random.direction(), across{-way.y, way.x};
      // Around the place that sees both as about equally far.
      const auto point = [&](double x, double y) {
        return kAround + (x - 15.1) * way + (y - 7.6) * across;
      };
      const glm::dvec2 a = point(11.85, 16.19), b = point(9.24, 16.16), c = point(3.11, 8.06);
      const AreaDistance area =
          k % 2 ? area_of_stroke(a, b, c, 0.135) : area_of_stroke(c, b, a, 0.135);
      Sixteen at{.half = kHalves[std::size_t(k % 3)]};
      ASSERT_TRUE(at.look(area, random));
      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(at.seen.best.d[i], area.at(at.place(i)), 2e-3) << k << " " << i;
        beside += std::abs(glm::distance(at.place(i), a) - 0.135 - at.seen.best.d[i]) < 0.5 &&
                  at.seen.off[i] < 0.5;
      }
    }
    EXPECT_GT(beside, 100);
  });
}

/// Around an end the distance is a cone, and its gradient turns at the tip.
TEST(LitPlaces, TipsOfCapsAreRidges) {
  test::on_every_set([] {
    test::Random random(36);
    int near = 0;
    for (int k = 0; k < 600; ++k) {
      const glm::dvec2 way = random.direction(), across{-way.y, way.x};
      const glm::dvec2 tip = kAround + random.between(0, 10) * random.direction();
      const AreaDistance area =
          area_of_stroke(tip, tip + 6.0 * way + random.between(-3, 3) * across, tip + 20.0 * way,
                         random.between(1, 6));
      Sixteen at{.half = kHalves[std::size_t(k % 3)]};
      ASSERT_TRUE(at.look(area, random));
      for (std::size_t i = 0; i < 16; ++i) {
        const glm::dvec2 from = at.place(i) - tip;
        if (at.seen.best.d[i] > 0.0f || glm::dot(from, way) > -0.6 * glm::length(from)) continue;
        ++near;
        EXPECT_LT(at.seen.off[i], glm::length(from) + 0.01) << k << " " << i;
      }
    }
    EXPECT_GT(near, 300);
  });
}

}  // namespace
}  // namespace mien::batch
#endif
