#include "render/shade/light/light_tile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/scenes/lit_scene.h"
#include "tests/support/shapes/every_instruction_set.h"
#include "tests/support/shapes/tile_cells.h"

namespace mien {
namespace {

constexpr glm::dvec2 kMiddle{24.0, 24.0};

/// On ridges and close to evolutes a place may be seen by either branch, or late.
TEST(LightTile, ColoursAreTheSurfacesOwn) {
  test::on_every_set([] {
    test::Random random(31);
    long all = 0, off = 0;
    for (int k = 0; k < 240; ++k) {
      const Blend blend = k % 3 ? Blend::srgb : Blend::linear;
      auto scene = test::random_lit(random, k % test::kLitShapes, 40, Profile(1 + k % 3), blend);
      const RampSegment segment{{0.05, 0.1, 0.15, 0.3}, {0.1, 0.2, 0.25, 0.3}, 0.0, 1.0};
      const bool ramp = k % 4 == 1;
      if (ramp) {
        scene.paint.ramp.emplace(Gradient{.along = LinearGradient{},
                                          .stops = {{0.0, {1, 1, 1, 1}}, {1.0, {0, 0, 0, 1}}}},
                                 1.0, blend);
        scene.paint.field.kind = k % 8 == 1 ? PaintField::Kind::radial : PaintField::Kind::linear;
        scene.paint.field.center = {30, 35}, scene.paint.field.unit = {0.02, 0.01, -0.01, 0.02};
        scene.paint.field.across = {0.02, 0.01}, scene.paint.field.shift = -0.3;
      }
      const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
      const int zone = surface.zone_of(surface.outward(kMiddle).d);
      if (surface.flat(zone)) continue;
      const LitPiece piece(zone, ramp ? &segment : nullptr);
      const FeetArea area(*surface.area(), {0, 0});
      CellScratch scratch;
      LightGround ground;
      LightTile tile;
      tile.ground = &ground, tile.scratch = &scratch;
      tile.x = tile.y = 16, tile.rises = true, tile.channels = 4, tile.tolerance = 1e-3f;
      set_lamp(surface, piece, kMiddle, 12, tile.lamp);
      ground.area.narrow(area, kMiddle, 12);
      if (ground.area.crowded()) continue;
      tile.begin_ground(), tile.begin();
      test::SeenCells seen;
      for (int i = 0; i < 16; i += 3) {
        test::see(tile, i, 15 - i, seen);
        for (std::size_t q = 0; q < 16; ++q) {
          const glm::dvec2 p = test::place(seen, i, 15 - i, q);
          const Outward at = surface.outward(p);
          if (surface.zone_of(at.d) != zone) continue;
          const Mix want = surface.color(piece, p, at);
          double worst = 0.0;
          for (std::size_t c = 0; c < 4; ++c)
            worst = std::max(worst, std::abs(double(seen.c[c][q]) - want[int(c)]));
          ++all, off += worst > 2e-3;
        }
      }
    }
    EXPECT_GT(all, 3000);
    EXPECT_LT(double(off), 4e-3 * double(all));
  });
}

/// How far means of pixels are from those of many places, where a square's bicubic tells them [of the tolerance].
class SmoothMeans {
 public:
  void judge(test::LitScene& scene, Blend blend) {
    const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
    const int zone = surface.zone_of(surface.outward(kMiddle).d);
    if (surface.flat(zone)) return;
    const LitPiece piece(zone, nullptr);
    const FeetArea area(*surface.area(), {0, 0});
    CellScratch scratch;
    LightGround ground;
    LightTile tile;
    tile.ground = &ground, tile.scratch = &scratch;
    tile.x = tile.y = 16, tile.rises = true, tile.channels = 3, tile.tolerance = kTolerance;
    set_lamp(surface, piece, kMiddle, 12, tile.lamp);
    ground.area.narrow(area, kMiddle, 12);
    if (ground.area.crowded()) return;
    tile.begin_ground(), tile.begin();
    for (int p = 0; p < LightTile::kPixels; p += 3)
      judge_pixel(surface, piece, tile, p % 16, p / 16);
  }
  long all = 0;
  double worst = 0.0;

 private:
  static constexpr float kTolerance = 0.1f / 255;
  void judge_pixel(const LitSurface& surface, const LitPiece& piece, LightTile& tile, int i,
                   int j) {
    find_mean(tile, i, j);
    if (!test::in_a_smooth_square(tile, i, j)) return;
    constexpr int kPlaces = 20;
    Mix sum{0.0};
    for (int q = 0; q < kPlaces * kPlaces; ++q) {
      const glm::dvec2 p = glm::dvec2{16 + i, 16 + j} +
                           (glm::dvec2{q % kPlaces, q / kPlaces} + 0.5) / double(kPlaces);
      const Outward at = surface.outward(p);
      if (surface.zone_of(at.d) != piece.zone) return;
      sum += surface.color(piece, p, at);
    }
    double off = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
      off = std::max(off, std::abs(double(tile.mean[c][std::size_t(16 * j + i)]) -
                                   sum[int(c)] / (kPlaces * kPlaces)));
    off /= double(kTolerance);
    ++all, worst = std::max(worst, off);
  }
};

/// Squares keep what their bounds allow: one that passes more is seen here.
TEST(LightTile, SmoothSquaresKeepTheirTolerance) {
  test::on_every_set([] {
    test::Random random(33);
    SmoothMeans means;
    for (int k = 0; k < 800; ++k) {
      const Blend blend = k % 3 ? Blend::srgb : Blend::linear;
      auto scene = test::random_lit(random, k % test::kLitShapes, random.between(12, 96),
                                    Profile(1 + k % 3), blend);
      means.judge(scene, blend);
    }
    EXPECT_GT(means.all, 1000);
    EXPECT_LT(means.worst, 0.35);
  });
}

}  // namespace
}  // namespace mien
