#pragma once
// What every shape's distance must obey. One line per shape puts it under these laws:
//
//   INSTANTIATE_TYPED_TEST_SUITE_P(Disc, ShapeLaws, Disc);
//
// and its examples are in tests/support/shape_examples.

#include <mien/shape.h>
#include "lib/math/norm.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"
#include "tests/support/shapes/shape_example.h"

namespace mien::test {

template <class S>
class ShapeLaws : public testing::Test {
 protected:
  Random random{7};

  /// Calls law(example, p) at times(count) points of each example, half of them near the outline.
  template <class Law>
  void everywhere(int count, const Law& law) {
    for (const Example<S>& example : examples<S>())
      for (int i = 0; i < times(count); ++i) {
        glm::dvec2 p = random.point(-example.size, example.size);
        if (i % 2) p = towards_outline(example, p);
        law(example, p);
      }
  }

  /// p walked to about the outline along the gradient, and a little off it.
  glm::dvec2 towards_outline(const Example<S>& example, glm::dvec2 p) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 g = gradient(example.shape, p);
      if (!(glm::dot(g, g) > 0.25)) return p;
      p -= distance(example.shape, p) * glm::normalize(g);
    }
    return p + random.size(-9, -1) * random.direction();
  }

  static glm::dvec2 gradient(const S& s, glm::dvec2 p) {
    const double h = 1e-6;
    return glm::dvec2(distance(s, p + glm::dvec2(h, 0)) - distance(s, p - glm::dvec2(h, 0)),
                      distance(s, p + glm::dvec2(0, h)) - distance(s, p - glm::dvec2(0, h))) /
           (2 * h);
  }
};
TYPED_TEST_SUITE_P(ShapeLaws);

/// Tile culling rests on this: one distance at a tile's centre bounds the whole tile.
TYPED_TEST_P(ShapeLaws, NeverChangesFasterThanYouWalk) {
  this->everywhere(4'000, [&](const auto& e, glm::dvec2 p) {
    const glm::dvec2 q = this->random.chance(0.5)
                             ? this->random.point(-e.size, e.size)
                             : p + this->random.size(-8, 0) * this->random.direction();
    EXPECT_LE(std::abs(distance(e.shape, p) - distance(e.shape, q)), norm(p - q) + 4e-15 * e.size)
        << p.x << ' ' << p.y << " to " << q.x << ' ' << q.y;
  });
}

/// Exactness: walking the reported distance along the gradient lands on the outline, and no shorter
/// way does.
TYPED_TEST_P(ShapeLaws, WalkingTheDistanceReachesTheOutline) {
  int walked = 0;
  this->everywhere(2'000, [&](const auto& e, glm::dvec2 p) {
    const double d = distance(e.shape, p);
    const Exactness exact = exactness(Shape(e.shape));
    if (!(d > 0 ? exact.outside : exact.inside) || std::abs(d) < 1e-4) return;
    const glm::dvec2 g = this->gradient(e.shape, p);
    if (std::abs(norm(g) - 1) > 1e-7)
      return;  // where two nearest points compete there is no gradient
    const glm::dvec2 landed = p - d * glm::normalize(g);
    EXPECT_NEAR(distance(e.shape, landed), 0, 1e-6 * e.size) << p.x << ' ' << p.y << " d " << d;
    ++walked;
  });
  EXPECT_GT(walked, times(300));
}

/// The sign is that of the shape's own definition.
TYPED_TEST_P(ShapeLaws, IsNegativeExactlyInside) {
  int in = 0, out = 0;
  bool hollow = true;
  this->everywhere(8'000, [&](const auto& e, glm::dvec2 p) {
    hollow &= e.hollow;
    const double d = distance(e.shape, p), inside = e.inside(p);
    if (std::abs(d) < 1e-13 * e.size || std::abs(inside) < 1e-12) return;
    EXPECT_EQ(d<0, inside> 0) << p.x << ' ' << p.y << " d " << d << " inside " << inside;
    ++(inside > 0 ? in : out);
  });
  EXPECT_GT(out, times(100));
  if (!hollow) {
    EXPECT_GT(in, times(100));
  }
}

