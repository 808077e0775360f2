// Items G1 and G6 for heads of triangles.

#include <gtest/gtest.h>

#include <mien/mesh_morph.h>

#include <algorithm>

#include "tests/support/faces/head_mesh.h"

namespace mien {
namespace {

using test::head_mesh;
using test::HeadShape;

TEST(MeshMorph, EndsAreBitForBitAndBetweenItIsLinear) {
  const Mesh neutral = head_mesh(9, HeadShape::neutral);
  const std::vector<Mesh> targets{head_mesh(9, HeadShape::smile), head_mesh(9, HeadShape::ah)};
  const auto at = [&](double smile, double ah) {
    return morphed_mesh(neutral, targets, std::vector<double>{smile, ah}).points;
  };
  EXPECT_EQ(at(0, 0), neutral.points);
  EXPECT_EQ(at(1, 0), targets[0].points);
  EXPECT_EQ(at(0, 1), targets[1].points);
  const auto both = at(0.3, -1.7);
  for (std::size_t i = 0; i < both.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double rest = neutral.points[i][c];
      const double wanted =
          rest + 0.3 * (targets[0].points[i][c] - rest) - 1.7 * (targets[1].points[i][c] - rest);
      EXPECT_NEAR(both[i][c], wanted, 1e-14);
    }
}

TEST(MeshMorph, DistancesGrowWithTheWeight) {
  const Mesh neutral = head_mesh(9, HeadShape::neutral);
  const std::vector<Mesh> targets{head_mesh(9, HeadShape::ah)};
  const auto half = point_distances(neutral, morphed_mesh(neutral, targets, std::vector{0.5}));
  const auto whole = point_distances(neutral, targets[0]);
  EXPECT_GT(*std::max_element(whole.begin(), whole.end()), 0.1);
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(half[i], 0.5 * whole[i], 1e-14);
}

}  // namespace
}  // namespace mien
