#include <mien/render/shade/lit_tile.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

TEST(LitTile, NodesReachFromCornerToCorner) {
  EXPECT_EQ(node_at(0), (glm::vec2{-8, -8}));
  EXPECT_EQ(node_at(35), (glm::vec2{8, 8}));
}

TEST(LitTile, PatchesAreRightForPolynomialsOfDegreeFive) {
  LitTile tile;
  const auto f = [](glm::vec2 p) {
    const float x = p.x / 8, y = p.y / 8;
    return 0.5f + 0.1f * x * x * x * x * x - 0.2f * x * y * y * y * y + 0.05f * y;
  };
  for (int k = 0; k < 36; ++k)
    tile.node_r[std::size_t(k)] = tile.node_g[std::size_t(k)] = tile.node_b[std::size_t(k)] =
        f(node_at(k));
  for (const glm::vec2 p : {glm::vec2{0.3f, -4.7f}, {7.9f, 7.1f}, {-8, 8}})
    EXPECT_NEAR(patch_at(tile, p).x, f(p), 1e-5);
}

}  // namespace
}  // namespace mien
