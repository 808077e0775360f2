// Meshes drawn: no seams between neighbours, the nearest on top, light from above.

#include <gtest/gtest.h>

#include <mien/render.h>
#include <mien/scene_from_mesh.h>

#include <algorithm>

#include "tests/support/rendered.h"

namespace mien {
namespace {

/// A sheet of n × n squares, two triangles each, bumped so that edges lie at all angles.
Mesh sheet(int n) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool rim = i == 0 || j == 0 || i == n || j == n;
      const double dx = rim ? 0 : 0.3 * std::sin(7.0 * i + 3 * j);
      const double dy = rim ? 0 : 0.3 * std::cos(5.0 * i - 4 * j);
      mesh.points.emplace_back((i + dx) / n, (j + dy) / n, 0.0);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({d, c, a});
    }
  return mesh;
}

TEST(SceneFromMesh, NeighboursLeaveNoSeam) {
  const Scene scene = scene_from_mesh(sheet(6), {}, {.box = {{0, 0}, {1, 1}}});
  const Image image = test::rendered(scene, {.width = 97, .height = 97});
  const std::uint8_t* first = image.row(0);
  for (int y = 0; y < 97; ++y)
    for (int x = 0; x < 97; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.row(y)[4 * x + c], first[c]) << x << " " << y;
  EXPECT_GT(first[0], 100);
}

TEST(SceneFromMesh, TheNearestIsOnTopWhateverTheOrder) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
            {{0, 1, 2}, {3, 4, 5}}};
  const std::vector<double> amounts{0, 0, 0, 1, 1, 1};
  const MeshLook look{.box = {{0, 0}, {1, 1}}};
  const Image a = test::rendered(scene_from_mesh(mesh, amounts, look), {.width = 32, .height = 32});
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const Image b = test::rendered(scene_from_mesh(mesh, amounts, look), {.width = 32, .height = 32});
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_GT(a.row(28)[4 * 3], a.row(28)[4 * 3 + 2]);  // red, the near one's amount, over blue
}

TEST(SceneFromMesh, PointsWithoutTrianglesAreDiscsAndFlatOnesAreNothing) {
  const Mesh points{{{0, 0, 0}, {1, 1, 0}}, {}};
  EXPECT_EQ(scene_from_mesh(points).layers().size(), 2u);
  const Mesh edge{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(scene_from_mesh(edge).layers().size(), 0u);
  EXPECT_EQ(scene_from_mesh({}).layers().size(), 0u);
  const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(scene_from_mesh(one, {}, {.wire = 0.01}).layers().size(), 4u);
}

}  // namespace
}  // namespace mien
