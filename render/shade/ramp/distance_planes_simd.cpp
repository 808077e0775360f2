// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/distance_planes_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/cover/part_form.h"
#include "render/shade/nearest/near_area-inl.h"
#include "render/shade/ramp/distance_planes.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#ifndef MIEN_RENDER_SHADE_RAMP_DISTANCE_TILE_
#define MIEN_RENDER_SHADE_RAMP_DISTANCE_TILE_
namespace mien {

/// A square of the picture, and what its blocks of 4 × 4 pixels saw.
struct DistancePlanes::Tile {
  static constexpr int kSide = 16, kBlock = 4, kBlocks = kSide / kBlock * kSide / kBlock;
  const FeetArea* area = nullptr;
  int x = 0, y = 0, side = 0;
  bool crowded = false;
  NearArea near;
  std::vector<NearBranches> branches;  ///< by leaf: of the tile, of each block, of a pixel
  std::array<bool, kBlocks> known{};
  std::array<BranchPair, kBlocks> seen;

  NearBranches* branches_of(int square) {
    return branches.data() + std::size_t(square) * near.leaf_count();
  }
  int block(int px, int py) const {
    return (py - y) / kBlock * (kSide / kBlock) + (px - x) / kBlock;
  }
  /// From the tile's middle.
  glm::vec2 from_middle(double px, double py) const {
    return {float(px - x - 0.5 * side), float(py - y - 0.5 * side)};
  }
};

}  // namespace mien
#endif

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

constexpr float kHalfDiagonal = 0.7072f;

void EnterDistanceTile(NearArea& near, float side, NearBranches* to) {
  FindFeetOf(near);
  EnterSquare(near, nullptr, 0.0f, 0.0f, kHalfDiagonal * side, to);
}

