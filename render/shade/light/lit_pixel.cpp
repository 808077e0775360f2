#include "render/shade/light/lit_pixel.h"
#include "render/blend/transfer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

/// [px] This close to its own outline, a round profile narrower than kSteepWidth is steep; one narrower than
/// kAllSteep is steep in all its depths.
constexpr float kEdge = 0.75f, kSteepWidth = 12.0f, kAllSteep = 1.0f;
constexpr float kMostTurn = 0.25f;  // of the gradient within a cell

bool is_steep(const LitPixel::Place& place) {
  const float width = place.lamp->width;
  return place.lamp->rise_kind == LampLanes::Rise::round && width < kSteepWidth &&
         place.foot.d > -kEdge - std::min(width, kAllSteep);
}

float apart(const LitMean& a, const LitMean& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// 16 × 16 cells are enough for three tenths of a level, judged by the worst ridges and tips seen.
constexpr float kFine = 0.1f / 255;

/// The permitted error of a mean in the blending space: dark colours in linear light are encoded steeply.
float allowed_of(const LitPixel::Place& place, const LitMean& mean) {
  if (!place.lamp->linear) return place.tolerance;
  // The rest of the pixel may be as dark as it likes.
  const auto steep = float(encoding_slope(mean.area * std::min({mean.r, mean.g, mean.b})));
  return place.tolerance / std::max(place.tolerance < kFine ? steep : 0.5f * steep, 1.0f);
}

constexpr float kMostKink = 33.0f;  // tolerances that a kink may change the law by over the cells

/// Whether 4 × 4 cells may be off by more than the tolerance. Where colours were within three tolerances of a
/// plane, the mean was found within one, kinks apart. What is narrow has no plane, so there the colours themselves
/// count. A ridge is cut in closed form, which leaves a twentieth of its jump. A part of a round profile may be a strip
/// with one row of cells, which does not show how light varies across it: at 16 bits that counts.
bool asks_for_more(const LitPixel::Place& place, const LitMean& mean, bool part) {
  const float allowed = allowed_of(place, mean) / mean.area;
  return mean.rough > 3.3f * allowed || mean.jump > 6.0f * allowed || mean.turn > kMostTurn ||
         mean.kink > kMostKink * allowed ||
         (part && mean.lean > 10.0f * allowed && mean.area < 0.7f) || (part && is_steep(place)) ||
         (part && place.tolerance < kFine && place.lamp->rise_kind == LampLanes::Rise::round);
}

/// Whether even cells half as wide as those of `coarse` may be off: they are nearer to the truth than to the coarse
/// ones. Of two ridges in a cell only one is cut. A kink leaves up to an eighth of its slope times the square of a
/// cell's side, which at 8 bits does not show in 8 × 8 cells; beside it the law may be steeper than its range over
/// the pixel says. Coarse cells that saw no such kink, in a rim half a pixel wide, agree with these by chance.
bool asks_for_finer(const LitPixel::Place& place, int side, const LitMean& mean,
                    const LitMean& coarse) {
  const float allowed = allowed_of(place, mean) / mean.area;
  const bool new_kink = mean.kink > kMostKink * allowed && coarse.kink < 0.5f * mean.kink;
  return apart(mean, coarse) > 0.8f * allowed || mean.turn > kMostTurn || new_kink ||
         0.15f * mean.unsure > place.tolerance ||
         (place.tolerance < kFine && 0.2f * mean.kink > allowed * float(side * side));
}

/// Whether 4 × 4 and 8 × 8 cells may agree by chance: where the tolerance is small, or a ridge changes colours very
/// much.
bool may_agree_by_chance(const LitPixel::Place& place, const LitMean& mean) {
  return place.tolerance < kFine || mean.jump > 250.0f * allowed_of(place, mean);
}

}  // namespace

void LitPixel::find_feet(NearFeet& feet) {
  const std::size_t count = std::size_t((cells_.places() + 15) / 16 * 16);
  feet.at(std::span(cells_.foot_x).first(count), std::span(cells_.foot_y).first(count),
          {cells_.d.data(), cells_.nx.data(), cells_.ny.data(), cells_.bend.data()});
}

void LitPixel::cut(const PartForm* form, int side) {
  if (form)
    cells_of_form(*form, side, parts_);
  else
    whole_cells(side, parts_);
}

