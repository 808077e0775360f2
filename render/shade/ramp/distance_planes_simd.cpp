// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/distance_planes_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/cover/part_form.h"
#include "render/shade/nearest/near_squares-inl.h"
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
  std::vector<NearNode> branches;  ///< by node: of the tile, of each block, of a pixel
  /// The distances and gradients at its pixels' middles, row by row, and then at their 5 × 5 corners.
  struct Block {
    static constexpr int kCorners = kBlock * kBlock, kPlaces = 48;
    bool known = false;
    BranchPair::Values seen[kPlaces / BranchPair::kPlaces];
    float ridge[BranchPair::kPlaces];  ///< from its pixels' middles: how far the nearest is

    /// The place of a pixel's corner.
    static int corner(int px, int py, int right, int below) {
      return kCorners + ((py & (kBlock - 1)) + below) * (kBlock + 1) + (px & (kBlock - 1)) + right;
    }
    double d(int k) const { return double(seen[k / 16].d[k % 16]); }
    double nx(int k) const { return double(seen[k / 16].nx[k % 16]); }
    double ny(int k) const { return double(seen[k / 16].ny[k % 16]); }
  };
  std::array<Block, kBlocks> blocks;

  NearNode* branches_of(int square) {
    return branches.data() + std::size_t(square) * near.nodes().size();
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

void EnterDistanceTile(NearArea& near, float side, NearNode* to) {
  FindFeetOf(near);
  EnterSquare(near, nullptr, 0.0f, 0.0f, kHalfDiagonal * side, to);
}

/// A block of 4 × 4 pixels around (x, y).
void SeeBlock(NearArea& near, const NearNode* from, NearNode* own, glm::vec2 middle,
              BranchPair::Values* to, float* ridge) {
  constexpr float kWidth = 4.0f;
  EnterSquare(near, from, middle.x, middle.y, kHalfDiagonal * kWidth, own);
  BranchPair pair;
  alignas(64) float x[16], y[16];
  for (int k = 0; k < 48; k += 16) {
    for (int i = 0; i < 16; ++i) {
      const int n = HWY_MIN(k + i - 16, 24);  // the last corner fills up the last sixteen
      x[i] = middle.x + (k == 0 ? float(i % 4) - 1.5f : float(n % 5) - 2.0f);
      y[i] = middle.y + (k == 0 ? float(i / 4) - 1.5f : float(n / 5) - 2.0f);
    }
    LookAround(near, own, middle.x, middle.y, x, y, pair);
    *to++ = pair.best;
    for (int i = 0; k == 0 && i < 16; ++i) ridge[i] = pair.off[i];
  }
}

/// Places of a square of so many cells each way, seen from its middle at (cx, cy), sixteen at a time.
void SeeSquare(NearArea& near, const NearNode* from, NearNode* own, glm::vec2 middle, float width,
               const PartCells& cells, BranchPair* to) {
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
HWY_EXPORT(SeeBlock);
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

/// [px, of a cell a pixel wide] What a level line that bends by 1/px leaves, where the ramp's slope turns by so much.
/// All around a mean that is right: 0.1 of a jump, and 0.03 of what slopes turn by.
double bend_share(double turns) {
  return std::min(0.1, 0.03 * turns);
}

/// [px, of a cell a pixel wide] What a jump of the gradient leaves: a plane between both slopes has another spread about
/// the mean. Where level lines run along the ridge it has none at all, and a kink there is off by jump / 32; else by the
/// difference of variances, jump² / 384, over how steep both are along the ridge. Half as much again is for slanting
/// cells.
double jump_share(double jump, double turns) {
  if (jump == 0.0) return 0.0;
  const double along = std::sqrt(std::max(1.0 - 0.25 * jump * jump, 0.0)), own = std::abs(jump);
  return std::min(0.047, 0.004 * own / std::max(along, 1e-3)) * own * turns;
}

/// What a cell sees from its middle.
struct Cell {
  const BranchPair& pair;
  int k;

  double d() const { return double(pair.best.d[k]); }
  double nx() const { return double(pair.best.nx[k]); }
  double ny() const { return double(pair.best.ny[k]); }

  /// By how much the gradient turns along the level line from there to another; 0 where a ridge is near.
  double turn(const Cell& to, double side) const {
    if (double(std::min(pair.off[k], to.pair.off[to.k])) < side) return 0.0;
    return nx() * (to.ny() - ny()) - ny() * (to.nx() - nx());
  }

  /// The distance at another place: beyond the ridge by the branch that takes over there.
  double foretold(double dx, double dy, double bend) const {
    if (double(pair.ex[k]) * dx + double(pair.ey[k]) * dy > double(pair.off[k]))
      return double(pair.beyond.d[k]) + double(pair.beyond.nx[k]) * dx +
             double(pair.beyond.ny[k]) * dy;
    const double along = nx() * dy - ny() * dx;
    return d() + nx() * dx + ny() * dy + 0.5 * bend * along * along;
  }
};

/// The quadratic around a pixel's middle.
struct Bowl {
  double d, nx, ny, xx = 0, xy = 0, yy = 0;

  double at(double x, double y) const {
    return d + x * (nx + 0.5 * xx * x) + y * (ny + 0.5 * yy * y) + xy * x * y;
  }
  RampPlane cell(double x, double y, double side) const {
    return {at(x, y) + (xx + yy) * side * side / 24.0, nx + xx * x + xy * y, ny + xy * x + yy * y};
  }
  /// By how much level lines bend.
  double bend() const { return ny * (xx * ny - xy * nx) + nx * (yy * nx - xy * ny); }
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
  for (Tile::Block& block : t.blocks) block.known = false;
  t.branches.resize((Tile::kBlocks + 2) * t.near.nodes().size());
  MIEN_DISPATCH(EnterDistanceTile)(t.near, float(side), t.branches.data());
  return t;
}

int DistancePlanes::of(const FeetArea& area, int x, int y, int side, bool part,
                       const RampSoftness& ramp, std::vector<RampPlane>& to) {
  Tile* t = &tile(area, x, y, Tile::kSide);
  if (t->crowded) t = &tile(area, x, y, Tile::kBlock);
  if (t->crowded) return 0;
  const int b = t->block(x, y);
  Tile::Block& block = t->blocks[std::size_t(b)];
  constexpr int kBlock = Tile::kBlock;
  if (!std::exchange(block.known, true)) MIEN_DISPATCH(SeeBlock)
  (t->near, t->branches.data(), t->branches_of(1 + b),
   t->from_middle((x & ~(kBlock - 1)) + 0.5 * kBlock, (y & ~(kBlock - 1)) + 0.5 * kBlock),
   block.seen, block.ridge);
  const int i = x & (kBlock - 1), j = y & (kBlock - 1), k = j * kBlock + i;
  Bowl bowl{block.d(k), block.nx(k), block.ny(k)};
  const auto corner = [&](int n) { return Tile::Block::corner(x, y, n % 2, n / 2); };
  for (int n = 0; n < 4; ++n) {
    const int c = corner(n);
    const double right = n % 2 ? 0.5 : -0.5, below = n / 2 ? 0.5 : -0.5;
    bowl.xx += right * block.nx(c), bowl.yy += below * block.ny(c);
    bowl.xy += 0.5 * (right * block.ny(c) + below * block.nx(c));
  }
  // A ridge anywhere in the pixel has a place beyond it, as corners are places; but between two it may lie alone.
  constexpr double kRidge = 0.3;  // of what is allowed
  double off = 0.0;
  for (int n = 0; n < 4; ++n)
    off = std::max(off, std::abs(bowl.at(n % 2 - 0.5, n / 2 - 0.5) - block.d(corner(n))));
  int finer = side;
  const double bends = bend_share(ramp.turns(bowl.d, 0.75)) * std::abs(bowl.bend());
  while (bends > ramp.allowed() * finer * finer) finer *= 2;
  if (!(off <= kRidge * ramp.allowed()) || block.ridge[k] < 0.75f || finer > std::max(4, side))
    return cells(*t, x, y, side, part, ramp, to);
  const PartCells& whole = whole_cells(finer);
  for (std::size_t n = 0; n < std::size_t(whole.count()); ++n)
    to.push_back(bowl.cell(double(whole.x[n]), double(whole.y[n]), 1.0 / finer));
  return finer;
}

/// In cells so small that what they neglect does not show: each foretells its neighbours' distances, and what that is
/// off by is neglected; of a gradient that turns or jumps within a cell no more than the mean distance is known.
int DistancePlanes::cells(Tile& t, int x, int y, int side, bool part, const RampSoftness& ramp,
                          std::vector<RampPlane>& to) {
  constexpr double kForetold =
      0.3;  // of what its neighbours are not as foretold, a cell's mean is off
  constexpr double kCut =
      0.03;  // [of the cell's side, times a jump] the most that a part takes from one half
  const std::size_t before = to.size();
  const Tile::Block& block = t.blocks[std::size_t(t.block(x, y))];
  for (side = std::max(side, 4);; side *= 2) {
    const double cell = 1.0 / side;
    seen_.resize(std::size_t(side * side / 16));
    MIEN_DISPATCH(SeeSquare)
    (t.near, t.branches_of(1 + t.block(x, y)), t.branches_of(1 + Tile::kBlocks),
     t.from_middle(x + 0.5, y + 0.5), 1.0f, whole_cells(side), seen_.data());
    to.resize(before);
    double off = 0.0;
    for (int k = 0; k < side * side; ++k) {
      const Cell at{seen_[std::size_t(k / 16)], k % 16};
      double jump = 0.0;
      RampPlane p = plane_of(at.pair, std::size_t(at.k), cell, jump);
      const auto cell_at = [&](int n) { return Cell{seen_[std::size_t(n / 16)], n % 16}; };
      const int column = k % side, row = k / side;
      const int by_x = column > 0 ? -1 : 1, by_y = row > 0 ? -1 : 1;
      const double bend = (at.nx() * at.turn(cell_at(k + by_y * side), cell) * by_y -
                           at.ny() * at.turn(cell_at(k + by_x), cell) * by_x) /
                          cell;
      p.t += bend * cell * cell / 24.0;
      to.push_back(p);
      double wrong = 0.0;
      const auto foretell = [&](int n, double dx, double dy) {
        wrong = std::max(wrong, std::abs(at.foretold(dx, dy, bend) - cell_at(n).d()));
      };
      if (column > 0) foretell(k - 1, -cell, 0.0);
      if (column + 1 < side) foretell(k + 1, cell, 0.0);
      if (row > 0) foretell(k - side, 0.0, -cell);
      if (row + 1 < side) foretell(k + side, 0.0, cell);
      // Ridges may cut off a corner of the pixel beyond all middles.
      const int right = column > 0, below = row > 0;
      if (column == right * (side - 1) && row == below * (side - 1)) {
        const double d = block.d(Tile::Block::corner(x, y, right, below));
        wrong = std::max(
            wrong, std::abs(at.foretold((right - 0.5) * cell, (below - 0.5) * cell, bend) - d));
      }
      off += kForetold * wrong;
      if (bend == 0.0 && jump == 0.0) continue;
      const double turns = ramp.turns(p.t, 0.75 * cell);
      off += bend_share(turns) * std::abs(bend) * cell * cell +
             (jump_share(jump, turns) + (part ? kCut * std::abs(jump) : 0.0)) * cell;
    }
    if (side == PartCells::kMostSide || off * cell * cell <= ramp.allowed()) return side;
  }
}

}  // namespace mien
#endif
