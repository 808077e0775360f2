#include <mien/sdf/edge/curve_form.h>

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

glm::dvec2 at(const ParabolaForm& f, double x) {
  return f.origin + x * f.right + f.a * x * x * glm::dvec2{-f.right.y, f.right.x};
}

TEST(ParabolaForm, RunsThroughAStrokesSpine) {
  const QuadBezier spine{{3, 4}, {50, -20}, {60, 70}};
  const auto f = parabola_form({QuadStroke{spine, 2}, 0.5});
  ASSERT_TRUE(f);
  EXPECT_DOUBLE_EQ(f->level, 2.5);
  const glm::dvec2 a = at(*f, f->lo), b = at(*f, f->hi);
  const double same = glm::length(a - spine.p0) + glm::length(b - spine.p2);
  const double turned = glm::length(a - spine.p2) + glm::length(b - spine.p0);
  EXPECT_LT(std::min(same, turned), 1e-9);
  // The middle of the spine is on it too.
  const glm::dvec2 middle = 0.25 * (spine.p0 + 2.0 * spine.p1 + spine.p2), m = middle - f->origin;
  EXPECT_LT(glm::length(at(*f, glm::dot(m, f->right)) - middle), 1e-9);
}

TEST(ParabolaForm, TakesAStraightSpineForALine) {
  const auto f = parabola_form({Line{{0, 0}, {30, 40}, 2}, 0});
  ASSERT_TRUE(f);
  EXPECT_EQ(f->a, 0);
  EXPECT_DOUBLE_EQ(f->hi, 50);
  EXPECT_TRUE(std::isinf(f->reach));
}

TEST(ParabolaForm, ReachIsTheLeastRadiusOfCurvature) {
  const auto side = parabola_form({ParabolaSide{{0, 0}, {0, 1}, 0.01}, 0});
  EXPECT_DOUBLE_EQ(side->reach, 50);
  // Away from the vertex by more than the margin, and turning little: the near end's radius.
  const auto away = parabola_form({QuadStroke{{{100, 100}, {150, 200}, {200, 400}}, 1}, 0});
  EXPECT_GT(away->reach, 60);
}

TEST(ParabolaForm, RefusesWhatItCannotSay) {
  EXPECT_FALSE(parabola_form({QuadStroke{{{0, 0}, {9, 0}, {0, 0}}, 1}, 0}));   // folded
  EXPECT_FALSE(parabola_form({QuadStroke{{{0, 0}, {5, 5}, {9, 0}}, 1}, -1}));  // nothing left
  EXPECT_FALSE(parabola_form({Disc{{0, 0}, 1}, 0}));
}

TEST(EllipseForm, ReachIsTheSharpEndsRadius) {
  EXPECT_DOUBLE_EQ(ellipse_form({Ellipse{{0, 0}, {50, 20}, {1, 0}}, 0})->reach, 8);
  EXPECT_FALSE(ellipse_form({Ellipse{{0, 0}, {50, 20}, {1, 0}}, 1}));
  EXPECT_FALSE(ellipse_form({Ellipse{{0, 0}, {50, 0}, {1, 0}}, 0}));
}

}  // namespace
}  // namespace mien
