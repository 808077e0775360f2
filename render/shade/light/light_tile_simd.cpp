// Means of a tile's pixels and parts. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/light/light_tile_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/light/gauss_square-inl.h"
#include "render/shade/light/light_cells-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using State = LightTile::State;

void BeginGround(const LightTile& tile) {
  if (tile.rises) FindFeetOf(tile.ground->area);
  if (tile.apart) FindFeetOf(tile.ground->gradient);
}

struct Square {
  int level, i, j;
  int index() const { return LightTile::square(level, i, j); }
  Square outer() const { return {level - 1, i / 2, j / 2}; }
};

/// The branches near a square, of both areas.
Near NearOf(const LightTile& tile, int square) {
  LightGround& g = *tile.ground;
  return {g.near.data() + size_t(square) * g.area.nodes().size(),
          g.near_gradient.data() + size_t(square) * g.gradient.nodes().size()};
}

/// Whether a ridge or the end of a branch may lie in a square that was entered.
bool BreaksIn(const LightTile& tile, int square) {
  const auto alone = [](const NearArea& area, const NearNode* near) {
    const size_t k = area.deciding(near);
    return area.nodes()[k].op == Op::shape && near[k].branches.endless;
  };
  const Near near = NearOf(tile, square);
  const LightGround& g = *tile.ground;
  return (tile.rises && !alone(g.area, near.relief)) ||
         (tile.apart && !alone(g.gradient, near.other));
}

/// The most that a square's colours have of a degree, by its table.
float MostOf(const LightTile& tile, const float (&degree)[4], const LightTile::Bicubic& square) {
  float least[LightTile::kChannels] = {}, most = 0.0f;
  for (int c = 0; c < 3; ++c) least[c] = LeastOf16(square.c[c]);
  const Encoding encoding = EncodingAt(tile, least);
  for (int c = 0; c < tile.channels; ++c)
    most = HWY_MAX(most, MostOf(degree, square.c[c]) * encoding.by[c]);
  return most;
}

/// Whether colours jump at a ridge within reach. Light changes by no more than the surface's normal does, and where the
/// rise is 0, as on the spine of a stroke whose profile ends there, it goes on smoothly.
bool RidgeShows(const LightTile& tile, const BranchPair& at, float reach) {
  // [of the tolerance] A step in a square's middle leaves a third of itself to a mean.
  constexpr float kStep = 1.2f;
  const LampLanes& lamp = tile.lamp;
  const float most = kStep * 255.0f * tile.tolerance / lamp.by_slope;
  for (int k = 0; k < 16; ++k) {
    if (at.off[k] >= reach) continue;
    const float along = at.ex[k] * at.best.nx[k] + at.ey[k] * at.best.ny[k];
    const float depth = -(at.best.d[k] + at.off[k] * along);
    float rise = std::abs(lamp.rise);
    if (lamp.is_round()) {
      const float in = HWY_MIN(HWY_MAX(depth * lamp.one_over_width, 1e-9f), 1.5f);
      rise *= std::abs(1.0f - in) / std::sqrt(in * (2.0f - in));
    }
    const float dx = at.best.nx[k] - at.beyond.nx[k], dy = at.best.ny[k] - at.beyond.ny[k];
    if (rise * (std::abs(dx) + std::abs(dy)) > most) return true;
  }
  return false;
}

/// The most that the bicubic is off by along the square's border: beyond its places a side may end, or a curve meet
/// another, where the gradient goes on smoothly but its bend does not.
float OffAtBorder(const LightTile& tile, const Near& near, float cx, float cy, float half,
                  const LightTile::Bicubic& square) {
  const F f;
  const GaussTables& g = GaussTables::get();
  alignas(64) float x[16], y[16];
  for (int k = 0; k < 16; ++k) x[k] = cx + half * g.border_x[k], y[k] = cy + half * g.border_y[k];
  Seen at;
  Shades shades;
  SeeFrom(tile, near, cx, cy, x, y, at);
  ShadePlaces(tile, at, x, y, shades);
  float least[LightTile::kChannels] = {}, most = 0.0f;
  for (int c = 0; c < 3; ++c) least[c] = LeastOf16(square.c[c]);
  const Encoding encoding = EncodingAt(tile, least);
  for (int c = 0; c < tile.channels; ++c) {
    alignas(64) float off[16];
    for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
      VF told = hn::Zero(f);
      for (int node = 0; node < 16; ++node)
        told = Fused(Const(square.c[c][node]), hn::Load(f, g.border[node] + k), told);
      hn::Store(hn::Abs(hn::Sub(told, hn::Load(f, shades.c[c] + k))), f, off + k);
    }
    most = HWY_MAX(most, MostOf16(off) * encoding.by[c]);
  }
  return most;
}

