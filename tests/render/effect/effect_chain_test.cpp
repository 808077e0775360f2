// Items G9, G10: mosaic and grid against what they ought to be, sampled on a fine grid; and the same
// bytes however a picture is cut.

#include <gtest/gtest.h>

#include <mien/effect_chain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "render/blend/transfer.h"

namespace mien {
namespace {

Image noise(int width, int height, unsigned seed) {
  Image image{.width = width, .height = height, .depth = Depth::f32, .opaque = false};
  image.bytes.resize(image.stride() * std::size_t(height));
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform;
  auto* at = reinterpret_cast<float*>(image.bytes.data());
  for (int i = 0; i < width * height; ++i, at += 4) {
    at[3] = uniform(random);
    for (int c = 0; c < 3; ++c) at[c] = at[3] * uniform(random);
  }
  return image;
}

const float* pixel(const Image& image, int x, int y) {
  return reinterpret_cast<const float*>(image.row(y)) + 4 * x;
}

/// Largest difference in levels of 255, as a picture would show it.
double levels(const float* a, const double* b) {
  double worst = 0;
  for (int c = 0; c < 4; ++c)
    worst =
        std::max(worst, 255 * std::abs(srgb_from_linear(double(a[c])) - srgb_from_linear(b[c])));
  return worst;
}

/// The colour of a point of a mosaic, straight from its definition.
struct MosaicTruth {
  MosaicTruth(const Image& image, MosaicEffect mosaic)
      : effect(mosaic), side(double(image.width) / mosaic.tiles) {
    for (int j = 0; j * side < image.height; ++j)
      for (int i = 0; i < mosaic.tiles; ++i) means.push_back(mean(image, i * side, j * side));
  }

  MosaicEffect effect;
  double side;
  std::vector<std::array<double, 4>> means;

  std::array<double, 4> at(double x, double y) const {
    const int i = std::min(int(x / side), effect.tiles - 1), j = int(y / side);
    std::array<double, 4> color = means[std::size_t(j * effect.tiles + i)];
    const double u = x - i * side, v = y - j * side, bevel = 0.5 * effect.border * side;
    const double nearest = std::min({u, v, side - u, side - v});
    if (nearest >= bevel) return color;
    const double light = nearest == v          ? 0.36
                         : nearest == u        ? 0.18
                         : nearest == side - u ? -0.24
                                               : -0.44;
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = light > 0 ? color[c] + light * (color[3] - color[c]) : color[c] * (1 + light);
    return color;
  }
  std::array<double, 4> mean(const Image& image, double x0, double y0) const {
    const double y1 = std::min(y0 + side, double(image.height));
    std::array<double, 4> sum{};
    double area = 0;
    for (int y = int(y0); y < y1 && y < image.height; ++y)
      for (int x = int(x0); x < x0 + side && x < image.width; ++x) {
        const double part = (std::min(x + 1.0, x0 + side) - std::max(double(x), x0)) *
                            (std::min(y + 1.0, y1) - std::max(double(y), y0));
        area += part;
        for (std::size_t c = 0; c < 4; ++c) sum[c] += part * double(pixel(image, x, y)[c]);
      }
    for (double& s : sum) s /= area;
    return sum;
  }
};

// G9: exact against a supersampled truth to 1 level, tiles of any size, border or none.
TEST(EffectChain, MosaicIsTheSupersampledTruth) {
  const Image image = noise(37, 23, 5);
  for (const MosaicEffect effect : {MosaicEffect{5, 0}, MosaicEffect{7, 0.4}, MosaicEffect{3, 1},
                                    MosaicEffect{36, 0.2}, MosaicEffect{1, 0.7}}) {
    const Image out = with_effects(image, {effect});
    const MosaicTruth truth{image, effect};
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 37; x += 4) {
        constexpr int kGrid = 96;  // an edge along the samples is off by 1/192 of a pixel at most
        double sum[4] = {};
        for (int j = 0; j < kGrid; ++j)
          for (int i = 0; i < kGrid; ++i) {
            const auto color = truth.at(x + (i + 0.5) / kGrid, y + (j + 0.5) / kGrid);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += color[c] / (kGrid * kGrid);
          }
        EXPECT_LT(levels(pixel(out, x, y), sum), 1.0) << effect.tiles << ": " << x << " " << y;
      }
  }
}

// G9: many tiles are the picture; border 0 is none.
TEST(EffectChain, AsManyTilesAsPixelsAreThePicture) {
  const Image image = noise(40, 30, 1);
  const Image out = with_effects(image, {MosaicEffect{40, 0}});
  EXPECT_EQ(out.bytes, image.bytes);
}

TEST(EffectChain, CentersArePixels) {
  const Image image = noise(40, 30, 2);
  const Image out = with_effects(image, {MosaicEffect{4, 0, true}});
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(pixel(out, 3, 3)[c], pixel(image, 5, 5)[c]);
    EXPECT_EQ(pixel(out, 39, 29)[c], pixel(image, 35, 25)[c]);
  }
}

