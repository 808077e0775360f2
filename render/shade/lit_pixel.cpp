#include <mien/render/shade/lit_pixel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

/// Adds the cells of a square whose middle is `from` the pixel's; those in which two cuts meet as
/// cells of their own.
void LitPixel::see(const Place& place, glm::vec2 at, glm::vec2 from, float side, bool last) {
  constexpr int kRow = LitCells::kRow, kPadded = 48;
  LitCells c;
  c.x = at.x + from.x, c.y = at.y + from.y, c.side = side / float(LitCells::kSide);
  c.shallow = place.shallow, c.deep = place.deep;
  std::array<float, kPadded> x{}, y{}, d, nx, ny, bend;
  for (int i = 0; i < LitCells::kPlaces; ++i) {
    x[std::size_t(i)] = c.x + c.side * (float(i % kRow) - 2.5f);
    y[std::size_t(i)] = c.y + c.side * (float(i / kRow) - 2.5f);
  }
  if (place.feet) {
    place.feet->at(x, y, {d.data(), nx.data(), ny.data(), bend.data()});
    std::copy_n(d.data(), LitCells::kPlaces, c.d.data());
    std::copy_n(nx.data(), LitCells::kPlaces, c.nx.data());
    std::copy_n(ny.data(), LitCells::kPlaces, c.ny.data());
    std::copy_n(bend.data(), LitCells::kPlaces, c.bend.data());
  } else {
    c.d.fill(-0.5f * (c.shallow + c.deep)), c.nx.fill(1.0f), c.ny.fill(0.0f), c.bend.fill(0.0f);
  }
  color_cells(*place.lamp, c);
  const float whole = c.side * c.side;
  for (std::size_t i = 0; i < std::size_t(LitCells::kCells); ++i) {
    if (!last && c.divide[i] != 0.0f) {
      const glm::vec2 middle{float(i % LitCells::kSide) - 1.5f, float(i / LitCells::kSide) - 1.5f};
      see(place, at, from + c.side * middle, c.side, true);
    } else if (c.area[i] > 0.0f) {
      seen_.push_back({from.x + c.cx[i],
                       from.y + c.cy[i],
                       c.side,
                       whole * c.area[i],
                       {c.r[i], c.g[i], c.b[i]}});
    }
  }
}

void LitPixel::see_all(const Place& place, glm::vec2 at) {
  seen_.clear();
  see(place, at, {0.0f, 0.0f}, 1.0f, false);
}

glm::vec3 LitPixel::whole(const Place& place, glm::vec2 at) {
  see_all(place, at);
  glm::vec3 sum{0.0f};
  float area = 0.0f;
  for (const Cell& cell : seen_) sum += cell.area * cell.color, area += cell.area;
  return area > 0.0f ? sum / area : sum;
}

/// Takes away what lies beyond a straight line, so that `area` is left and its centroid moves
/// towards `centroid`.
void LitPixel::cut(float area, glm::vec2 centroid) {
  float all = 0.0f;
  glm::vec2 mean{0.0f};
  for (const Cell& cell : seen_) all += cell.area, mean += cell.area * glm::vec2{cell.x, cell.y};
  if (!(all > area + 0.002f)) return;
  const glm::vec2 way = mean / all - centroid;
  const float length = glm::length(way);
  if (length < 1e-4f) return;
  const glm::vec2 n = way / length;
  const auto left = [&](const Cell& cell, float at) {
    const float out = at - (cell.x - centroid.x) * n.x - (cell.y - centroid.y) * n.y;
    return std::clamp(out / cell.side + 0.5f, 0.0f, 1.0f);
  };
  float lo = -1.5f, hi = 1.5f;
  for (int i = 0; i < 16; ++i) {
    const float at = 0.5f * (lo + hi);
    float sum = 0.0f;
    for (const Cell& cell : seen_) sum += cell.area * left(cell, at);
    (sum < area ? lo : hi) = at;
  }
  for (Cell& cell : seen_) {
    const float share = left(cell, hi);
    // What is left of a cell has its middle nearer.
    cell.x -= 0.5f * (1.0f - share) * cell.side * n.x;
    cell.y -= 0.5f * (1.0f - share) * cell.side * n.y;
    cell.area *= share;
  }
}

glm::vec3 LitPixel::part(const Place& place, glm::vec2 at, float area, glm::vec2 centroid) {
  see_all(place, at);
  cut(area, centroid);
  float all = 0.0f;
  glm::vec2 mean{0.0f};
  glm::vec3 sum{0.0f};
  for (const Cell& cell : seen_) {
    all += cell.area, mean += cell.area * glm::vec2{cell.x, cell.y};
    sum += cell.area * cell.color;
  }
  if (!(all > 1e-6f)) {
    see_all({place.lamp, place.feet, -1e9f, 1e9f}, at);
    return seen_.empty() ? glm::vec3{0.0f} : seen_[seen_.size() / 2].color;
  }
  mean /= all, sum /= all;
  // Put right for the centroid by the slope of the plane nearest to the colours.
  glm::vec3 by_x{0.0f}, by_y{0.0f};
  float xx = 1e-5f, xy = 0.0f, yy = 1e-5f;
  for (const Cell& cell : seen_) {
    const float u = cell.x - mean.x, v = cell.y - mean.y;
    by_x += cell.area * u * (cell.color - sum), by_y += cell.area * v * (cell.color - sum);
    xx += cell.area * u * u, xy += cell.area * u * v, yy += cell.area * v * v;
  }
  const float whole = xx * yy - xy * xy;
  const glm::vec2 off = centroid - mean;
  const glm::vec3 leans =
      ((yy * off.x - xy * off.y) / whole) * by_x + ((xx * off.y - xy * off.x) / whole) * by_y;
  return sum + leans;
}

}  // namespace mien
