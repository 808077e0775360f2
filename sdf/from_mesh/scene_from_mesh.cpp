#include <mien/scene_from_mesh.h>

#include "sdf/from_face/heat.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mien {
namespace {

constexpr double kAmbient = 0.25;
constexpr double kMarker = 0.004;  // radius of a lone point, of the picture's longer side

glm::dvec2 flat(const glm::dvec3& p) {
  return {p.x, p.y};
}

Box2 box_of(const Mesh& mesh) {
  Box2 box;
  for (const glm::dvec3& p : mesh.points) box = around(box, flat(p));
  if (box.empty()) return {{-1, -1}, {1, 1}};
  const double margin = std::max({box.size().x, box.size().y, 1e-9}) * 0.05;
  return grown(box, margin);
}

Color times(const Color& c, double light) {
  return {c.r * light, c.g * light, c.b * light, c.a};
}

/// Triangles in the order they are painted: by the depth of their middle, then by number, so that
/// the order never depends on the sorting.
std::vector<int> far_to_near(const Mesh& mesh) {
  std::vector<double> depth;
  for (const auto& t : mesh.triangles)
    depth.push_back(mesh.points[std::size_t(t[0])].z + mesh.points[std::size_t(t[1])].z +
                    mesh.points[std::size_t(t[2])].z);
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return depth[std::size_t(a)] < depth[std::size_t(b)]; });
  return order;
}

class MeshPainter {
 public:
  MeshPainter(const Mesh& mesh, std::span<const double> amounts, const MeshLook& look,
              SceneBuilder& build)
      : mesh_(mesh), amounts_(amounts), look_(look), build_(build) {}

  void triangle(int index) {
    const auto& t = mesh_.triangles[std::size_t(index)];
    const glm::dvec3 a = point(t[0]), b = point(t[1]), c = point(t[2]);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    if (across.z == 0) return;  // seen from its edge
    const glm::dvec3 normal = glm::normalize(across.z > 0 ? across : -across);
    const glm::dvec3 light = glm::normalize(glm::dvec3{-0.45, 0.55, 0.8});
    const double shade = kAmbient + (1 - kAmbient) * std::max(glm::dot(normal, light), 0.0);
    build_.layer("triangle", build_.shape(Triangle{flat(a), flat(b), flat(c)}),
                 {.color = times(color_of(t), shade)});
    if (look_.wire <= 0) return;
    for (int i = 0; i < 3; ++i)
      build_.layer("edge",
                   build_.shape(Line{flat(point(t[std::size_t(i)])),
                                     flat(point(t[std::size_t((i + 1) % 3)])), look_.wire}),
                   {.color = times(look_.background, 1)});
  }

  void lone_point(int index, double radius) {
    const double amount = amounts_.empty() ? 0.5 : amounts_[std::size_t(index)];
    build_.layer("point", build_.shape(Disc{flat(point(index)), radius}),
                 {.color = amounts_.empty() ? look_.surface : heat_color(amount)});
  }

 private:
  const glm::dvec3& point(int index) const { return mesh_.points[std::size_t(index)]; }

  Color color_of(const std::array<int, 3>& t) const {
    if (amounts_.empty()) return look_.surface;
    return heat_color(
        (amounts_[std::size_t(t[0])] + amounts_[std::size_t(t[1])] + amounts_[std::size_t(t[2])]) /
        3);
  }

  const Mesh& mesh_;
  std::span<const double> amounts_;
  const MeshLook& look_;
  SceneBuilder& build_;
};

}  // namespace

Scene scene_from_mesh(const Mesh& mesh, std::span<const double> amounts, const MeshLook& look) {
  const Box2 box = look.box.empty() ? box_of(mesh) : look.box;
  SceneBuilder build({box, true}, look.background);
  MeshPainter painter(mesh, amounts, look, build);
  for (const int i : far_to_near(mesh)) painter.triangle(i);
  if (mesh.triangles.empty())
    for (int i = 0; i < int(mesh.points.size()); ++i)
      painter.lone_point(i, kMarker * std::max(box.size().x, box.size().y));
  return std::move(build).finish();
}

}  // namespace mien