// G10: the line's width is exact: what a row loses is what the lines are wide.
TEST(EffectChain, GridLinesHaveTheirWidth) {
  Image image = noise(101, 60, 3);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = std::byte{0};
  for (const double width : {0.4, 1.0, 2.7}) {
    const Image out = with_effects(image, {GridEffect{7, width, {1, 1, 1, 1}}});
    double sum = 0;  // of a row between two level lines
    for (int x = 0; x < 101; ++x) sum += double(pixel(out, x, 7)[0]);
    EXPECT_NEAR(sum, 7 * width, 1e-5);
    const double at = 3 * 101.0 / 7;  // the fourth line
    for (int x = int(at) - 3; x < int(at) + 4; ++x) {
      const double part =
          std::max(0.0, std::min(x + 1.0, at + width / 2) - std::max(double(x), at - width / 2));
      EXPECT_NEAR(double(pixel(out, x, 7)[0]), part, 1e-6);
    }
  }
}

TEST(EffectChain, GridCrossingsCountOnce) {
  const Image image = noise(20, 20, 4);
  const GridEffect effect{2, 3, {0.2, 0.5, 0.8, 0.5}};
  const Image out = with_effects(image, {effect});
  const double line[] = {0.1, 0.25, 0.4, 0.5};
  for (int c = 0; c < 4; ++c)  // the pixel at the middle lies wholly under both lines
    EXPECT_NEAR(double(pixel(out, 10, 10)[c]), line[c] + 0.5 * double(pixel(image, 10, 10)[c]),
                1e-6);
}

// A chain reads no farther than the tiles under the row that it gives: that bounds what it holds.
TEST(EffectChain, ReadsNoFartherThanARowOfTiles) {
  const Image image = noise(53, 47, 6);
  const std::vector<Effect> effects{MosaicEffect{9, 0.3}, GridEffect{6, 1.5, {0, 0, 0, 1}}};
  const Image whole = with_effects(image, effects);
  int read = 0;
  EffectChain chain(effects, 53, 47, [&](float* row) {
    if (read == 47) return false;
    std::memcpy(row, image.row(read++), image.stride());
    return true;
  });
  std::vector<float> row(4 * 53);
  for (int y = 0; y < 47; ++y) {
    ASSERT_TRUE(chain.next(row.data()));
    EXPECT_EQ(std::memcmp(row.data(), whole.row(y), whole.stride()), 0) << y;
    EXPECT_LE(read, y + 1 + 53 / 9 + 1) << y;
  }
}

TEST(EffectChain, EndsWithItsPicture) {
  int rows = 0;
  EffectChain chain({MosaicEffect{1, 0}}, 4, 8, [&](float* row) {
    std::fill_n(row, 16, 0.5F);
    return ++rows < 3;
  });
  std::vector<float> row(16);
  EXPECT_FALSE(chain.next(row.data()));
  EXPECT_EQ(rows, 3);
}

