// What leaves are told about outlines, against what the shapes' distances say, on every instruction
// set: the description may be off by its stated error, never by more, and it must be proven where
// the shape is large against the leaf, or nothing would be fast.

#include <mien/sdf/batch/instruction_sets.h>
#include <mien/sdf/edge/leaf_edges.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/every_instruction_set.h"

namespace mien {
namespace {

using test::on_every_set;

/// Signed distance by the description, u from the leaf's centre; roughly, as coverage takes it.
double value(const LeafEdge& e, glm::dvec2 p) {
  if (e.joined) {
    const glm::dvec2 u = p - glm::dvec2{e.end_x, e.end_y};
    LeafEdge body = glm::dot(u, glm::dvec2{e.along_x, e.along_y}) > 0 ? e.beyond() : e;
    body.joined = false;
    return value(body, p);
  }
  if (e.has_end()) {
    const glm::dvec2 u = p - glm::dvec2{e.end_x, e.end_y};
    if (glm::dot(u, glm::dvec2{e.along_x, e.along_y}) > 0) {
      const double d = glm::length(u) - 1.0 / e.end_bend;
      const bool nobodys =
          d > double(kEndHalo) && glm::dot(u, glm::dvec2{e.other_x, e.other_y}) > 0;
      return glm::dot(u, glm::dvec2{e.end_nx, e.end_ny}) >= 0 || nobodys ? d : -1e6;
    }
  }
  const glm::dvec2 u = p - glm::dvec2{e.x, e.y}, n{e.nx, e.ny};
  const double x = u.y * n.x - u.x * n.y, k = e.bend;
  const double f = glm::dot(u, n) + 0.5 * k * glm::dot(u, u);
  const double leaves = x * x * x * (e.c3 + e.c4 * x) * (1 + 0.5 * k * k * x * x);
  return 2 * f / (1 + std::sqrt(std::max(0.0, 1 + 2 * k * f))) + leaves;
}

/// By the whole outline. Where windings decide, the nearest edge.
double value(const LeafOutline& o, const std::vector<LeafEdge>& edges, glm::dvec2 p) {
  if (o.rule == EdgeRule::outside) return 1e6;
  double d = -1e6;
  if (o.rule != EdgeRule::all && o.rule != EdgeRule::inside) {
    d = 1e6;
    for (int i = o.first; i < o.first + o.count; ++i) {
      const double v = value(edges[std::size_t(i)], p);
      if (o.rule == EdgeRule::any ? v < d : std::abs(v) < std::abs(d)) d = v;
    }
    return d;
  }
  for (int i = o.first; i < o.first + o.count; ++i)
    d = std::max(d, value(edges[std::size_t(i)], p));
  return d;
}

struct Tally {
  int leaves = 0, proven = 0;
};

/// Tiles of 16 leaves around outline points of the shape; every leaf near is probed.
Tally check(const OffsetShape& shape, double side, int tiles, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-150, 150), unit(-0.5, 0.5);
  const LeafOutlines outlines(shape);
  Tally tally;
  while (tiles > 0) {
    const glm::dvec2 center{place(random), place(random)};
    if (std::abs(distance(shape, center)) > 2 * side) continue;
    --tiles;
    Leaves leaves{.wanted = 0, .radius = side * std::sqrt(0.5)};
    for (std::size_t i = 0; i < Leaves::kMost; ++i) {
      leaves.x[i] = center.x + side * (double(i % 4) - 1.5);
      leaves.y[i] = center.y + side * (double(i / 4) - 1.5);
      if (std::abs(distance(shape, {leaves.x[i], leaves.y[i]})) < leaves.radius)
        leaves.wanted |= 1u << i;
    }
    std::array<LeafOutline, Leaves::kMost> found;
    std::vector<LeafEdge> edges;
    outlines.in_leaves(leaves, found, edges);
    for (std::size_t i = 0; i < Leaves::kMost; ++i) {
      if (!(leaves.wanted >> i & 1u)) continue;
      ++tally.leaves;
      const LeafOutline& o = found[i];
      if (!(o.error < 0.25)) continue;
      tally.proven += o.error < 1.0 / 1024;
      const glm::dvec2 c{leaves.x[i], leaves.y[i]};
      for (int k = 0; k < 12; ++k) {
        // Onto the outline, as far as it lies in the leaf: where the description must vanish too.
        glm::dvec2 u = side * glm::dvec2{unit(random), unit(random)};
        for (int step = 0; step < 4; ++step) {
          const double d = distance(shape, c + u), h = 1e-6;
          const glm::dvec2 g{distance(shape, c + u + glm::dvec2{h, 0}) - d,
                             distance(shape, c + u + glm::dvec2{0, h}) - d};
          if (glm::length(g) > 0) u -= d * glm::normalize(g);
        }
        if (std::abs(distance(shape, c + u)) > 1e-6 ||
            std::max(std::abs(u.x), std::abs(u.y)) > 0.5 * side)
          continue;
        // Floats relative to the leaf: 1e-5 px.
        EXPECT_LE(std::abs(value(o, edges, u)), o.error * 1.02 + 1e-5)
            << fmt::format("leaf {} {} side {} at {} {}: {} edges, rule {}", c.x, c.y, side, u.x,
                           u.y, o.count, int(o.rule));
      }
    }
  }
  return tally;
}

TEST(LeafOutlines, DescribeStrokesWithTheirEnds) {
  on_every_set([] {
    int leaves = 0, proven = 0;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(-120, 120);
    for (int i = 0; i < 60; ++i) {
      const auto point = [&] { return glm::dvec2{place(random), place(random)}; };
      const double half_width = 0.5 + 12.0 * (i % 5) / 4;
      const Tally t = check({QuadStroke{{point(), point(), point()}, half_width}, 0.25 * (i % 3)},
                            i % 2 ? 16 : 8, 12, std::uint64_t(i));
      leaves += t.leaves, proven += t.proven;
    }
    EXPECT_GT(proven, leaves / 4) << leaves;
  });
}

TEST(LeafOutlines, DescribeLines) {
  on_every_set([] {
    const Tally t = check({Line{{-80, -30}, {70, 55}, 6}, 0}, 16, 100, 1);
    EXPECT_GT(t.proven, 0.95 * t.leaves) << t.leaves;
    check({Line{{-30, -30}, {-20, 5}, 2}, 0}, 16, 100, 2);
  });
}

TEST(LeafOutlines, DescribeParabolasAndWhatIsGrownFromThem) {
  on_every_set([] {
    for (const double bend : {0.0, 0.002, -0.004, 0.006}) {
      const glm::dvec2 axis = glm::normalize(glm::dvec2{0.3, 1});
      const Tally t = check({ParabolaSide{{10, -20}, axis, bend}, 0}, 16, 100, 3);
      EXPECT_GT(t.proven, 0.9 * t.leaves) << bend;
      check({ParabolaSide{{10, -20}, axis, bend}, 5}, 16, 50, 4);
      check({ParabolaSide{{10, -20}, axis, bend}, -5}, 16, 50, 5);
    }
    check({ParabolaSide{{0, 0}, {0, 1}, 0.08}, 0}, 16, 100, 6);
  });
}

/// A blob of smooth sides around the origin, as drawing programs make them; with corners if `sharp`.
Path blob(std::mt19937_64& random, int sides, double sharp, bool clockwise) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<glm::dvec2> handles, joints;
  for (int i = 0; i < sides; ++i) {
    const double angle = 6.2831853 * i / sides, radius = 90 + 50 * unit(random);
    handles.push_back(radius * glm::dvec2{std::cos(angle), std::sin(angle)});
  }
  for (int i = 0; i < sides; ++i) {
    const glm::dvec2 middle =
        0.5 * (handles[std::size_t(i)] + handles[std::size_t((i + 1) % sides)]);
    joints.push_back(middle * (unit(random) < sharp ? 0.8 + 0.3 * unit(random) : 1.0));
  }
  Path path{{{}}, clockwise ? FillRule::even_odd : FillRule::nonzero};
  for (int i = 0; i < sides; ++i)
    path.loops[0].sides.push_back({joints[std::size_t((i + sides - 1) % sides)],
                                   handles[std::size_t(i)], joints[std::size_t(i)]});
  if (clockwise) {
    std::reverse(path.loops[0].sides.begin(), path.loops[0].sides.end());
    for (QuadBezier& side : path.loops[0].sides) side = reversed(side);
  }
  return path;
}