/// Places of a square of so many cells each way, seen from its middle at (cx, cy), sixteen at a time.
void SeeSquare(NearArea& near, const NearBranches* from, NearBranches* own, glm::vec2 middle,
               float width, const PartCells& cells, BranchPair* to) {
  EnterSquare(near, from, middle.x, middle.y, kHalfDiagonal * width, own);
  alignas(64) float x[16], y[16];
  for (std::size_t k = 0; k < std::size_t(cells.count()); k += 16) {
    for (std::size_t i = 0; i < 16; ++i)
      x[i] = middle.x + width * cells.x[k + i], y[i] = middle.y + width * cells.y[k + i];
    LookAround(near, own, middle.x, middle.y, x, y, *to++);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(EnterDistanceTile);
HWY_EXPORT(SeeSquare);
}  // namespace batch

namespace {

/// Where a ridge cuts a cell's square: how much of it lies beyond, and the mean of the way beyond it.
struct RidgeShare {
  double beyond = 0, way = 0;
};

/// By differences of max(t − off, 0)² / 2 and max(t − off, 0)³ / 6 over the corners of the square.
RidgeShare share_beyond(double off, double ex, double ey, double side) {
  const double u = side * std::max(std::abs(ex), std::abs(ey)),
               v = std::max(side * std::min(std::abs(ex), std::abs(ey)), 0x1p-10 * u);
  const double over = 1.0 / (u * v), corners[] = {0.5 * (u + v), 0.5 * (u - v)};
  RidgeShare share;
  for (int k = 0; k < 4; ++k) {
    const double at = k < 2 ? corners[k] : -corners[3 - k];
    const double t = std::max(at - off, 0.0), by = (k == 0 || k == 3 ? over : -over) * t * t;
    share.beyond += by / 2.0, share.way += by * t / 6.0;
  }
  return share;
}

/// The cell k, with what a ridge through it changes; `jump`: by how much the gradient does.
RampPlane plane_of(const BranchPair& at, std::size_t k, double side, double& jump) {
  RampPlane plane{double(at.best.d[k]), double(at.best.nx[k]), double(at.best.ny[k])};
  jump = 0.0;
  if (!(double(at.off[k]) < 0.7072 * side)) return plane;
  const double dx = double(at.beyond.nx[k]) - plane.gx, dy = double(at.beyond.ny[k]) - plane.gy,
               ex = double(at.ex[k]), ey = double(at.ey[k]);
  const RidgeShare share = share_beyond(double(at.off[k]), ex, ey, side);
  jump = dx * ex + dy * ey;
  plane.t += jump * share.way;
  plane.gx += share.beyond * dx, plane.gy += share.beyond * dy;
  return plane;
}

/// The quadratic around a pixel's middle.
struct Bowl {
  double d, nx, ny, bend;

  RampPlane cell(double x, double y, double side) const {
    const double along = bend * (nx * y - ny * x);
    return {d + nx * x + ny * y + 0.5 * along * (nx * y - ny * x) + bend * side * side / 24.0,
            nx - along * ny, ny + along * nx};
  }
};

}  // namespace

DistancePlanes::DistancePlanes() = default;
DistancePlanes::~DistancePlanes() = default;
DistancePlanes::DistancePlanes(DistancePlanes&&) noexcept = default;
DistancePlanes& DistancePlanes::operator=(DistancePlanes&&) noexcept = default;

void DistancePlanes::begin() {
  for (const auto& t : tiles_)
    if (t) t->area = nullptr;
}

long long DistancePlanes::take_feet() {
  long long feet = 0;
  for (const auto& t : tiles_)
    if (t) feet += std::exchange(t->near.feet, 0);
  return feet;
}

DistancePlanes::Tile& DistancePlanes::tile(const FeetArea& area, int x, int y, int side) {
  constexpr std::size_t kTiles = 512;
  tiles_.resize(kTiles);
  const int left = x & ~(side - 1), top = y & ~(side - 1);
  const std::size_t place = std::size_t(left / side) + 37 * std::size_t(Tile::kSide - side) +
                            std::hash<const void*>()(&area) / 64;
  auto& slot = tiles_[place % kTiles];
  if (!slot) slot = std::make_unique<Tile>();
  Tile& t = *slot;
  if (t.area == &area && t.x == left && t.y == top && t.side == side) return t;
  t.area = &area, t.x = left, t.y = top, t.side = side;
  // [of the side] Half a diagonal, and some more.
  t.near.narrow(area, glm::dvec2{left, top} + 0.5 * side, 0.75 * side);
  t.crowded = t.near.crowded();
  if (t.crowded) return t;
  t.known.fill(false);
  t.branches.resize((Tile::kBlocks + 2) * t.near.leaf_count());
  MIEN_DISPATCH(EnterDistanceTile)(t.near, float(side), t.branches.data());
  return t;
}

int DistancePlanes::of(const FeetArea& area, int x, int y, int side, double allowed,
                       std::vector<RampPlane>& to) {
  Tile* t = &tile(area, x, y, Tile::kSide);
  if (t->crowded) t = &tile(area, x, y, Tile::kBlock);
  if (t->crowded) return 0;
  const int b = t->block(x, y);
  BranchPair& at = t->seen[std::size_t(b)];
  constexpr int kBlock = Tile::kBlock;
  if (!std::exchange(t->known[std::size_t(b)], true)) MIEN_DISPATCH(SeeSquare)
  (t->near, t->branches.data(), t->branches_of(1 + b),
   t->from_middle((x & ~(kBlock - 1)) + 0.5 * kBlock, (y & ~(kBlock - 1)) + 0.5 * kBlock),
   float(kBlock), whole_cells(kBlock), &at);
  // [px] Pixels beside a nearer ridge are not on one side of it, or those beside them are not.
  constexpr double kBeside = 1.1;
  const int i = x & (kBlock - 1), j = y & (kBlock - 1), k = j * kBlock + i;
  if (!(double(at.off[k]) > kBeside)) return cells(*t, x, y, side, allowed, to);
  Bowl bowl{double(at.best.d[k]), double(at.best.nx[k]), double(at.best.ny[k]), 0.0};
  const auto turn = [&](int low, int high, double along_x, double along_y) {
    return (along_x * double(at.best.nx[high] - at.best.nx[low]) +
            along_y * double(at.best.ny[high] - at.best.ny[low])) /
           (high - low < kBlock ? high - low : (high - low) / kBlock);
  };
  const int left = k - (i > 0), right = k + (i < kBlock - 1), up = j > 0 ? k - kBlock : k,
            down = j < kBlock - 1 ? k + kBlock : k;
  bowl.bend =
      -bowl.ny * turn(left, right, -bowl.ny, bowl.nx) + bowl.nx * turn(up, down, -bowl.ny, bowl.nx);
  // [1/px] Of level lines that bend more, terms of third degree count.
  constexpr double kBowl = 0.3;
  int finer = side;
  while (0.05 * std::abs(bowl.bend) > allowed * finer * finer) finer *= 2;
  if (std::abs(bowl.bend) > kBowl || finer > 4 * side) return cells(*t, x, y, side, allowed, to);
  const PartCells& whole = whole_cells(finer);
  for (std::size_t n = 0; n < std::size_t(whole.count()); ++n)
    to.push_back(bowl.cell(double(whole.x[n]), double(whole.y[n]), 1.0 / finer));
  return finer;
}

/// In cells so small that what they neglect does not show: of a gradient that turns or jumps within a cell no more than
/// the mean distance is known.
int DistancePlanes::cells(Tile& t, int x, int y, int side, double allowed,
                          std::vector<RampPlane>& to) {
  // [px] Of a cell, by its side: what turns leave of soft ramps, and of sudden ones; what jumps leave.
  constexpr double kTurn = 0.02, kBend = 0.1, kJump = 0.03;
  const std::size_t before = to.size();
  for (side = std::max(side, 4);; side *= 2) {
    const double cell = 1.0 / side;
    seen_.resize(std::size_t(side * side / 16));
    MIEN_DISPATCH(SeeSquare)
    (t.near, t.branches_of(1 + t.block(x, y)), t.branches_of(1 + Tile::kBlocks),
     t.from_middle(x + 0.5, y + 0.5), 1.0f, whole_cells(side), seen_.data());
    to.resize(before);
    double off = 0.0;
    // By how much the gradient turns along the level line from one cell to another; 0 where a ridge is near.
    const auto turn = [&](int k, int n) {
      const BranchPair &a = seen_[std::size_t(k / 16)], &b = seen_[std::size_t(n / 16)];
      if (double(std::min(a.off[k % 16], b.off[n % 16])) < cell) return 0.0;
      const BranchPair::Values &u = a.best, &v = b.best;
      return double(u.nx[k % 16] * (v.ny[n % 16] - u.ny[k % 16]) -
                    u.ny[k % 16] * (v.nx[n % 16] - u.nx[k % 16]));
    };
    for (int k = 0; k < side * side; ++k) {
      double jump = 0.0;
      RampPlane p = plane_of(seen_[std::size_t(k / 16)], std::size_t(k % 16), cell, jump);
      const int by_x = k % side > 0 ? -1 : 1, by_y = k >= side ? -side : side;
      const double bend = p.gx * turn(k, k + by_y) * (by_y > 0 ? 1.0 : -1.0) -
                          p.gy * turn(k, k + by_x) * by_x;  // times the cell's side
      p.t += bend * cell / 24.0;
      to.push_back(p);
      off += std::abs(bend) * (kTurn * std::abs(bend) + kBend * cell) + kJump * jump * jump;
    }
    if (side == PartCells::kMostSide || off * cell * cell * cell <= allowed) return side;
  }
}

}  // namespace mien
#endif