/// How much of [at, at + 1] lies under lines, sampled: straight from the grid's definition.
double under_lines(const GridEffect& grid, double cell, int at) {
  constexpr int kSamples = 4096;
  int under = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double place = at + (i + 0.5) / kSamples;
    under += std::abs(place - std::round(place / cell) * cell) < 0.5 * grid.width;
  }
  return double(under) / kSamples;
}

// G10, and chains: a grid over a picture of any sides, and over a mosaic, is what sampling gives, to
// 1 level. A place is free where it is free across and down.
TEST(EffectChain, GridIsTheSupersampledTruthAlsoOverAMosaic) {
  for (const auto& [width, height] :
       {std::pair<int, int>{37, 23}, {19, 41}, {64, 2}, {1, 5}, {5, 1}}) {
    const Image image = noise(width, height, unsigned(width));
    for (const MosaicEffect& mosaic :
         {MosaicEffect{std::min(width, 6), 0.4}, MosaicEffect{1, 0}, MosaicEffect{width, 0}})
      for (const GridEffect& grid : {GridEffect{std::min(width, 5), 0.7, {0.9, 0.4, 0.1, 0.6}},
                                     GridEffect{1, 1, {0.3, 0.3, 1, 1}}}) {
        const Image below = with_effects(image, {mosaic});
        const Image out = with_effects(image, {mosaic, grid});
        const double cell = double(width) / grid.cells;
        const double line[] = {grid.color.r, grid.color.g, grid.color.b, 1};
        for (int y = 0; y < height; ++y)
          for (int x = 0; x < width; ++x) {
            const double free = (1 - under_lines(grid, cell, x)) * (1 - under_lines(grid, cell, y));
            const double share = (1 - free) * grid.color.a;
            double truth[4];
            for (std::size_t c = 0; c < 4; ++c)
              truth[c] = share * line[c] + (1 - share) * double(pixel(below, x, y)[c]);
            EXPECT_LT(levels(pixel(out, x, y), truth), 1.0) << width << ": " << x << " " << y;
          }
      }
  }
}

TEST(EffectChain, OnlyThoseActThatChangeThePicture) {
  const std::vector<Effect> idle{MosaicEffect{64, 0}, MosaicEffect{64, 0, true}, GridEffect{7, 0},
                                 GridEffect{7, 2, {1, 1, 1, 0}}};
  EXPECT_TRUE(acting_effects(idle, 64).empty());
  EXPECT_EQ(acting_effects({idle[0], MosaicEffect{64, 0.1}, idle[2], GridEffect{7}}, 64).size(),
            2u);
  EXPECT_EQ(acting_effects(idle, 65).size(), 2u);
}

TEST(EffectChain, RefusesWhatThePictureIsTooSmallFor) {
  EXPECT_TRUE(check_effect(MosaicEffect{64, 0.2}, 64));
  EXPECT_EQ(check_effect(MosaicEffect{65}, 64).error().what,
            "a mosaic of 65 tiles across needs as many pixels, not 64");
  EXPECT_FALSE(check_effect(GridEffect{65}, 64));
  EXPECT_EQ(check_effect(GridEffect{16, 5}, 64).error().what,
            "lines of 5 pixels are wider than the grid's cells of 4");
}

TEST(EffectChain, DepthsRoundAsPicturesDo) {
  Image image = noise(5, 1, 7);
  auto* at = reinterpret_cast<float*>(image.bytes.data());
  at[0] = at[1] = 0.5F, at[2] = 0, at[3] = 1;
  const Image out = at_depth(image, Depth::u8);
  EXPECT_EQ(out.row(0)[0], 188);
  EXPECT_EQ(out.row(0)[2], 0);
  EXPECT_EQ(out.row(0)[3], 255);
}

}  // namespace
}  // namespace mien
