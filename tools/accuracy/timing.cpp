#include "tools/accuracy/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace mien::accuracy {
namespace {

constexpr int kTile = 16;
constexpr std::size_t kCases = 40;

Points tile_around(const Case& k) {
  const QuadBezier& c = std::get<QuadBezier>(k.figure);
  const double step = std::max(std::abs(c.p2.x - c.p0.x), std::abs(c.p2.y - c.p0.y)) / 1024;
  Points tile;
  for (int j = 0; j < kTile; ++j)
    for (int i = 0; i < kTile; ++i)
      tile.xd.push_back(k.p.x + step * i), tile.yd.push_back(k.p.y + step * j);
  tile.xf.assign(tile.xd.begin(), tile.xd.end());
  tile.yf.assign(tile.yd.begin(), tile.yd.end());
  tile.df.resize(tile.xf.size()), tile.dd.resize(tile.xd.size());
  return tile;
}

}  // namespace

double ns_per_point(const Solver& solver, const std::vector<Case>& cases) {
  if (!solver.many || cases.empty()) return 0;
  using Clock = std::chrono::steady_clock;
  solver.prepare();
  const std::size_t count = std::min(cases.size(), kCases);
  std::vector<Points> tiles;
  for (std::size_t i = 0; i < count; ++i) tiles.push_back(tile_around(cases[i]));
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 5; ++run) {
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < count; ++i)
      solver.many(std::get<QuadBezier>(cases[i].figure), tiles[i]);
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
  return best / double(count * kTile * kTile);
}

}  // namespace mien::accuracy
