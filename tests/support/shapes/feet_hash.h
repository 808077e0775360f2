#pragma once
// A hash over every byte of feet, for machines and instruction sets to agree on. Its curves and places are made by
// arithmetic alone.

#include <mien/feet.h>

#include <array>
#include <cstring>
#include <vector>

#include "tests/support/random/random.h"

namespace mien::test {

/// Room for the answers of a batch.
struct FootRoom {
  std::vector<std::int32_t> piece;
  std::array<std::vector<double>, 5> rows;

  explicit FootRoom(std::size_t count) : piece(count) {
    for (auto& row : rows) row.resize(count);
  }
  FootSpans spans() { return {piece, rows[0], rows[1], rows[2], rows[3], rows[4]}; }
  Foot foot(std::size_t i) const {
    return {piece[i], rows[0][i], rows[1][i], {rows[2][i], rows[3][i]}, rows[4][i]};
  }
};

template <class Figure>
std::uint64_t hash_feet(std::uint64_t hash, const Figure& figure, const std::vector<double>& x,
                        const std::vector<double>& y) {
  FootRoom nearest(x.size()), next(x.size());
  nearest_feet(figure, x, y, nearest.spans(), next.spans());
  const auto add = [&](const void* from, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(from)[i]) * 0x100000001B3u;
  };
  for (const FootRoom* room : {&nearest, &next}) {
    add(room->piece.data(), room->piece.size() * sizeof(std::int32_t));
    for (const auto& row : room->rows) add(row.data(), row.size() * sizeof(double));
  }
  return hash;
}

/// Of `count` chains of curves, strokes, lines and ellipses, each seen from 61 places.
inline std::uint64_t feet_hash(int count) {
  Random random(6);
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (int k = 0; k < count; ++k) {
    std::vector<double> x, y;
    for (int i = 0; i < 61; ++i)
      x.push_back(random.between(-0.5, 1.5)), y.push_back(random.between(-0.5, 1.5));
    const auto point = [&] { return random.point(0, 1); };
    std::vector<QuadBezier> curves;
    std::vector<TaperedStroke> strokes;
    std::vector<Line> lines;
    glm::dvec2 at = point();
    double w = 0.1 * random.unit();
    for (int i = 0; i < 1 + k % 4; ++i) {
      const glm::dvec2 p1 = point(), p2 = point();
      const double middle = 0.3 * random.unit(), end = 0.3 * random.unit();
      curves.push_back({at, p1, p2}), lines.push_back({at, p2, w});
      strokes.push_back({{at, p1, p2}, {w, middle, end}});
      at = p2, w = end;
    }
    x[7] = curves[0].p0.x, y[7] = curves[0].p0.y;  // at an end, and on a curve
    x[8] = mien::point(curves[0], 0.25).x, y[8] = mien::point(curves[0], 0.25).y;
    hash = hash_feet(hash, std::span<const QuadBezier>(curves), x, y);
    hash = hash_feet(hash, std::span<const TaperedStroke>(strokes), x, y);
    hash = hash_feet(hash, std::span<const Line>(lines), x, y);
    const glm::dvec2 radii{0.05 + random.unit(), 0.05 + random.unit()};
    hash = hash_feet(hash, Ellipse{point(), radii, {0.6, 0.8}}, x, y);
  }
  return hash;
}

/// What it is everywhere.
inline constexpr int kHashedFeet = 500;
inline constexpr std::uint64_t kFeetHash = 0xcc5a21cee51c4cf0u;

}  // namespace mien::test
