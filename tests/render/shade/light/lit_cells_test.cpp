#include "render/shade/light/lit_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

/// A lamp from the side over a roof whose ridge runs along x = at.
struct Roof {
  LampLanes lamp;
  LitCells cells;

  Roof() {
    lamp.rise_kind = LampLanes::Rise::constant, lamp.rise = 0.5f;
    lamp.light = {0.5f, 0.5f, 0.5f}, lamp.linear = true;
    lamp.to_lamp = {-0.6f, 0.0f, 0.8f}, lamp.halfway = {-0.3f, 0.0f, 0.9f};
    lamp.ambient = 0.2f, lamp.diffuse = 1.0f;
    cells.x = 0, cells.y = 0, cells.shallow = -1e9f, cells.deep = 1e9f;
  }

  LitMean mean(int side, float at) {
    PartCells parts;
    whole_cells(side, parts);
    return mean(parts, at);
  }

  LitMean mean(const PartCells& parts, float at) {
    cells.take(parts, true);
    for (std::size_t k = 0; k < std::size_t(cells.places()); ++k) {
      const float off = cells.foot_x[k] - at;
      cells.d[k] = std::abs(off) - 5.0f, cells.nx[k] = off < 0.0f ? -1.0f : 1.0f;
      cells.ny[k] = 0.0f, cells.bend[k] = 0.0f;
    }
    return mean_of_cells(lamp, cells);
  }
};

TEST(LitCells, AreCutByRidgesInClosedForm) {
  test::on_every_set([] {
    Roof roof;
    const float bright = roof.mean(4, 9.0f).r, dark = roof.mean(4, -9.0f).r;
    ASSERT_GT(std::abs(bright - dark), 0.1f);
    for (const int side : {4, 8, 16})
      for (float at = -0.45f; at < 0.46f; at += 0.037f) {
        const float want = bright * (0.5f + at) + dark * (0.5f - at);
        EXPECT_NEAR(roof.mean(side, at).r, want, 1e-4) << side << ' ' << at;
      }
  });
}

/// What an outline leaves of a cell may lie wholly beyond a ridge that runs through the cell.
TEST(LitCells, GoByWhatIsLeftOfThem) {
  test::on_every_set([] {
    Roof roof;
    const float dark = roof.mean(4, -9.0f).r;
    PartCells parts;
    whole_cells(4, parts);
    std::fill_n(parts.area.begin(), 16, 0.0f);
    parts.area[15] = 4e-4f, parts.x[15] = 0.49f, parts.y[15] = 0.49f;
    for (const float at : {0.40f, 0.45f}) EXPECT_NEAR(roof.mean(parts, at).r, dark, 1e-5) << at;
  });
}

TEST(LitCells, SayHowFarColoursAreFromAPlane) {
  Roof roof;
  EXPECT_NEAR(roof.mean(4, 9.0f).rough, 0.0f, 1e-5);
  const LitMean ridged = roof.mean(4, 0.1f);
  EXPECT_GT(ridged.jump, 0.1f);
  EXPECT_GT(ridged.rough, 0.01f);
}

}  // namespace
}  // namespace mien