TEST(LeafOutlines, DescribePaths) {
  on_every_set([] {
    std::mt19937_64 random(21);
    for (const double sharp : {0.0, 0.5}) {
      Tally all;
      for (int i = 0; i < 24; ++i) {
        const Tally t =
            check({blob(random, 5 + i % 6, sharp, i % 2), 0}, i % 3 ? 16 : 8, 12, std::uint64_t(i));
        all.leaves += t.leaves, all.proven += t.proven;
      }
      EXPECT_GT(all.proven, 0.5 * all.leaves) << sharp;
    }
  });
}

TEST(LeafOutlines, DescribeStrokesOfVaryingWidth) {
  on_every_set([] {
    std::mt19937_64 random(22);
    std::uniform_real_distribution<double> place(-120, 120), unit(0, 1);
    Tally all;
    for (int i = 0; i < 40; ++i) {
      const auto point = [&] { return glm::dvec2{place(random), place(random)}; };
      const TaperedStroke stroke{
          {point(), 0.3 * point(), point()},
          {0.4 + 6 * unit(random), 0.4 + 12 * unit(random), 0.4 + 6 * unit(random)}};
      const Tally t = check({stroke, 0.25 * (i % 3)}, std::array{16, 8, 4}[std::size_t(i % 3)], 12,
                            std::uint64_t(i));
      all.leaves += t.leaves, all.proven += t.proven;
    }
    EXPECT_GT(all.proven, 0.4 * all.leaves) << all.leaves;
  });
}

