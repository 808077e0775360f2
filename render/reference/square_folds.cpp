// Distances that are not smooth in a square: with a fold, or to two outlines of one set.

#include "render/reference/square_resolver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kStep = 1e-6;  // [px] slopes by differences

/// The half-width of a stroke, whose distance is that to its spine less that much; 0 of a path, whose
/// distance is that to its sides, with a sign; < 0 of all others.
struct Pen {
  double operator()(const mien::Line& s) const { return s.half_width; }
  double operator()(const Polyline& s) const { return s.half_width; }
  double operator()(const QuadStroke& s) const { return s.half_width; }
  double operator()(const Path&) const { return 0.0; }
  template <class Other>
  double operator()(const Other&) const {
    return -1.0;
  }
};

}  // namespace

/// A distance with a fold along a line: of a stroke about its spine, or of a path about a side that has inside, or
/// outside, on both hands. Unfolded it has the form again.
bool SquareResolver::folded(int set, const Square& s, const NineDistances& d) {
  const LevelSet& level = logic_.sets()[std::size_t(set)];
  const double pen = scale_ * std::visit(Pen{}, scene_.shapes()[std::size_t(level.shape)]);
  if (pen < 0.0) return false;
  const double half = double(s.half) / kUnits, at_level = scale_ * level.level;
  const bool within = pen == 0.0 && d[4] + at_level <= 0.0;  // inside on both hands
  const double sign = within ? -1.0 : 1.0, width = within ? -at_level : pen + at_level;
  NineDistances u;  // the way to the fold
  for (std::size_t i = 0; i < 9; ++i) u[i] = sign * d[i] + width;
  if (*std::min_element(u.begin(), u.end()) < 0.0) return false;
  const auto far = int(std::max_element(u.begin(), u.end()) - u.begin());
  const auto offset_of = [&](int i) { return glm::dvec2{half * (i % 3 - 1), half * (i / 3 - 1)}; };
  const auto way = [&](glm::dvec2 p) {
    return sign * (distance(level.shape, place(s.x, s.y) + p) - at_level) + width;
  };
  const glm::dvec2 p = offset_of(far);
  const double here = u[std::size_t(far)];
  const glm::dvec2 slope{(way(p + glm::dvec2{kStep, 0.0}) - here) / kStep,
                         (way(p + glm::dvec2{0.0, kStep}) - here) / kStep};
  for (int i = 0; i < 9; ++i)
    if (here + glm::dot(slope, offset_of(i) - p) < 0.0) u[std::size_t(i)] *= -1.0;
  OutlineFit fit = fit_outline(u, half);
  if (!(fit.off <= (width > 0.0 ? allowed_off(fit, half, tolerance_) : tolerance_ / 4.0)))
    return false;
  Cut cut{.set = set, .opposite = within};
  if (width > 0.0) return cut_by_rims(cut, s, fit, width, sign);
  // No area: distances to two sides of a path w apart differ by w/2 from those to one fold, and a fit by half of
  // that.
  cut.opposite = !within;
  off_ += 8.0 * half * fit.off;
  cuts_.push_back(cut);
  return true;
}

/// The two outlines at `width` on either side of a fold.
bool SquareResolver::cut_by_rims(Cut cut, const Square& s, const OutlineFit& fold, double width,
                                 double sign) {
  const OutlineFit rims[] = {{fold.at - width, fold.normal, fold.bend, fold.off},
                             {-fold.at - width, -fold.normal, -fold.bend, fold.off}};
  for (int k = 0; k < 2; ++k) {
    const Side side = side_of(cut.set, s, rims[k], sign, cut.line[k]);
    if (side == Side::unknown) return false;
    if (side == Side::outside) {
      cuts_.push_back({.set = cut.set, .opposite = !cut.opposite});
      return true;
    }
    if (side == Side::crosses && cut.line[k] < 0) cut.line[k] = ~cut.line[k], cut.inside[k] = false;
  }
  cuts_.push_back(cut);
  return true;
}

