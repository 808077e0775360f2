#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/varied_square.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace mien {
namespace {

constexpr double kSqrtHalf = 0.70710678118654757;  // rounded up
constexpr Fineness kFine = fineness(Depth::u8, Blend::linear);
/// A round profile stands upright at its outline: cells that come so near to it [of their sides] are divided
/// once, those of profiles narrower than kNarrow [px] twice.
constexpr double kUpright = 0.25, kNarrow = 40.0;

/// Distances at the corners and centres of a grid of n × n cells around `middle`.
void ask_grid(NearArea& area, glm::dvec2 middle, double side, int n, std::vector<float>& xs,
              std::vector<float>& ys, std::vector<float>& ds, std::vector<float>& corners,
              std::vector<float>& centers) {
  const auto corner_count = std::size_t((n + 1) * (n + 1)), center_count = std::size_t(n * n);
  xs.clear(), ys.clear();
  const auto add = [&](int count, double from) {
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i)
        xs.push_back(float(middle.x + side * (i + from))),
            ys.push_back(float(middle.y + side * (j + from)));
  };
  add(n + 1, -0.5 * n);
  add(n, 0.5 - 0.5 * n);
  ds.resize(corner_count + center_count);
  area.distances(xs, ys, ds);
  corners.assign(ds.begin(), ds.begin() + std::ptrdiff_t(corner_count));
  centers.assign(ds.begin() + std::ptrdiff_t(corner_count), ds.end());
}

Bilinear bilinear_in(const std::vector<float>& corners, const std::vector<float>& centers, int n,
                     int column, int row) {
  const auto at = [&](int i, int j) { return double(corners[std::size_t(j * (n + 1) + i)]); };
  return bilinear(
      {at(column, row), at(column + 1, row), at(column, row + 1), at(column + 1, row + 1)},
      double(centers[std::size_t(row * n + column)]));
}

void append(const Bilinear& f, double side, LaneDistances& to) {
  to.mean.push_back(float(f.mean));
  to.x.push_back(float(f.x / side)), to.y.push_back(float(f.y / side));
  to.xy.push_back(float(f.xy / (side * side)));
}

}  // namespace

VariedSquare::VariedSquare(const Tape& tape) : tape_(tape), sampler_(tape) {}

// Stacks.

int VariedSquare::paint_of(int index) {
  for (std::size_t i = 0; i < paints_.size(); ++i)
    if (paints_[i].index == index) return int(i);
  paints_.push_back({.index = index});
  return int(paints_.size()) - 1;
}

/// What is seen with these sides. False: a group's opacity over colours that vary.
bool VariedSquare::add_layers(std::uint32_t sides, std::span<const SquareLayer> layers,
                              Stack& stack) {
  stack.layers.clear();
  stack.paints = 0;
  Mix plain{0.0};  // colours since the last paint
  const auto flush = [&] {
    if (plain == Mix{0.0}) return;
    LaneLayer layer;
    for (int c = 0; c < 4; ++c) layer.color[std::size_t(c)] = float(plain[c]);
    stack.layers.push_back(layer);
    plain = Mix{0.0};
  };
  Mix group_mix{0.0};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const SquareLayer& layer = layers[i];
    const bool seen = layer.in >> sides & 1u;
    if (layer.group >= 0) {
      if (seen && (layer.paint >= 0 || tape_.groups[std::size_t(layer.group)].parent >= 0))
        return false;
      if (seen && group_mix.a < 1.0) group_mix = over(group_mix, layer.mix);
      if (i + 1 < layers.size() && layers[i + 1].group == layer.group) continue;
      plain = over(plain, tape_.groups[std::size_t(layer.group)].opacity * group_mix);
      group_mix = Mix{0.0};
    } else if (seen && layer.paint < 0) {
      plain = over(plain, layer.mix);
    } else if (seen) {
      flush();
      const int paint = paint_of(layer.paint);
      if (paint >= kMostPaints) return false;
      stack.layers.push_back({.paint = paint});
      stack.paints |= 1u << paint;
      if (layer.mix.a >= 1.0) return true;
    }
    if (plain.a >= 1.0) break;
  }
  plain = over(plain, tape_.background);
  flush();
  return true;
}

