#include <mien/render/shade/lit_cells.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

/// Cells beside two half-planes, d = max of two, whose crease runs through the square.
TEST(LitCells, AreCutByRidgesAndByTheZonesEnd) {
  test::on_every_set([] {
    test::Random random(13);
    for (int k = 0; k < 200; ++k) {
      auto scene = test::random_lit(random, 3, 40, Profile::bevel, Blend::srgb);
      scene.paint.relief->domes.clear();
      const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
      const glm::dvec2 n[2] = {random.direction(), random.direction()};
      const double at[2] = {random.between(-0.3, 0.1), random.between(-0.3, 0.1)};
      const auto branch = [&](glm::dvec2 p) {
        return glm::dot(n[0], p) + at[0] > glm::dot(n[1], p) + at[1] ? 0 : 1;
      };
      LitCells cells;
      cells.x = cells.y = 0, cells.side = 0.25f, cells.shallow = 0, cells.deep = 1e9f;
      for (int i = 0; i < LitCells::kPlaces; ++i) {
        const glm::dvec2 p = 0.25 * glm::dvec2{i % LitCells::kRow - 2.5, i / LitCells::kRow - 2.5};
        const int b = branch(p);
        cells.d[std::size_t(i)] = float(glm::dot(n[b], p) + at[b]);
        cells.nx[std::size_t(i)] = float(n[b].x), cells.ny[std::size_t(i)] = float(n[b].y);
        cells.bend[std::size_t(i)] = 0;
      }
      LampLanes lamp;
      set_lamp(surface, 1, {0, 0}, 13.0, lamp);
      color_cells(lamp, cells);
      double area = 0, red = 0, expected_area = 0, expected_red = 0;
      bool divide = false;
      for (std::size_t i = 0; i < std::size_t(LitCells::kCells); ++i) {
        area += cells.area[i] / 16.0, red += cells.area[i] * cells.r[i] / 16.0;
        divide |= cells.divide[i] != 0.0f;
      }
      constexpr int kPlaces = 200;
      for (int j = 0; j < kPlaces; ++j)
        for (int i = 0; i < kPlaces; ++i) {
          const glm::dvec2 p{(i + 0.5) / kPlaces - 0.5, (j + 0.5) / kPlaces - 0.5};
          const int b = branch(p);
          const double d = glm::dot(n[b], p) + at[b];
          if (d > 0.0) continue;
          expected_area += 1.0, expected_red += surface.color(1, p, {d, n[b]}).r;
        }
      expected_area /= kPlaces * kPlaces, expected_red /= kPlaces * kPlaces;
      // Cells that ask to be divided are off by a part of themselves.
      EXPECT_NEAR(area, expected_area, divide ? 0.03 : 0.003) << k;
      EXPECT_NEAR(red, expected_red, divide ? 0.03 : 0.003) << k;
    }
  });
}

}  // namespace
}  // namespace mien
