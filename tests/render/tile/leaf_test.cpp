// Leaves in vectors against the scalar form, on every instruction set.

#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/leaf.h>
#include <mien/sdf/batch/instruction_sets.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/every_instruction_set.h"

namespace mien {
namespace {

using test::on_every_set;

/// Colours by the rule "inside all edges": white in, black out.
void color_all(Leaf& leaf, Blend blend) {
  const int all = (1 << leaf.edge_count) - 1;
  for (int s = 0; s < Leaf::kMostSides; ++s) {
    const bool in = (s & all) == all;
    for (std::size_t c = 0; c < 4; ++c) leaf.palette[c][std::size_t(s)] = in || c == 3 ? 255.0f : 0;
    leaf.packed[std::size_t(s)] = in ? 0xFFFFFFFFu : 0xFF000000u;
    leaf.same[std::size_t(s)] = in;
  }
  leaf.blend = blend;
}

LeafEdge random_edge(std::mt19937_64& random, double bend) {
  std::uniform_real_distribution<float> unit(-1, 1);
  const float angle = 3.2f * unit(random);
  return {.x = 6 * unit(random),
          .y = 6 * unit(random),
          .nx = std::cos(angle),
          .ny = std::sin(angle),
          .bend = float(bend) * unit(random),
          .c3 = 2e-5f * unit(random),
          .c4 = 1e-6f * unit(random),
          .turn = 1};
}

void compare(const Leaf& leaf, double allowed) {
  alignas(64) std::array<std::uint32_t, 256> pixels;
  LeafPixels left;
  paint_leaf(leaf, 0xFFFF, pixels.data(), 16, left);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const auto i = std::size_t(16 * y + x);
      long long cells = 0;
      const Mix truth = leaf_pixel(leaf, x - 7.5, y - 7.5, 1.0 / 65536, cells);
      std::uint32_t want = 0;
      store(truth / 255.0, leaf.blend, Depth::u8, &want);
      const double off = std::abs(double(pixels[i] & 255u) - double(want & 255u));
      ASSERT_LE(off, allowed) << x << ' ' << y << " truth " << truth.r;
    }
}

TEST(PaintLeaf, IsItsScalarForm) {
  on_every_set([] {
    std::mt19937_64 random(1);
    for (int i = 0; i < 400; ++i) {
      Leaf leaf;
      leaf.edge_count = 1 + i % 3;
      const double bend = std::array{0.0, 0.005, 0.02, 0.1, 0.5}[std::size_t(i / 3 % 5)];
      for (int e = 0; e < leaf.edge_count; ++e)
        leaf.edges[std::size_t(e)] = random_edge(random, bend);
      color_all(leaf, Blend::srgb);
      compare(leaf, 1);  // both rounded, from values that are at most a third of a level apart
      if (HasFatalFailure()) return;
    }
  });
}

TEST(PaintLeaf, FollowsAJointFromBodyToBody) {
  on_every_set([] {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 300; ++i) {
      // Two circles that touch at a point of the leaf, with one normal there.
      const double most = std::array{0.01, 0.04, 0.08}[std::size_t(i % 3)];
      Leaf leaf;
      leaf.edge_count = 1;
      LeafEdge& e = leaf.edges[0] = random_edge(random, most);
      e.x *= 0.5f, e.y *= 0.5f, e.c3 = e.c4 = 0;
      e.joined = true;
      e.next = {e.x, e.y, e.nx, e.ny, float(most * unit(random)), 0, 0};
      e.end_x = e.x, e.end_y = e.y, e.along_x = -e.ny, e.along_y = e.nx;
      color_all(leaf, Blend::srgb);
      compare(leaf, 1);
      if (HasFatalFailure()) return;
    }
  });
}

