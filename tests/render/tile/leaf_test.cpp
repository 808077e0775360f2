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
  std::array<bool, 256> skipped{};
  for (int i = 0; i < left.count; ++i) skipped[left.at[std::size_t(i)]] = true;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const auto i = std::size_t(16 * y + x);
      if (skipped[i]) continue;
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
    leaf.edge_count = 2;
    for (int e = 0; e < 2; ++e) leaf.edges[std::size_t(e)] = random_edge(random, 0.05);
    color_all(leaf, Blend::srgb);
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
