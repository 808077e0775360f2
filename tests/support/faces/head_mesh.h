#pragma once
// A head of triangles for tests: brow, nose, eye sockets, lips and chin on an egg, in a few shapes.

#include <mien/mesh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

namespace mien::test {

enum class HeadShape { neutral, smile, ah };

/// A point of the head's surface: `down` 0 (crown) … 1 (chin), `around` in turns, 0 in front.
inline glm::dvec3 head_point(double down, double around, HeadShape shape) {
  constexpr double kPi = 3.14159265358979323846;
  const double t = 0.02 + (kPi - 0.04) * down, a = 2 * kPi * around;
  glm::dvec3 p{0.75 * std::sin(t) * std::sin(a), std::cos(t), 0.85 * std::sin(t) * std::cos(a)};
  p.x *= 1 - 0.35 * std::pow(std::max(0.0, -(p.y + 0.2) / 0.8), 1.5);  // towards the chin
  const double front = std::max(0.0, p.z / 0.85);
  const glm::dvec3 egg = p;
  const auto bump = [&](double x, double y, double wide, double high) {
    return front * std::exp(-std::pow((egg.x - x) / wide, 2) - std::pow((egg.y - y) / high, 2));
  };
  p.z += 0.22 * bump(0, -0.12, 0.09, 0.16) - 0.10 * bump(0.27, 0.12, 0.14, 0.1) -
         0.10 * bump(-0.27, 0.12, 0.14, 0.1) + 0.04 * bump(0, 0.3, 0.45, 0.08) +
         0.05 * bump(0, -0.43, 0.2, 0.035) + 0.05 * bump(0, -0.53, 0.16, 0.04) +
         0.05 * bump(0, -0.8, 0.15, 0.1);
  if (shape == HeadShape::smile)
    for (const double side : {-1.0, 1.0}) {
      const double corner = bump(side * 0.24, -0.48, 0.13, 0.10);
      p += corner * glm::dvec3{side * 0.08, 0.10, -0.03};
    }
  if (shape == HeadShape::ah) p.y -= 0.2 * front * std::clamp(-(egg.y + 0.49) / 0.12, 0.0, 1.0);
  return p;
}

/// `rows` rings of 2 · rows squares of two triangles each.
inline Mesh head_mesh(int rows, HeadShape shape) {
  Mesh mesh;
  const int columns = 2 * rows;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < columns; ++i)
      mesh.points.push_back(head_point(double(j) / rows, double(i) / columns - 0.5, shape));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * columns + i, b = j * columns + (i + 1) % columns;
      mesh.triangles.push_back({a, a + columns, b + columns});
      mesh.triangles.push_back({a, b + columns, b});
    }
  return mesh;
}

inline void write_obj(const std::string& path, const Mesh& mesh) {
  std::ofstream file(path);
  file.precision(17);
  for (const glm::dvec3& p : mesh.points) file << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const auto& t : mesh.triangles)
    file << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

}  // namespace mien::test