/// Both sides of a line that ends in a half disc, of a random place.
void add_line(std::mt19937_64& random, glm::vec2 end, float half_width, Leaf& leaf) {
  std::uniform_real_distribution<float> unit(-1, 1);
  const float angle = 3.2f * unit(random);
  const glm::vec2 along{std::cos(angle), std::sin(angle)};
  for (const float side : {1.0f, -1.0f}) {
    const glm::vec2 n = side * glm::vec2{-along.y, along.x},
                    at = end + half_width * n - 2.0f * along;
    leaf.edges[std::size_t(leaf.edge_count++)] = {.x = at.x,
                                                  .y = at.y,
                                                  .nx = n.x,
                                                  .ny = n.y,
                                                  .bend = 0,
                                                  .c3 = 0,
                                                  .c4 = 0,
                                                  .turn = 1,
                                                  .end_x = end.x,
                                                  .end_y = end.y,
                                                  .along_x = along.x,
                                                  .along_y = along.y,
                                                  .other_x = along.x,
                                                  .other_y = along.y,
                                                  .end_bend = 1 / half_width,
                                                  .end_nx = n.x,
                                                  .end_ny = n.y,
                                                  .error = 0};
  }
}

/// Colours by the rule "inside edges 0 and 1, or 2 and 3".
void color_two_lines(Leaf& leaf) {
  color_all(leaf, Blend::srgb);
  for (int s = 0; s < Leaf::kMostSides; ++s) {
    const bool in = (s & 3) == 3 || (s & 12) == 12;
    for (std::size_t c = 0; c < 3; ++c) leaf.palette[c][std::size_t(s)] = in ? 255.0f : 0;
    leaf.packed[std::size_t(s)] = in ? 0xFFFFFFFFu : 0xFF000000u;
    leaf.same[std::size_t(s)] = in;
  }
}

TEST(PaintLeaf, DrawsLinesThatMeet) {
  on_every_set([] {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int i = 0; i < 200; ++i) {
      Leaf leaf;
      const float half_width = 0.25f * std::pow(2.0f, float(i % 7));
      const glm::vec2 joint{3 * unit(random), 3 * unit(random)};
      add_line(random, joint, half_width, leaf);
      if (i % 3 > 0) add_line(random, joint, half_width, leaf);
      color_two_lines(leaf);
      compare(leaf, 1);
      if (HasFatalFailure()) return;
    }
  });
}

TEST(SquareInParts, IsItsScalarForm) {
  on_every_set([] {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int i = 0; i < 1500; ++i) {
      Leaf leaf;
      leaf.edge_count = 0;
      const glm::vec2 joint{unit(random), unit(random)};
      const float half_width = 0.25f * std::pow(2.0f, float(i % 6));
      if (i % 4 == 0) add_line(random, joint, half_width, leaf);
      if (i % 8 == 0) add_line(random, joint, half_width, leaf);
      const double bend = std::array{0.0, 0.02, 0.1, 0.5, 2.0}[std::size_t(i / 3 % 5)];
      for (int e = i % 5; e >= 0 && leaf.edge_count < Leaf::kMostEdges; --e) {
        LeafEdge& edge = leaf.edges[std::size_t(leaf.edge_count++)] = random_edge(random, bend);
        edge.x = unit(random), edge.y = unit(random);
      }
      color_all(leaf, Blend::srgb);
      // Every combination its own colour, but a line is where both its sides are met.
      const int lines = i % 8 == 0 ? 2 : i % 4 == 0 ? 1 : 0;
      for (int s = 0; s < Leaf::kMostSides; ++s) {
        int met = s;
        for (int line = 0; line < lines; ++line)
          if ((s >> 2 * line & 3) != 3) met &= ~(3 << 2 * line);
        leaf.palette[0][std::size_t(s)] = float(255 * (met * 7 % 32) / 31);
        leaf.same[std::size_t(s)] = std::uint8_t(met);
      }
      for (const double side : {1.0, 0.25, 0.0625}) {
        long long cells = 0;
        const std::uint32_t all = (1u << leaf.edge_count) - 1u;
        const double x = 0.7 * double(unit(random)), y = 0.7 * double(unit(random));
        const double truth = leaf_square(leaf, x, y, side, all, 0, 1e-6, cells).r;
        ASSERT_NEAR(square_in_parts(leaf, x, y, side, all, 0).r, truth, side == 1.0 ? 0.4 : 1.0)
            << i << ": " << leaf.edge_count << " edges, side " << side;
      }
    }
  });
}