/// Whether the bicubic through a square's places serves; then it is kept.
bool Serves(LightTile& tile, const Square& square, float cx, float cy) {
  // [of half the side] Places lie no farther from any other: nearer ridges may run between them.
  constexpr float kBetween = 0.55f;
  // [of the side] Depths under a round profile are no polynomials nearer to its outline; nor is a dome at its foot.
  constexpr float kSteep = 0.1f, kFoot = 0.14f;
  // [of the tolerance] What a square's pixels and parts allow of the third degree. The mean of all of it is exact up to
  // the seventh; the eighth is a 3^5-th of the third.
  constexpr float kThird = 1.2f, kWhole = 40.0f;
  const float side = float(tile.side >> square.level), half = 0.5f * side;
  // [of the tolerance] What the bicubic may be off by at the border, most of which is its fourth degree there.
  constexpr float kBorder = 3.0f;
  // [of the tolerance] A clamp that begins in a square's middle leaves to a pixel's mean 0.032 of its change where the
  // pixel is a quarter of the square, 0.12 at most where less.
  const float kKink = side < 6.0f ? 12.0f : 4.0f;
  if (tile.lamp.finest < side) return false;
  const GaussTables& g = GaussTables::get();
  alignas(64) float x[16], y[16];
  for (int k = 0; k < 16; ++k) x[k] = cx + half * g.x[k], y[k] = cy + half * g.y[k];
  Seen at;
  const int me = square.index();
  SeeFrom(tile, NearOf(tile, me), cx, cy, x, y, at);
  LightGround::State& ground = tile.ground->state[size_t(me)];
  ground = LightGround::State::broken;
  if (tile.rises && LeastOf16(at.relief.off) < kBetween * half &&
      RidgeShows(tile, at.relief, kBetween * half))
    return false;
  if (tile.rises && tile.lamp.is_round() && MostOf16(at.relief.best.d) > -kSteep * side)
    return false;
  if (tile.lamp.goes_by_distance() && LeastOf16(at.ramp->off) < kBetween * half) return false;
  ground = LightGround::State::entered;
  Shades shades;
  ShadePlaces(tile, at, x, y, shades);
  LightTile::Bicubic made;
  for (int c = 0; c < tile.channels; ++c) std::copy_n(shades.c[c], 16, made.c[c]);
  if (KinkAmong(tile, shades, kAll, 0.2f) > kKink * tile.tolerance) return false;
  if (LeastOf16(shades.foot) < kFoot * side) return false;
  const float third = MostOf(tile, g.third, made);
  const float most = side == 1.0f ? kWhole : kThird;
  if (third > most * tile.tolerance) return false;
  if ((tile.fine || BreaksIn(tile, me)) &&
      OffAtBorder(tile, NearOf(tile, me), cx, cy, half, made) > kBorder * tile.tolerance)
    return false;
  if (side == 1.0f) KnowPixel(tile, square.i, square.j, made);
  if (third > kThird * tile.tolerance) return false;
  tile.where[size_t(me)] = std::uint16_t(tile.kept.size());
  tile.kept.push_back(made);
  return true;
}

/// What is seen at the corners of two by two pixels, three by three.
void SeeCorners(LightTile& tile, int square, float cx, float cy, Shades& to) {
  alignas(64) float x[16], y[16];
  for (int k = 0; k < 16; ++k) {
    const int corner = HWY_MIN(k, 8);
    x[k] = cx + float(corner % 3 - 1), y[k] = cy + float(corner / 3 - 1);
  }
  Seen at;
  SeeFrom(tile, NearOf(tile, square), cx, cy, x, y, at);
  ShadePlaces(tile, at, x, y, to);
}