TEST(LeafOutlines, DescribeEllipses) {
  on_every_set([] {
    const glm::dvec2 axis = glm::normalize(glm::dvec2{1, 0.4});
    const Tally large = check({Ellipse{{0, 0}, {120, 90}, axis}, 0}, 8, 200, 7);
    EXPECT_GT(large.proven, 0.9 * large.leaves);
    check({Ellipse{{5, 3}, {57, 67}, axis}, 0}, 16, 100, 8);
    check({Ellipse{{5, 3}, {90, 12}, axis}, 0}, 8, 100, 9);
    check({Ellipse{{5, 3}, {30, 30}, axis}, 0}, 16, 100, 10);
  });
}

TEST(LeafOutlines, DescribeDiscsExactly) {
  const Tally t = check({Disc{{3, 4}, 20}, 1}, 16, 60, 11);
  EXPECT_EQ(t.proven, t.leaves);
}

/// What a kernel finds for one of the leaves.
std::vector<double> numbers(const CurveLeaves& found, std::size_t leaf, std::size_t levels) {
  std::vector<double> all{found.foot[leaf], found.side[leaf], found.nx[leaf], found.ny[leaf],
                          double(found.proven >> leaf & 1u)};
  for (std::size_t i = 0; i < levels; ++i) {
    const CurveLeaves::Level& l = found.levels[i];
    for (const double x : {l.bend[leaf], l.c3[leaf], l.c4[leaf], l.error[leaf]}) all.push_back(x);
  }
  return all;
}

// Which leaves are asked about together depends on what a region shows: no bit may follow it.
TEST(CurveLeaves, DependOnNoOtherLeaf) {
  on_every_set([] {
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> place(-60, 60), unit(0, 1);
    const auto point = [&] { return glm::dvec2{place(random), place(random)}; };
    for (int i = 0; i < 300; ++i) {
      const OffsetShape stroke{QuadStroke{{point(), point(), point()}, 1 + 9 * unit(random)}, 0},
          round{Ellipse{point(),
                        {30 + 60 * unit(random), 30 + 60 * unit(random)},
                        glm::normalize(point())},
                0};
      const auto parabola = parabola_form(stroke);
      const auto ellipse = ellipse_form(round);
      Leaves all{.wanted = 0xFFFF, .radius = 11.32};
      for (std::size_t k = 0; k < Leaves::kMost; ++k)
        all.x[k] = 1.3 * place(random), all.y[k] = 1.3 * place(random);
      CurveLeaves together, alone;
      for (std::size_t k = 0; k < Leaves::kMost; ++k) {
        Leaves one = all;
        one.x.fill(all.x[k]), one.y.fill(all.y[k]), one.wanted = 1;
        if (parabola) {
          parabola_leaves(*parabola, all, together), parabola_leaves(*parabola, one, alone);
          ASSERT_EQ(numbers(together, k, 2), numbers(alone, 0, 2)) << "parabola " << i;
        }
        if (ellipse) {
          ellipse_leaves(*ellipse, all, together), ellipse_leaves(*ellipse, one, alone);
          ASSERT_EQ(numbers(together, k, 1), numbers(alone, 0, 1)) << "ellipse " << i;
        }
      }
    }
  });
}

TEST(LeafOutlines, AskForSmallerLeavesWhereNothingIsProven) {
  Leaves leaves{.wanted = 1, .radius = 11.4};
  leaves.x.fill(0), leaves.y.fill(0);
  std::array<LeafOutline, Leaves::kMost> found;
  std::vector<LeafEdge> edges;
  const OffsetShape shape{ParabolaSide{{0, 0}, {0, 1}, 2.0}, 0};
  LeafOutlines(shape).in_leaves(leaves, found, edges);
  EXPECT_FALSE(found[0].error < 0.25);
}

}  // namespace
}  // namespace mien