/// Two straight outlines of one set, as of a path that almost runs back along itself: the distance is the larger or
/// the smaller of the two lines' own.
bool SquareResolver::two_lines(int set, const Square& s, const NineDistances& d) {
  const LevelSet& level = logic_.sets()[std::size_t(set)];
  const double half = double(s.half) / kUnits;
  const auto offset_of = [&](std::size_t i) {
    return glm::dvec2{half * (int(i) % 3 - 1), half * (int(i) / 3 - 1)};
  };
  const auto way = [&](glm::dvec2 p) {
    return distance(level.shape, place(s.x, s.y) + p) - scale_ * level.level;
  };
  const auto line_at = [&](std::size_t i) {
    const glm::dvec2 p = offset_of(i);
    const glm::dvec2 slope{(way(p + glm::dvec2{kStep, 0.0}) - d[i]) / kStep,
                           (way(p + glm::dvec2{0.0, kStep}) - d[i]) / kStep};
    return OutlineFit{d[i] - glm::dot(slope, p), slope};
  };
  const auto on = [&](const OutlineFit& f, std::size_t i) {
    return f.at + glm::dot(f.normal, offset_of(i));
  };
  std::size_t far = 0, other = 0;
  for (std::size_t i = 1; i < 9; ++i)
    if (std::abs(d[i]) > std::abs(d[far])) far = i;
  OutlineFit lines[2] = {line_at(far)};
  for (std::size_t i = 1; i < 9; ++i)
    if (std::abs(d[i] - on(lines[0], i)) > std::abs(d[other] - on(lines[0], other))) other = i;
  lines[1] = line_at(other);
  double off_most = 0.0, off_least = 0.0;
  for (std::size_t i = 0; i < 9; ++i) {
    const double a = on(lines[0], i), b = on(lines[1], i);
    off_most = std::max(off_most, std::abs(d[i] - std::max(a, b)));
    off_least = std::max(off_least, std::abs(d[i] - std::min(a, b)));
  }
  const double off = std::min(off_most, off_least);
  if (!(off <= tolerance_) || !hold_between(set, s, lines, off_most > off_least)) return false;
  return cut_by_both(set, lines, off_most > off_least, off, half);
}

/// Whether the two lines give the distance where they meet, which may be round, and between them.
bool SquareResolver::hold_between(int set, const Square& s, std::span<const OutlineFit> lines,
                                  bool either) {
  const LevelSet& level = logic_.sets()[std::size_t(set)];
  const double half = double(s.half) / kUnits;
  const glm::dvec2 a = lines[0].normal, b = lines[1].normal;
  const auto holds = [&](glm::dvec2 p) {
    if (!(std::max(std::abs(p.x), std::abs(p.y)) <= 1.1 * half)) return true;
    const double d = distance(level.shape, place(s.x, s.y) + p) - scale_ * level.level,
                 x = lines[0].at + glm::dot(a, p), y = lines[1].at + glm::dot(b, p);
    return std::abs(d - (either ? std::min(x, y) : std::max(x, y))) <= tolerance_;
  };
  const double turn = a.x * b.y - a.y * b.x;
  if (!holds({(a.y * lines[1].at - b.y * lines[0].at) / turn,
              (b.x * lines[0].at - a.x * lines[1].at) / turn}))
    return false;
  const Chord chord = chord_in_square(a, lines[0].at, half);
  if (!(chord.length() > 0.0)) return true;
  for (const double share : {0.1, 0.5, 0.9}) {
    const double t = chord.from + share * chord.length();
    const glm::dvec2 p = t * glm::dvec2{-a.y, a.x} - lines[0].at * a;
    if (!holds(p - 0.5 * (lines[1].at + glm::dot(b, p)) * b)) return false;
  }
  return true;
}

/// A set inside of both lines, or of either.
bool SquareResolver::cut_by_both(int set, std::span<const OutlineFit> lines, bool either,
                                 double off, double half) {
  Cut cut{.set = set, .inside = {!either, !either}, .opposite = either};
  for (std::size_t k = 0; k < 2; ++k) {
    const OutlineFit& f = lines[k];
    const double size = glm::length(f.normal);
    if (!(std::abs(size - 1.0) < 1e-3)) return false;
    const Line line{f.normal / size, f.at / size, 0.0, off};
    off_ += 4.0 * half * off;
    if (!(chord_in_square(line.normal, line.offset, half).length() > 0.0)) {
      if ((line.offset <= 0.0) == cut.inside[k]) continue;  // all of the square: the other decides
      cuts_.push_back({.set = set, .opposite = !either});
      return true;
    }
    bool turned = false;
    cut.line[k] = line_like(line, half, turned);
    if (cut.line[k] < 0) return false;
    if (turned) cut.inside[k] = !cut.inside[k];
  }
  cuts_.push_back(cut);
  return true;
}

}  // namespace mien