TEST(PaintLeaf, EncodesLinearLight) {
  on_every_set([] {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100; ++i) {
      Leaf leaf;
      leaf.edge_count = 1;
      leaf.edges[0] = random_edge(random, 0.004);
      color_all(leaf, Blend::linear);
      compare(leaf, 1);
      if (HasFatalFailure()) return;
    }
  });
}

TEST(PaintLeaf, GivesTheSameBytesOnEverySetWithFusedArithmetic) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 50; ++i) {
    Leaf leaf;
    if (i % 2) {
      leaf.edge_count = 2;
      for (int e = 0; e < 2; ++e) leaf.edges[std::size_t(e)] = random_edge(random, 0.05);
      color_all(leaf, i % 4 == 1 ? Blend::srgb : Blend::linear);
    } else {
      for (int line = 0; line < 2; ++line) add_line(random, {0.3f, -0.8f}, 0.7f, leaf);
      color_two_lines(leaf);
    }
    std::array<std::uint32_t, 256> first{};
    bool have = false;
    for (const auto& set : batch::instruction_sets()) {
      if (!set.fused) continue;
      batch::use_instruction_set(set.id);
      std::array<std::uint32_t, 256> pixels{};
      LeafPixels left;
      paint_leaf(leaf, 0xFFFF, pixels.data(), 16, left);
      if (have) {
        EXPECT_EQ(pixels, first) << set.name;
      }
      first = pixels, have = true;
    }
  }
  batch::use_instruction_set(0);
}

TEST(LeafPixel, OfOneStraightEdgeIsTheClosedForm) {
  Leaf leaf;
  leaf.edge_count = 1;
  leaf.edges[0] = {
      .x = 0.2f, .y = 0, .nx = 0.6f, .ny = 0.8f, .bend = 0, .c3 = 0, .c4 = 0, .turn = 1};
  color_all(leaf, Blend::srgb);
  long long cells = 0;
  const double want = 255 * straight_edge_coverage(0.6 * (0.5 - 0.2f) + 0.8 * 0.5, {0.6, 0.8});
  EXPECT_NEAR(leaf_pixel(leaf, 0.5, 0.5, 1e-4, cells).r, want, 1e-4);
  EXPECT_EQ(cells, 0);
}

/// Area of the unit square around the origin inside a disc: rows of it are intervals, exactly.
double disc_in_square(glm::dvec2 center, double radius) {
  constexpr int kRows = 20000;
  double area = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const double y = (i + 0.5) / kRows - 0.5 - center.y;
    const double half = std::sqrt(std::max(0.0, radius * radius - y * y));
    area += std::max(0.0, std::min(0.5, center.x + half) - std::max(-0.5, center.x - half));
  }
  return area / kRows;
}

TEST(LeafPixel, OfATightCircleIsItsArea) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 600; ++i) {
    const double radius = 0.15 * std::pow(2.0, 3.0 * (1.0 + unit(random))),
                 angle = 3.2 * unit(random);
    const glm::dvec2 n{std::cos(angle), std::sin(angle)},
        foot{0.6 * unit(random), 0.6 * unit(random)};
    Leaf leaf;
    leaf.edge_count = 1;
    leaf.edges[0] = {.x = float(foot.x),
                     .y = float(foot.y),
                     .nx = float(n.x),
                     .ny = float(n.y),
                     .bend = float(1.0 / radius),
                     .c3 = 0,
                     .c4 = 0,
                     .turn = 1};
    color_all(leaf, Blend::srgb);
    long long cells = 0;
    const double area = disc_in_square(foot - radius * n, radius);
    EXPECT_NEAR(leaf_pixel(leaf, 0, 0, 1.0 / 2048, cells).r, 255 * area, 0.25)
        << "radius " << radius << " foot " << foot.x << ' ' << foot.y;
  }
}

}  // namespace
}  // namespace mien