bool VariedSquare::make_stacks(Leaf& leaf, std::span<const SquareLayer> layers) {
  stack_count_ = 0;
  paints_.clear();
  for (std::uint32_t sides = 0; sides < 1u << leaf.edge_count; ++sides) {
    Stack& made = stacks_[std::size_t(stack_count_)];
    if (!add_layers(sides, layers, made)) return false;
    int same = 0;
    const auto equal = [](const LaneLayer& a, const LaneLayer& b) {
      return a.paint == b.paint && a.color == b.color;
    };
    while (same < stack_count_ &&
           !std::ranges::equal(stacks_[std::size_t(same)].layers, made.layers, equal))
      ++same;
    stack_of_[sides] = leaf.same[sides] = std::uint8_t(same);
    if (same < stack_count_) continue;
    ++stack_count_;
    made.x.clear(), made.y.clear(), made.cell.clear(), made.weight.clear(), made.pixel.clear();
  }
  return true;
}

// Paints and distances in the square.

void VariedSquare::make_distance(Distance& distance) {
  const glm::dvec2 middle = place_.leaf_center + place_.shift;
  distance.area.narrow(tape_.distances[std::size_t(distance.index)], middle,
                       kSqrtHalf * place_.side);
  ask_grid(distance.area, {0.0, 0.0}, 1.0, place_.side, xs_, ys_, ds_, distance.corners,
           distance.centers);
  for (auto& fine : distance.fine) fine.pixel = -1;
  LaneDistances& lanes = distance.lanes;
  lanes.mean.clear(), lanes.x.clear(), lanes.y.clear(), lanes.xy.clear();
  for (int row = 0; row < place_.side; ++row)
    for (int column = 0; column < place_.side; ++column)
      append(bilinear_in(distance.corners, distance.centers, place_.side, column, row), 1.0, lanes);
}

/// Whether the paint has no kink in the whole square: then no pixel need ask.
void VariedSquare::classify_paint(Paint& paint) {
  const TapePaint& p = tape_.paints[std::size_t(paint.index)];
  const auto range_of = [&](int distance) {
    const auto& c = distances_[std::size_t(distance)].corners;
    const auto [lo, hi] = std::ranges::minmax(c);
    constexpr double kBetween = 0.75;  // a corner is so near to every place
    return std::pair{double(lo) - kBetween, double(hi) + kBetween};
  };
  paint.smooth = true;
  if (p.relief && paint.relief_distance >= 0) {
    const auto [lo, hi] = range_of(paint.relief_distance);
    p.relief->kinks(lo, hi, kinks_);
    paint.smooth &= kinks_.empty();
  }
  if (!p.ramp) return;
  const glm::dvec2 middle = place_.leaf_center + place_.shift;
  const double reach = kSqrtHalf * place_.side;
  double lo, hi;
  if (paint.place_distance >= 0) {
    std::tie(lo, hi) = range_of(paint.place_distance);
    const double a = p.field.at({}, lo), b = p.field.at({}, hi);
    lo = std::min(a, b), hi = std::max(a, b);
  } else {
    const double t = p.field.at(middle, 0.0);
    lo = t - reach * p.field.per_pixel, hi = t + reach * p.field.per_pixel;
    if (p.field.kind == PaintField::Kind::radial)
      paint.smooth &= glm::distance(middle, p.field.center) > reach + 2.0;
  }
  const Ramp::Range range = p.ramp->range(lo, hi, kinks_);
  paint.smooth &= !range.many && kinks_.empty() && range.jump == 0.0;
}

/// False: a paint is not for vectors here.
bool VariedSquare::make_paints() {
  lane_paints_.clear();
  distance_count_ = 0;
  const auto distance_of = [&](int index) {
    for (int i = 0; i < distance_count_; ++i)
      if (distances_[std::size_t(i)].index == index) return i;
    if (distances_.size() == std::size_t(distance_count_)) distances_.emplace_back();
    distances_[std::size_t(distance_count_)].index = index;
    return distance_count_++;
  };
  for (Paint& paint : paints_) {
    const TapePaint& p = tape_.paints[std::size_t(paint.index)];
    if (!fits_lanes(p)) return false;
    const auto lanes = lane_paint(p, tape_.blend, place_.leaf_center);
    if (!lanes) return false;
    lane_paints_.push_back(*lanes);
    if (p.ramp && p.field.distance >= 0) paint.place_distance = distance_of(p.field.distance);
    if (p.relief && p.relief->distance >= 0)
      paint.relief_distance = distance_of(p.relief->distance);
  }
  for (int i = 0; i < distance_count_; ++i) make_distance(distances_[std::size_t(i)]);
  for (std::size_t i = 0; i < paints_.size(); ++i) {
    const Paint& paint = paints_[i];
    if (paint.place_distance >= 0)
      lane_paints_[i].place_distance = &distances_[std::size_t(paint.place_distance)].lanes;
    if (paint.relief_distance >= 0)
      lane_paints_[i].distance = &distances_[std::size_t(paint.relief_distance)].lanes;
    classify_paint(paints_[i]);
  }
  return true;
}

// Cells.