/// Mirrors, turns, scales and shifts carry the distance with them.
TYPED_TEST_P(ShapeLaws, SimilaritiesCarryTheDistance) {
  const glm::dmat2 similar[] = {
      {-1, 0, 0, 1}, {0, 1, -1, 0}, {0.6, 0.8, -0.8, 0.6}, {1, 2, 2, -1}, {1e-3, 0, 0, 1e-3}};
  for (const glm::dmat2& linear : similar) {
    const double scale = norm(linear[0]);
    const glm::dvec2 shift{0.7, -0.3};
    this->everywhere(500, [&](const auto& e, glm::dvec2 p) {
      const Shape there = transformed(linear, shift, Shape(e.shape));
      EXPECT_EQ(there.index(), Shape(e.shape).index());
      EXPECT_NEAR(distance(there, linear * p + shift), scale * distance(e.shape, p),
                  2e-14 * (scale * e.size + 1))
          << p.x << ' ' << p.y;
    });
  }
}

/// Mirrored in x = 0 the answer is the same to the last bit: faces are symmetric, and their
/// pictures shall be.
TYPED_TEST_P(ShapeLaws, MirrorImagesAgreeToTheBit) {
  const glm::dmat2 mirror{-1, 0, 0, 1};
  this->everywhere(2'000, [&](const auto& e, glm::dvec2 p) {
    EXPECT_EQ(distance(transformed(mirror, {0, 0}, Shape(e.shape)), {-p.x, p.y}),
              distance(e.shape, p));
  });
}

TYPED_TEST_P(ShapeLaws, BoundsContainTheInside) {
  int in = 0;
  this->everywhere(8'000, [&](const auto& e, glm::dvec2 p) {
    if (!(distance(e.shape, p) <= 0)) return;
    const Box2 box = bounds(Shape(e.shape));
    EXPECT_TRUE(box.contains(p)) << p.x << ' ' << p.y << " not in " << box.lo.x << ' ' << box.lo.y
                                 << " to " << box.hi.x << ' ' << box.hi.y;
    ++in;
  });
  for (const auto& e : examples<TypeParam>())
    if (!e.hollow) {
      EXPECT_GT(in, 0);
    }
}

TYPED_TEST_P(ShapeLaws, RunBackwardsItIsTheSame) {
  this->everywhere(2'000, [&](const auto& e, glm::dvec2 p) {
    EXPECT_NEAR(distance(backwards(e.shape), p), distance(e.shape, p), 2e-14 * e.size);
  });
}

TYPED_TEST_P(ShapeLaws, NothingIsPlacedByANumberThatIsNone) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const auto& e : examples<TypeParam>())
    for (const glm::dvec2 p : {glm::dvec2(nan, 0.1), glm::dvec2(0.1, nan), glm::dvec2(nan, nan)})
      EXPECT_EQ(distance(e.shape, p), inf);
}

REGISTER_TYPED_TEST_SUITE_P(ShapeLaws, NeverChangesFasterThanYouWalk,
                            WalkingTheDistanceReachesTheOutline, IsNegativeExactlyInside,
                            SimilaritiesCarryTheDistance, MirrorImagesAgreeToTheBit,
                            BoundsContainTheInside, RunBackwardsItIsTheSame,
                            NothingIsPlacedByANumberThatIsNone);

/// The largest error of distance(shape, p) against `reference(p)` (a Real), in units of
/// 2⁻⁵²·size(p).
struct WorstError {
  double units = 0;
  glm::dvec2 at{0, 0};
  double found = 0, expected = 0;

  void note(glm::dvec2 p, double got, double exact_minus_got, double size) {
    const double u = std::abs(exact_minus_got) / (0x1p-52 * size);
    if (u <= units) return;
    units = u;
    at = p;
    found = got;
    expected = got + exact_minus_got;
  }
};

inline std::ostream& operator<<(std::ostream& out, const WorstError& w) {
  return out << w.units << " units at (" << w.at.x << ", " << w.at.y << "): " << w.found << ", not "
             << w.expected;
}

}  // namespace mien::test
