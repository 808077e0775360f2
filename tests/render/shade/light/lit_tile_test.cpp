#include "render/shade/light/lit_tile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/support/every_instruction_set.h"

namespace mien {
namespace {

/// A disc around (x, y) from the tile's middle.
FootAt foot_on_disc(double x, double y, double radius, double px, double py) {
  const double r = std::hypot(px - x, py - y);
  return {float(r - radius), float((px - x) / r), float((py - y) / r), float(1.0 / r)};
}

void set_blocks(LitTile& tile, auto&& foot) {
  for (int j = 0; j < LitTile::kBlocks; ++j)
    for (int i = 0; i < LitTile::kBlocks; ++i) {
      const FootAt at = foot(2.0 * i - 8.0, 2.0 * j - 8.0);
      const auto k = std::size_t(j * LitTile::kBlocks + i);
      tile.block_d[k] = at.d, tile.block_nx[k] = at.nx;
      tile.block_ny[k] = at.ny, tile.block_bend[k] = at.bend;
    }
}

TEST(LitTile, SpreadsItsBlocksFeetToAllPixels) {
  test::on_every_set([] {
    const auto tile = std::make_unique<LitTile>();
    const auto foot = [](double x, double y) { return foot_on_disc(-30, 12, 40, x, y); };
    set_blocks(*tile, foot);
    spread_feet(*tile);
    for (int j = 0; j < LitTile::kRow; ++j)
      for (int i = 0; i < LitTile::kRow; ++i) {
        const FootAt want = foot(i - 8.5, j - 8.5);
        const auto k = std::size_t(j * LitTile::kRow + i);
        EXPECT_NEAR(tile->d[k], want.d, 1e-3);
        EXPECT_NEAR(tile->nx[k], want.nx, 1e-3);
        EXPECT_NEAR(tile->ny[k], want.ny, 1e-3);
      }
    for (const float beside : tile->ridge) EXPECT_GT(beside, 100.0f);
  });
}

TEST(LitTile, TellsHowFarARidgeIsBesideAPixel) {
  test::on_every_set([] {
    const auto tile = std::make_unique<LitTile>();
    const auto foot = [](double x, double) {
      const double off = x - 1.3;
      return FootAt{float(std::abs(off) - 9.0), off < 0.0 ? -1.0f : 1.0f, 0.0f, 0.0f};
    };
    set_blocks(*tile, foot);
    spread_feet(*tile);
    for (int i = 0; i < LitTile::kSide; ++i) {
      const double middle = i - 7.5, beside = std::abs(middle - 1.3) - 0.5;
      if (beside < 1.0) {
        EXPECT_NEAR(tile->ridge[std::size_t(5 * LitTile::kSide + i)], beside, 1e-4) << i;
      }
    }
  });
}

TEST(LitTile, IsSmoothWhereAPolynomialTellsItsLight) {
  test::on_every_set([] {
    const auto tile = std::make_unique<LitTile>();
    LampLanes& lamp = tile->lamp;
    lamp.rise_kind = LampLanes::Rise::round, lamp.rise = 0.8f;
    lamp.width = 300, lamp.one_over_width = 1.0f / 300, lamp.light = {0.5f, 0.4f, 0.3f};
    lamp.linear = true, lamp.ambient = 0.3f, lamp.diffuse = 0.8f;
    lamp.to_lamp = {-0.5f, 0.1f, 0.8f}, lamp.halfway = {-0.3f, 0.1f, 0.9f};
    SmoothPlaces at;
    const auto fill = [&](double x, double y, double radius) {
      for (std::size_t k = 0; k < std::size_t(SmoothPlaces::kCount); ++k) {
        const FootAt foot = foot_on_disc(x, y, radius, double(at.x[k]), double(at.y[k]));
        at.d[k] = foot.d, at.nx[k] = foot.nx, at.ny[k] = foot.ny, at.bend[k] = foot.bend;
      }
    };
    fill(150, 90, 330);
    ASSERT_TRUE(smooth_means(at, 0.1f / 255, *tile));
    const auto tile_of = [&] {
      set_blocks(*tile, [](double x, double y) { return foot_on_disc(150, 90, 330, x, y); });
      tile->rises = true;
      spread_feet(*tile), shade_tile(*tile, 0.3f);
    };
    tile_of();
    for (std::size_t k = 0; k < std::size_t(LitTile::kPixels); ++k) {
      EXPECT_EQ(tile->trust[k], LitTile::Trust::around);
      EXPECT_NEAR(tile->smooth_r[k], tile->mean_r[k], 0.1f / 255);
      EXPECT_NEAR(tile->smooth_b[k], tile->mean_b[k], 0.1f / 255);
    }
    fill(2, 3, 200);  // a peak
    EXPECT_FALSE(smooth_means(at, 0.1f / 255, *tile));
  });
}

}  // namespace
}  // namespace mien