Bilinear VariedSquare::bilinear_of(Distance& distance, const Cell& cell) {
  if (cell.depth == 0)
    return bilinear_in(distance.corners, distance.centers, place_.side, cell.column, cell.row);
  auto& fine = distance.fine[std::size_t(cell.depth - 1)];
  const int n = 1 << cell.depth;
  if (fine.pixel != cell.pixel) {
    fine.pixel = cell.pixel;
    const glm::dvec2 first = glm::dvec2{cell.column, cell.row} + glm::dvec2{0.5 - 0.5 * n};
    ask_grid(distance.area, cell.center - cell.side * first - place_.shift, cell.side, n, xs_, ys_,
             ds_, fine.corners, fine.centers);
  }
  return bilinear_in(fine.corners, fine.centers, n, cell.column, cell.row);
}

LocalPaint VariedSquare::local_of(const Paint& paint, const Cell& cell) {
  const TapePaint& p = tape_.paints[std::size_t(paint.index)];
  const glm::dvec2 center = place_.leaf_center + cell.center;
  LocalPaint local{.paint = &p,
                   .blend = tape_.blend,
                   .center = center,
                   .side = cell.side,
                   .place = {},
                   .distance = {}};
  if (paint.relief_distance >= 0)
    local.distance = bilinear_of(distances_[std::size_t(paint.relief_distance)], cell);
  if (!p.ramp) return local;
  if (paint.place_distance >= 0) {
    const PaintField& field = p.field;
    Bilinear d = bilinear_of(distances_[std::size_t(paint.place_distance)], cell);
    d.mean = (d.mean - field.from) * field.scale;
    d.x *= field.scale, d.y *= field.scale, d.xy *= field.scale;
    d.residual *= std::abs(field.scale);
    local.place = d;
  } else if (p.field.kind == PaintField::Kind::linear) {
    local.place = {.mean = p.field.at(center, 0.0),
                   .x = p.field.across.x * cell.side,
                   .y = p.field.across.y * cell.side};
  } else {
    const double h = 0.5 * cell.side;
    const auto at = [&](double x, double y) { return p.field.at(center + glm::dvec2{x, y}, 0.0); };
    local.place = bilinear({at(-h, -h), at(h, -h), at(-h, h), at(h, h)}, at(0.0, 0.0));
  }
  return local;
}

/// Whether the paints are known well enough in the cell; collects where they have kinks.
bool VariedSquare::good(const Cell& cell, std::uint32_t paints) {
  bool good = true;
  cuts_.clear();
  for (; paints; paints &= paints - 1) {
    const Paint& paint = paints_[std::size_t(std::countr_zero(paints))];
    const TapePaint& p = tape_.paints[std::size_t(paint.index)];
    if (paint.smooth && !p.relief && paint.place_distance < 0) continue;
    const LocalPaint local = local_of(paint, cell);
    if (paint.smooth && paint.place_distance < 0) {
      good &= !sampler_.creased(local);
      continue;
    }
    // Places along lines and from centres are exact at every sample.
    const double error = sampler_.error(local, paint.place_distance < 0, cuts_);
    good &= error * cell.side <= kFine.paint && !sampler_.creased(local);
    if (p.relief && paint.relief_distance >= 0 && p.relief->profile == Profile::round)
      good &= cell.depth >= (p.relief->width < kNarrow ? 2 : 1) ||
              std::abs(local.distance.mean) - local.distance.reach() > kUpright * cell.side;
  }
  return good;
}

/// The paints that can be seen in a square.
std::uint32_t VariedSquare::paints_of(std::uint32_t active, std::uint32_t base) const {
  std::uint32_t paints = 0;
  for (std::uint32_t sub = active;; sub = (sub - 1) & active) {
    paints |= stacks_[stack_of_[base | sub]].paints;
    if (sub == 0) return paints;
  }
}

int VariedSquare::name(const Cell& cell) {
  if (cell.depth == 0) return cell.pixel;
  cell_x_.push_back(float(cell.center.x)), cell_y_.push_back(float(cell.center.y));
  for (int i = 0; i < distance_count_; ++i) {
    Distance& distance = distances_[std::size_t(i)];
    append(bilinear_of(distance, cell), cell.side, distance.lanes);
  }
  return int(cell_x_.size()) - 1;
}

void VariedSquare::pixel(const Leaf& leaf, int column, int row, std::uint32_t asked,
                         std::uint32_t base) {
  const double half = 0.5 * place_.side;
  const Cell pixel{.center = place_.shift + glm::dvec2{column + 0.5 - half, row + 0.5 - half},
                   .side = 1.0,
                   .pixel = row * place_.side + column,
                   .depth = 0,
                   .column = column,
                   .row = row};
  cell(leaf, pixel, asked, base);
}

