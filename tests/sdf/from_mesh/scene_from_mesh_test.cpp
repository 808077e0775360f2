// Meshes drawn: no seams between neighbours, the nearest on top, light from above.

#include <gtest/gtest.h>

#include <mien/render.h>
#include <mien/scene_from_mesh.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>

#include "tests/support/pictures/rendered.h"

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

/// The light of a triangle whose normal is `normal`, beside that of one which faces the lamp.
double shade_of(glm::dvec3 normal) {
  const auto red = [](glm::dvec3 n) {
    const auto over = [&](double x, double y) {
      return glm::dvec3{x, y, -(n.x * x + n.y * y) / n.z};
    };
    const Mesh mesh{{over(0, 0), over(1, 0), over(0, 1)}, {{0, 1, 2}}};
    const auto image = render(scene_from_mesh(mesh, {}, {.box = {{0, 0}, {1, 1}}}),
                              {.width = 32, .height = 32}, {.depth = Depth::f32});
    float value = 0;
    std::memcpy(&value, image->row(28) + 16 * 3, sizeof value);
    return double(value);
  };
  return red(normal) / red({-0.45, 0.55, 0.8});
}

TEST(SceneFromMesh, LightComesFromAboveOnTheLeft) {
  const glm::dvec3 lamp = glm::normalize(glm::dvec3{-0.45, 0.55, 0.8});
  for (const glm::dvec3 n :
       {glm::dvec3{0, 0, 1}, glm::dvec3{-0.6, 0, 0.8}, glm::dvec3{0, -0.6, 0.8}})
    EXPECT_NEAR(shade_of(n), 0.25 + 0.75 * glm::dot(n, lamp), 1e-6);
  // Turned away from it, all are as dark.
  EXPECT_NEAR(shade_of({0.8, -0.6, 0.05}), 0.25, 1e-6);
  EXPECT_NEAR(shade_of({0.6, -0.8, 0.02}), 0.25, 1e-6);
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