/// The most that pixel p's corners are off from what its four places foretell: beyond these a ridge may cut off a
/// corner, or a curve end.
float OffAtCorners(const Shades& places, const Shades& corners, int p, const Encoding& encoding,
                   int channels) {
  constexpr float kOut = 1.732050808f;  // [of the way to a place]
  float most = 0.0f;
  for (int c = 0; c < channels; ++c) {
    const float* v = places.c[c] + 4 * p;
    const float mean = 0.25f * ((v[0] + v[3]) + (v[1] + v[2])),
                dx = 0.25f * kOut * ((v[1] - v[0]) + (v[3] - v[2])),
                dy = 0.25f * kOut * ((v[2] - v[0]) + (v[3] - v[1])),
                dxy = 0.25f * kOut * kOut * ((v[3] - v[2]) - (v[1] - v[0]));
    for (int k = 0; k < 4; ++k) {
      const float u = k & 1 ? 1.0f : -1.0f, w = k & 2 ? 1.0f : -1.0f;
      const int corner = ((p >> 1) + (k >> 1)) * 3 + (p & 1) + (k & 1);
      const float told = mean + u * dx + w * dy + u * w * dxy;
      most = HWY_MAX(most, std::abs(corners.c[c][corner] - told) * encoding.by[c]);
    }
  }
  return most;
}

/// Four places of each of two by two pixels: by pixel, places 4 p to 4 p + 3.
struct PixelPlaces {
  alignas(64) float x[16], y[16];
  Seen at;
};

/// Whether a pixel's places are on one smooth branch, that of a round profile deep enough.
bool IsSmooth(const LightTile& tile, const Seen& at, int pixel) {
  // [px] Places lie no farther from any other of their pixel; profiles are no quartics nearer to their outline.
  constexpr float kBetween = 0.45f, kDeep = 1.0f;
  // [1/px] Of a gradient that turns by that, light's own turns count less than the range says.
  constexpr float kTurn = 0.35f;
  const bool ramp = tile.lamp.goes_by_distance(), round = tile.lamp.is_round();
  const int first = 4 * pixel;
  for (int k = first; k < first + 4; ++k) {
    if (ramp && !(at.ramp->off[k] > kBetween)) return false;
    if (!tile.rises) continue;
    const float turn = std::abs(at.relief.best.nx[k] - at.relief.best.nx[first]) +
                       std::abs(at.relief.best.ny[k] - at.relief.best.ny[first]);
    if (!(at.relief.off[k] > kBetween && turn < kTurn)) return false;
    if (round && !(at.relief.best.d[k] < -kDeep)) return false;
  }
  return true;
}

/// The mean of a pixel's four places, where it is exact enough: nothing in it is clamped, ends, or varies by much.
bool TakeMean(const LightTile& tile, const Shades& shades, int pixel, float* mean,
              Encoding& encoding) {
  // [of the tolerance] A clamp that begins in a pixel leaves a twelfth of its change; what varies so little bends less.
  constexpr float kKink = 10.0f, kRange = 64.0f;
  alignas(64) float counts[16] = {};
  float high[LightTile::kChannels], low[LightTile::kChannels] = {};
  std::fill_n(counts + 4 * pixel, 4, 1.0f);
  for (int c = 0; c < tile.channels; ++c) {
    const float* v = shades.c[c] + 4 * pixel;
    mean[c] = 0.25f * ((v[0] + v[3]) + (v[1] + v[2]));
    high[c] = HWY_MAX(HWY_MAX(v[0], v[1]), HWY_MAX(v[2], v[3]));
    low[c] = HWY_MIN(HWY_MIN(v[0], v[1]), HWY_MIN(v[2], v[3]));
  }
  encoding = EncodingAt(tile, low);
  float foot = 1e9f, wide = 0.0f;
  for (int c = 0; c < tile.channels; ++c) wide = HWY_MAX(wide, (high[c] - low[c]) * encoding.by[c]);
  for (int q = 0; q < 4; ++q) foot = HWY_MIN(foot, shades.foot[4 * pixel + q]);
  if (wide > kRange * tile.tolerance || foot < 0.5f) return false;
  return !(KinkAmong(tile, shades, counts, 0.5f) > kKink * tile.tolerance);
}