void VariedSquare::cell(const Leaf& leaf, const Cell& here, std::uint32_t asked,
                        std::uint32_t base) {
  std::uint32_t active = 0, sides = base, again = 0;
  if (asked) {
    const LeafView view = see_square(leaf, here.center, here.side, tolerance_, asked, base);
    active = view.active, sides = view.base, again = view.with_end;
  }
  if (!good(here, paints_of(active, sides)) && here.depth < kMostDepth) {
    const double quarter = 0.25 * here.side;
    for (const int j : {0, 1})
      for (const int i : {0, 1}) {
        const bool whole = here.depth == 0;
        cell(leaf,
             {.center = here.center + quarter * glm::dvec2{2 * i - 1, 2 * j - 1},
              .side = 0.5 * here.side,
              .pixel = here.pixel,
              .depth = here.depth + 1,
              .column = (whole ? 0 : 2 * here.column) + i,
              .row = (whole ? 0 : 2 * here.row) + j},
             active | again, sides & ~again);
      }
    return;
  }
  Cell named = here;
  named.index = name(here);
  edges(leaf, named, here.center, here.side, here.depth, active | again, sides & ~again);
}

/// Blocks of 4 × 4 pixels that no edge crosses need not ask for each of theirs.
void VariedSquare::blocks(const Leaf& leaf) {
  if (place_.side == 1) return pixel(leaf, 0, 0, (1u << leaf.edge_count) - 1u, 0);
  const int count = place_.side / 4;
  for (int by = 0; by < count; ++by)
    for (int bx = 0; bx < count; ++bx) {
      const glm::dvec2 middle =
          place_.shift + 4.0 * glm::dvec2{bx + 0.5 - 0.5 * count, by + 0.5 - 0.5 * count};
      const BlockSides sides = see_block(leaf, middle);
      for (int j = 4 * by; j < 4 * by + 4; ++j)
        for (int i = 4 * bx; i < 4 * bx + 4; ++i) pixel(leaf, i, j, sides.crossed, sides.inside);
    }
}

bool VariedSquare::draw(Leaf& leaf, std::span<const SquareLayer> layers, const Place& place,
                        double tolerance, std::uint32_t* pixels) {
  place_ = place, tolerance_ = tolerance;
  if (!make_stacks(leaf, layers) || !make_paints()) return false;
  const int side = place.side;
  cell_x_.clear(), cell_y_.clear();
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      cell_x_.push_back(float(place.shift.x + column + 0.5 - 0.5 * side));
      cell_y_.push_back(float(place.shift.y + row + 0.5 - 0.5 * side));
    }
  std::fill_n(sums_.begin(), side * side, Mix{0.0});
  std::fill_n(varies_.begin(), side * side, char(0));
  blocks(leaf);
  store(pixels);
  return true;
}

LanePlaces VariedSquare::Stack::places() const {
  return {.x = x, .y = y, .cell = cell, .cell_x = nullptr, .cell_y = nullptr};
}

void VariedSquare::store(std::uint32_t* pixels) {
  for (int i = 0; i < stack_count_; ++i) {
    const Stack& stack = stacks_[std::size_t(i)];
    if (stack.x.empty()) continue;
    const std::size_t n = stack.x.size();
    for (auto& plane : colors_) plane.resize(std::max(plane.size(), n));
    LanePlaces places = stack.places();
    places.cell_x = cell_x_.data(), places.cell_y = cell_y_.data();
    lane_colors(stack.layers, lane_paints_, tape_.blend, places,
                {colors_[0].data(), colors_[1].data(), colors_[2].data(), colors_[3].data()});
    for (std::size_t k = 0; k < n; ++k)
      sums_[stack.pixel[k]] +=
          stack.weight[k] * Mix{colors_[0][k], colors_[1][k], colors_[2][k], colors_[3][k]};
    if (stack.paints)
      for (const std::uint16_t pixel : stack.pixel) varies_[pixel] = 1;
  }
  constexpr int kAll = kLeaf * kLeaf;
  alignas(64) float planes[4][kAll] = {}, carry[kAll] = {};
  const int side = place_.side, count = side * side;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 4; ++c) planes[c][i] = float(sums_[std::size_t(i)][c]);
    const bool dithered = tape_.dither && varies_[std::size_t(i)];
    carry[i] = dithered ? float(dither_threshold(place_.x + i % side, place_.y + i / side)) : 0.5f;
  }
  lane_pixels({planes[0], planes[1], planes[2], planes[3]}, tape_.blend, carry, std::size_t(count),
              pixels);
}

}  // namespace mien
