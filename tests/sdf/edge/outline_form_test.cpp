// Closed outlines made ready for leaves: fits are as near as they say, loops are closed, and what
// can't be told is refused.

#include <mien/sdf/edge/outline_form.h>
#include <mien/sdf/shape/path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace mien {
namespace {

TaperedStroke random_stroke(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-200, 200), unit(0, 1);
  const auto point = [&] { return glm::dvec2{place(random), place(random)}; };
  return {{point(), point(), point()},
          {0.5 + 10 * unit(random), 0.5 + 20 * unit(random), 0.5 + 10 * unit(random)}};
}

TEST(TaperedOutline, IsAsNearAsItSays) {
  std::mt19937_64 random(1);
  int fitted = 0;
  for (int i = 0; i < 300; ++i) {
    const TaperedStroke stroke = random_stroke(random);
    const double tolerance = i % 2 ? 0x1p-14 : 0x1p-10, offset = i % 3 ? 0 : 0.25;
    const auto outline = tapered_outline(stroke, offset, tolerance);
    if (!outline) continue;
    ++fitted;
    EXPECT_LT(outline->right.size() + outline->left.size(), 200u);
    for (const auto* side : {&outline->right, &outline->left})
      for (std::size_t k = 0; k < side->size(); ++k) {
        const QuadBezier& quad = (*side)[k];
        if (k > 0) {
          EXPECT_EQ(quad.p0, (*side)[k - 1].p2);
        }
        for (int j = 0; j <= 16; ++j) {
          // Other discs may cover a rim: then the point is inside, never outside.
          const double d = distance(stroke, point(quad, j / 16.0)) - offset;
          EXPECT_LE(d, tolerance + 1e-9) << i;
        }
      }
  }
  EXPECT_GT(fitted, 150);
}

TEST(TaperedOutline, OfAGentleStrokeIsItsRim) {
  const TaperedStroke stroke{{{-100, 0}, {0, 60}, {110, 10}}, {2, 12, 3}};
  const auto outline = tapered_outline(stroke, 0, 1e-4);
  ASSERT_TRUE(outline);
  for (const auto* side : {&outline->right, &outline->left})
    for (const QuadBezier& quad : *side)
      for (int j = 0; j <= 16; ++j) EXPECT_NEAR(distance(stroke, point(quad, j / 16.0)), 0.0, 1e-4);
  EXPECT_LT(outline->right.size(), 24u);
}

TEST(TaperedOutline, RefusesDiscsThatSwallowEachOther) {
  EXPECT_FALSE(tapered_outline({{{0, 0}, {10, 0}, {20, 0}}, {1, 40, 1}}, 0, 1e-4));
  EXPECT_FALSE(tapered_outline({{{0, 0}, {100, 0}, {0, 1}}, {20, 20, 20}}, 0, 1e-4));
}

TEST(OutlineForm, OfATaperedStrokeWindsOnceAroundItsInside) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-220, 220);
  int forms = 0;
  for (int i = 0; i < 100; ++i) {
    const TaperedStroke stroke = random_stroke(random);
    const auto form = outline_form({stroke, 0}, 1e-4);
    if (!form) continue;
    ++forms;
    for (int k = 0; k < 60; ++k) {
      const glm::dvec2 p{place(random), place(random)};
      const double d = distance(stroke, p);
      if (std::abs(d) < 0.01) continue;
      EXPECT_EQ(is_inside(form->path.rule, winding(form->path, p)), d < 0) << i;
    }
  }
  EXPECT_GT(forms, 50);
}

TEST(OutlineForm, KnowsTheSidesOfAPath) {
  const Path path{{{{{{0, 0}, {50, -10}, {100, 0}},
                     {{100, 0}, {100, 50}, {100, 100}},
                     {{100, 100}, {40, 60}, {0, 0}}}}},
                  FillRule::nonzero};
  const auto form = outline_form({path, 0}, 1e-4);
  ASSERT_TRUE(form);
  ASSERT_EQ(form->sides.size(), 3u);
  EXPECT_EQ(form->error, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const OutlineSide& side = form->sides[i];
    EXPECT_EQ(side.next, int(i + 1) % 3);
    EXPECT_EQ(side.before, int(i + 2) % 3);
    EXPECT_NEAR(glm::length(side.begin_way), 1, 1e-15);
    for (std::size_t k = 1; k < OutlineSide::kReaches; ++k)
      EXPECT_GE(side.reaches[k], side.reaches[k - 1]) << "smaller margins see less";
    // The frame's ends are the side's.
    const ParabolaForm& f = side.form;
    const glm::dvec2 up{-f.right.y, f.right.x};
    const auto at = [&](double x) { return f.origin + x * f.right + f.a * x * x * up; };
    EXPECT_LT(glm::distance(at(side.forwards ? f.lo : f.hi), side.begin), 1e-9);
    EXPECT_LT(glm::distance(at(side.forwards ? f.hi : f.lo), side.end), 1e-9);
  }
}

TEST(OutlineForm, RefusesWhatIsNone) {
  EXPECT_FALSE(outline_form({Disc{{0, 0}, 5}, 0}, 1e-4));
  const Path hairpin{{{{{{0, 0}, {50, 0}, {20, 0}}, {{20, 0}, {10, 30}, {0, 0}}}}},
                     FillRule::nonzero};
  EXPECT_FALSE(outline_form({hairpin, 0}, 1e-4)) << "doubles back on a line";
  const Path open{{{{{{0, 0}, {50, 5}, {20, 0}}}}}, FillRule::nonzero};
  EXPECT_FALSE(outline_form({open, 0}, 1e-4));
}

}  // namespace
}  // namespace mien