/// Two by two pixels by Gauss's 2 × 2 places of each: exact for their cubics. Pixels that nothing breaks become known.
void LookAtPixels(LightTile& tile, const Square& square, float cx, float cy) {
  // [of the tolerance] A corner that is cut off between the places leaves a tenth of what it is off by.
  constexpr float kCorner = 17.0f;
  constexpr float kPlace = 0.288675135f;
  if (tile.lamp.finest < 3.0f) return;
  PixelPlaces places;
  for (int k = 0; k < 16; ++k) {
    places.x[k] = cx + (k & 4 ? 0.5f : -0.5f) + (k & 1 ? kPlace : -kPlace);
    places.y[k] = cy + (k & 8 ? 0.5f : -0.5f) + (k & 2 ? kPlace : -kPlace);
  }
  const int me = square.index();
  SeeFrom(tile, NearOf(tile, me), cx, cy, places.x, places.y, places.at);
  bool fits[4];
  for (int p = 0; p < 4; ++p) fits[p] = IsSmooth(tile, places.at, p);
  if (!(fits[0] || fits[1] || fits[2] || fits[3])) return;
  Shades shades, corners;
  ShadePlaces(tile, places.at, places.x, places.y, shades);
  const bool breaks = BreaksIn(tile, me);
  bool looked = false;
  for (int p = 0; p < 4; ++p) {
    float mean[LightTile::kChannels];
    Encoding encoding;
    if (!fits[p] || !TakeMean(tile, shades, p, mean, encoding)) continue;
    if (breaks && !looked) SeeCorners(tile, me, cx, cy, corners), looked = true;
    if (breaks &&
        OffAtCorners(shades, corners, p, encoding, tile.channels) > kCorner * tile.tolerance)
      continue;
    const int side = 2, i = square.i * side + (p & 1), j = square.j * side + (p >> 1);
    const size_t to = size_t(j * LightTile::kSide + i);
    for (int c = 0; c < tile.channels; ++c) tile.mean[size_t(c)][to] = mean[c];
    tile.known[to] = 1;
  }
}

/// Looks at a square, if it was not yet; `whole`: and at its pixels, if there are no smaller squares.
State Look(LightTile& tile, const Square& square, bool whole) {
  const int me = square.index();
  State& state = tile.state[size_t(me)];
  const bool outermost = square.level == 0;
  const float side = float(tile.side >> square.level), middle = tile.middle();
  const bool pixels = whole && side == 2.0f && !tile.fine;
  if (state != State::unknown && !(pixels && state == State::divided)) return state;
  state = pixels ? State::pixels : State::divided;
  const float cx = (float(square.i) + 0.5f) * side - middle,
              cy = (float(square.j) + 0.5f) * side - middle;
  LightGround::State& ground = tile.ground->state[size_t(me)];
  const bool serves = (side > 2.0f || tile.fine) && ground != LightGround::State::broken;
  constexpr float kDiagonal = 0.7072f;
  if (pixels || serves || ground == LightGround::State::unknown)
    Enter(tile, outermost ? Near{} : NearOf(tile, square.outer().index()), cx, cy, kDiagonal * side,
          NearOf(tile, me));
  if (ground == LightGround::State::unknown) ground = LightGround::State::entered;
  if (serves && Serves(tile, square, cx, cy)) {
    if (side > 1.0f)
      SpreadMeans(tile, square.i * int(side), square.j * int(side), int(side), tile.kept.back());
    return state = State::smooth;
  }
  if (pixels) LookAtPixels(tile, square, cx, cy);
  return state;
}

/// The smallest square around pixel (i, j), looked at; smooth, or there is no smaller one.
Square SquareAround(LightTile& tile, int i, int j, bool whole, bool& smooth) {
  Square square{0, 0, 0};
  for (int level = 0; level == 0 || tile.side >> level >= tile.smallest(); ++level) {
    const int side = tile.side >> level;
    square = {level, i / side, j / side};
    if ((smooth = Look(tile, square, whole) == State::smooth)) return square;
  }
  return square;
}

/// A part of a pixel, or all of it, by cells.
void ByCells(LightTile& tile, const Square& around, int i, int j, const PartForm* form,
             float form_area, float* to) {
  const float cx = float(i) + 0.5f - tile.middle(), cy = float(j) + 0.5f - tile.middle();
  const Near near = NearOf(tile, tile.squares());
  Enter(tile, NearOf(tile, around.index()), cx, cy, 0.7072f, near);
  CellRounds({tile, near, cx, cy}, form, form_area).mean(to);
}

void FindMean(LightTile& tile, int i, int j) {
  const size_t p = size_t(j * LightTile::kSide + i);
  bool smooth = false;
  const Square around = SquareAround(tile, i, j, true, smooth);
  if (tile.known[p]) return;
  float c[LightTile::kChannels] = {};
  ByCells(tile, around, i, j, nullptr, 1.0f, c);
  for (int k = 0; k < tile.channels; ++k) tile.mean[size_t(k)][p] = c[k];
  tile.known[p] = !(tile.off > 0.0f);
}