void LitPixel::see(const Place& place, const PartForm* form, int side) {
  cut(form, side);
  cells_.x = place.at.x, cells_.y = place.at.y;
  cells_.shallow = place.shallow, cells_.deep = place.deep;
  cells_.foot = place.foot;
  cells_.take(parts_, !place.calm);
  if (!place.calm) find_feet(*place.feet);
}

LitMean LitPixel::seen(const Place& place, const PartForm* form, int side) {
  see(place, form, side);
  return mean_of_cells(*place.lamp, cells_);
}

glm::vec3 LitPixel::mean(const Place& place, const PartForm* form) {
  LitMean mean = seen(place, form, 4);
  constexpr float kSmall = 3.0f;  // [px] smaller domes may lie between the middles of cells
  const bool small = place.lamp->finest < kSmall || place.lamp->is_narrow();
  if (!small && !asks_for_more(place, mean, form)) return {mean.r, mean.g, mean.b};
  const bool fine = place.tolerance < kFine || small;
  const int most = fine ? PartCells::kMostSide : 16;
  for (int side = 8; side <= most; side *= 2) {
    const LitMean coarse = mean;
    mean = seen(place, form, side);
    const bool by_chance = side == 8 && (small || may_agree_by_chance(place, mean));
    if (!by_chance && !asks_for_finer(place, side, mean, coarse)) break;
  }
  return {mean.r, mean.g, mean.b};
}

void LitPixel::colors(const Place& place, const PartForm* form, int side, glm::vec3 otherwise,
                      std::span<float> r, std::span<float> g, std::span<float> b) {
  seen(place, form, side);
  for (int k = 0; k < parts_.count(); ++k) {
    const auto own = std::size_t(k), at = cells_.at(k);
    const bool is_there = parts_.area[own] != 0.0f;
    r[own] = is_there ? cells_.r[at] : otherwise.r, g[own] = is_there ? cells_.g[at] : otherwise.g;
    b[own] = is_there ? cells_.b[at] : otherwise.b;
  }
}

std::size_t LitPixel::find_feet_of_cells(const Place& place) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < std::size_t(parts_.count()); ++k) {
    if (parts_.area[k] == 0.0f) continue;
    cells_.area[count] = parts_.area[k];
    cells_.foot_x[count] = place.at.x + parts_.x[k],
    cells_.foot_y[count] = place.at.y + parts_.y[k];
    ++count;
  }
  if (count == 0) return 0;
  const std::size_t padded = (count + 15) / 16 * 16;
  std::fill_n(cells_.foot_x.begin() + std::ptrdiff_t(count), padded - count, cells_.foot_x[0]);
  std::fill_n(cells_.foot_y.begin() + std::ptrdiff_t(count), padded - count, cells_.foot_y[0]);
  place.feet->at(std::span(cells_.foot_x).first(padded), std::span(cells_.foot_y).first(padded),
                 {cells_.d.data(), cells_.nx.data(), cells_.ny.data(), cells_.bend.data()});
  return count;
}

float LitPixel::distance_by(const Place& place, const PartForm* form, int side) {
  cut(form, side);
  float sum = 0.0f, area = 0.0f;
  const float cell = parts_.cell(), spread = cell * cell / 24;
  const auto add = [&](float a, float d, float bend, float aside) {
    sum += a * (d + bend * (0.5f * aside * aside + spread)), area += a;
  };
  if (place.calm) {
    const FootAt& f = place.foot;
    for (std::size_t k = 0; k < std::size_t(parts_.count()); ++k) {
      const float x = parts_.x[k], y = parts_.y[k];
      add(parts_.area[k], f.d + f.nx * x + f.ny * y, f.bend, f.nx * y - f.ny * x);
    }
  } else {
    const std::size_t count = find_feet_of_cells(place);
    for (std::size_t k = 0; k < count; ++k) add(cells_.area[k], cells_.d[k], cells_.bend[k], 0.0f);
  }
  return area > 0.0f ? sum / area : place.foot.d;
}

float LitPixel::distance(const Place& place, const PartForm* form) {
  float mean = distance_by(place, form, 4);
  if (place.calm) return mean;
  // Two means may agree by chance where a ridge runs through cells, so three must.
  int agree = 0;
  for (int side = 8; side <= PartCells::kMostSide && agree < 2; side *= 2) {
    const float coarse = std::exchange(mean, distance_by(place, form, side));
    agree = std::abs(mean - coarse) <= place.tolerance ? agree + 1 : 0;
  }
  return mean;
}

}  // namespace mien