/// A smooth square's colour over a part: at its centroid where it bends little, else by cells.
void BySquare(LightTile& tile, const Square& square, int i, int j, const LitPart& part, float* to) {
  LightTile::Bicubic& kept = tile.kept[tile.where[size_t(square.index())]];
  const float side = float(tile.side >> square.level), over = 2.0f / side;
  const float u0 = float(i) + 0.5f - (float(square.i) + 0.5f) * side,
              v0 = float(j) + 0.5f - (float(square.j) + 0.5f) * side;
  if (kept.bend < 0.0f) kept.bend = MostOf(tile, GaussTables::get().second, kept);
  // A coefficient c bends by 12 c / side² per px²; centroids leave a part's variance, 1/12 at most, times half of that.
  if (kept.bend < 0.5f * side * side * tile.tolerance)
    return BicubicAt(kept, tile.channels, (u0 + part.x) * over, (v0 + part.y) * over, to);
  PartCells& cells = tile.scratch->of_form;
  cells_of_form(*part.form, 4, cells, !tile.fine);
  float area = 0.0f;
  std::fill_n(to, LightTile::kChannels, 0.0f);
  for (size_t k = 0; k < 16; ++k) {
    const float a = cells.area[k];
    if (!(a > 0.0f)) continue;
    float c[LightTile::kChannels];
    BicubicAt(kept, tile.channels, (u0 + cells.x[k]) * over, (v0 + cells.y[k]) * over, c);
    for (int q = 0; q < tile.channels; ++q) to[q] += a * c[q];
    area += a;
  }
  for (int q = 0; q < tile.channels; ++q) to[q] *= area > 0.0f ? 1.0f / area : 0.0f;
}

void MeanOfPart(LightTile& tile, int i, int j, const LitPart& part, float* to) {
  bool smooth = false;
  const Square around = SquareAround(tile, i, j, false, smooth);
  if (smooth)
    BySquare(tile, around, i, j, part, to);
  else
    ByCells(tile, around, i, j, part.form, part.area, to);
}

void ColorsOfCells(LightTile& tile, int i, int j, const PartCells& cells,
                   const std::array<float*, 4>& to) {
  bool smooth = false;
  const Square around = SquareAround(tile, i, j, false, smooth);
  const float cx = float(i) + 0.5f - tile.middle(), cy = float(j) + 0.5f - tile.middle();
  const Near near = NearOf(tile, tile.squares());
  Enter(tile, NearOf(tile, around.index()), cx, cy, 0.7072f, near);
  alignas(64) float x[16], y[16];
  for (size_t k = 0; k < size_t(cells.count()); k += 16) {
    for (size_t q = 0; q < 16; ++q) x[q] = cx + cells.x[k + q], y[q] = cy + cells.y[k + q];
    Seen at;
    Shades shades;
    SeeFrom(tile, near, cx, cy, x, y, at);
    ShadePlaces(tile, at, x, y, shades);
    for (size_t c = 0; c < 4; ++c) std::copy_n(shades.c[c], 16, to[c] + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(BeginGround);
HWY_EXPORT(FindMean);
HWY_EXPORT(MeanOfPart);
HWY_EXPORT(ColorsOfCells);
}  // namespace batch

void LightTile::begin() {
  state.fill(State::unknown), known.fill(0), kept.clear();
}

void LightTile::begin_ground() {
  LightGround& g = *ground;
  g.state.fill(LightGround::State::unknown);
  g.near.resize(std::size_t(squares() + 1) * g.area.nodes().size());
  g.near_gradient.resize(std::size_t(squares() + 1) * g.gradient.nodes().size());
  MIEN_DISPATCH(BeginGround)(*this);
}

void find_mean(LightTile& tile, int i, int j) {
  MIEN_DISPATCH(FindMean)(tile, i, j);
}

LitPart part_of(const PartForm& form, const PartCells& cells) {
  LitPart part{&form, 0.0f, 0.0f, 0.0f};
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    part.area += cells.area[k];
    part.x += cells.area[k] * cells.x[k], part.y += cells.area[k] * cells.y[k];
  }
  const float over = part.area > 0.0f ? 1.0f / part.area : 0.0f;
  part.x *= over, part.y *= over;
  return part;
}

std::array<float, 4> mean_of_part(LightTile& tile, int i, int j, const LitPart& part) {
  std::array<float, 4> mean{};
  MIEN_DISPATCH(MeanOfPart)(tile, i, j, part, mean.data());
  return mean;
}

void colors_of_cells(LightTile& tile, int i, int j, const PartCells& cells,
                     const std::array<float*, 4>& to) {
  MIEN_DISPATCH(ColorsOfCells)(tile, i, j, cells, to);
}

}  // namespace mien
#endif
