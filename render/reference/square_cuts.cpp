// What outlines part a square into: lines, and polygons between them.

#include "render/reference/square_resolver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr std::size_t kMostLines = 8;  // across one square: more are fewer in its quarters
constexpr std::size_t kMostCorners = 4 + kMostLines;
constexpr double kShort = 0.01;  // of half a square: chords that cut off nothing to speak of

/// Twice a polygon's area, and six times its first moments about its first corner.
struct Moments {
  double area = 0;
  glm::dvec2 first{0.0};
};

Moments moments(std::span<const glm::dvec2> corners) {
  Moments m;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i - 1] - corners[0], b = corners[i] - corners[0];
    const double twice = a.x * b.y - a.y * b.x;
    m.area += twice, m.first += twice * (a + b);
  }
  return m;
}

}  // namespace

/// All outlines across the square are known, and what they part it into has one colour each.
bool SquareResolver::cuts(const Square& s, const Scope& scope, Resolved& to) {
  const double half = double(s.half) / kUnits, side = 2.0 * half;
  constexpr double kSmall = 1.0 / 128;  // [px] means in smaller squares are as good as they get
  varies_here_ = varied(scope);
  if (varies_here_ && side > kSmall) {
    const Kink kink = kink_in(place(s.x, s.y), half, scope);
    if (half > kLitHalf && lit(scope)) return false;
    if (kink == Kink::jump || side > (kink == Kink::stop ? 1.0 / 32 : 1.0 / 4)) return false;
  }
  lines_.clear(), cuts_.clear(), off_ = 0.0;
  for (const int set : logic_.open_sets(scope))
    if (!cut_by(set, s)) return false;
  const double shift = crossings(half);
  if (!(shift <= tolerance_ / 16.0)) return false;
  const glm::dvec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  sum_ = Mix{0.0}, least_ = Mix{HUGE_VAL}, most_ = Mix{-HUGE_VAL};
  bent_ = 0.0;
  polygon(s, scope, 0, corners);
  if (bent_ > tolerance_ * side * side && side > kSmall) return false;
  to.mix = sum_ / (side * side);
  // The last term stands for what may be off between the places that were measured.
  to.bound = (off_ + shift + bent_) / (side * side) * largest(most_ - least_) + 0.125 * tolerance_;
  return true;
}

/// One set's outline in the square.
bool SquareResolver::cut_by(int set, const Square& s) {
  const LevelSet& level = logic_.sets()[std::size_t(set)];
  NineDistances d;
  for (int i = 0; i < 9; ++i)
    d[std::size_t(i)] =
        distance(level.shape, s.x + s.half * (i % 3 - 1), s.y + s.half * (i / 3 - 1)) -
        scale_ * level.level;
  const double half = double(s.half) / kUnits;
  const OutlineFit fit = fit_outline(d, half);
  if (!(fit.off <= allowed_off(fit, half, tolerance_)))
    return folded(set, s, d) || two_lines(set, s, d);
  Cut cut{set};
  const Side side = side_of(set, s, fit, 1.0, cut.line[0]);
  if (side == Side::unknown) return false;
  if (side == Side::crosses && cut.line[0] < 0) cut.line[0] = ~cut.line[0], cut.inside[0] = false;
  cut.opposite = side == Side::outside;
  cuts_.push_back(cut);
  return true;
}

/// How an outline lies in the square: all of it on one side, or across it. `sign` times the set's distance has the
/// form.
SquareResolver::Side SquareResolver::side_of(int set, const Square& s, const OutlineFit& fit,
                                             double sign, int& line) {
  const double half = double(s.half) / kUnits;
  const Chord chord = chord_in_square(fit.normal, fit.at, half);
  if (chord.length() > kShort * half) return crosses(set, s, fit, sign, line);
  const double margin = std::abs(fit.at) - half * (std::abs(fit.normal.x) + std::abs(fit.normal.y));
  const double sag = std::abs(fit.bend) * half * half + fit.off;
  if (sag > margin + tolerance_) return Side::unknown;
  if (sag > margin) off_ += 2.0 * half * (sag - margin);
  return fit.at <= 0.0 ? Side::inside : Side::outside;
}

// The outline is n = −(at + bend₀ s²/2) with s along it; bend₀ is the bend on the outline that belongs to `bend` at
// the middle. It is replaced by the line through its two points at the ends of the chord, shifted by the mean of
// the difference. That line parts the square in the same areas, except for what lies between the ends of the two.
// Distances measured on the outline, at its ends and in its middle, say by how much it is off, and correct it by
// Simpson's rule.
SquareResolver::Side SquareResolver::crosses(int set, const Square& s, const OutlineFit& fit,
                                             double sign, int& line) {
  const double half = double(s.half) / kUnits;
  if (std::abs(fit.bend * fit.at) > 0.5) return Side::unknown;
  const double bend = fit.bend / (1.0 - fit.bend * fit.at);
  const Chord chord = chord_in_square(fit.normal, fit.at, half);
  const double a = chord.from, b = chord.to, length = chord.length();
  const LevelSet& level = logic_.sets()[std::size_t(set)];
  const glm::dvec2 center = place(s.x, s.y), along = fit.along();
  const auto off_at = [&](double t) {
    const glm::dvec2 p = center - (fit.at + 0.5 * bend * t * t) * fit.normal + t * along;
    return sign * (distance(level.shape, p) - scale_ * level.level);
  };
  const double off_a = off_at(a), off_m = off_at(0.5 * (a + b)), off_b = off_at(b);
  const double most = std::max({std::abs(off_a), std::abs(off_m), std::abs(off_b)}),
               mean = (off_a + 4.0 * off_m + off_b) / 6.0,
               sag = std::abs(bend) * length * length / 12.0;
  if (!(most <= 4.0 * tolerance_)) return Side::unknown;
  const double turn = length > half ? (off_b - off_a) / length : 0.0,
               tilt = 0.5 * bend * (a + b) + turn;
  const glm::dvec2 normal = fit.normal + tilt * along;
  const double size = glm::length(normal);
  const double offset =
      fit.at - bend * (a * a + 4.0 * a * b + b * b) / 12.0 + mean - 0.5 * turn * (a + b);
  const Line made{normal / size, offset / size, bend, sag + most};
  const double ends = beside_ends(made, half);
  if (!(ends <= tolerance_ * half)) return Side::unknown;
  off_ += 2.0 * length * most + ends;
  bool turned = false;
  line = line_like(made, half, turned);
  if (line < 0) return Side::unknown;
  if (turned) line = ~line;
  return Side::crosses;
}

/// The line's index among those of the square; outlines that coincide share a line. −1: there are too many.
int SquareResolver::line_like(const Line& line, double half, bool& turned) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& l = lines_[i];
    const double sign = glm::dot(l.normal, line.normal) < 0.0 ? -1.0 : 1.0;
    const glm::dvec2 turn = line.normal - sign * l.normal;
    const double apart = 1.5 * half * glm::length(turn) + std::abs(line.offset - sign * l.offset);
    if (apart > tolerance_ / 64.0) continue;
    off_ += 2.0 * half * apart;
    turned = sign < 0.0;
    return int(i);
  }
  if (lines_.size() == kMostLines) return -1;
  lines_.push_back(line);
  return int(lines_.size()) - 1;
}

/// The area between an outline and its line beside the square's border, where they leave it: a triangle as high as
/// they are apart there, and longer the more nearly they run along the border. Beside a corner the outline may
/// leave through the other border, as far from the line as it sags in the whole square.
double SquareResolver::beside_ends(const Line& line, double half) const {
  const glm::dvec2 along{-line.normal.y, line.normal.x}, foot = -line.offset * line.normal,
                                                         across = glm::abs(line.normal);
  const Chord chord = chord_in_square(line.normal, line.offset, half);
  const auto triangle = [&](double high, double rate) {
    return 0.5 * high * high / std::max(rate, high / half);
  };
  double sum = 0.0;
  for (const double t : {chord.from, chord.to}) {
    const glm::dvec2 p = glm::abs(foot + t * along);
    sum += triangle(line.sag, p.x > p.y ? across.y : across.x);
  }
  const double bent = std::abs(line.bend) * half * half + line.sag;
  for (const double y : {-half, half})
    for (const double x : {-half, half})
      if (std::abs(line.offset + glm::dot(line.normal, glm::dvec2{x, y})) < bent)
        sum += triangle(bent, std::min(across.x, across.y));
  return sum;
}

/// How much area may be misplaced because outlines cross within the square: their lines cross elsewhere.
double SquareResolver::crossings(double half) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Line &a = lines_[i], &b = lines_[j];
      const glm::dvec2 along{-a.normal.y, a.normal.x}, foot = -a.offset * a.normal;
      const Chord chord = chord_in_square(a.normal, a.offset, half);
      const double from = b.offset + glm::dot(b.normal, foot + chord.from * along),
                   to = b.offset + glm::dot(b.normal, foot + chord.to * along),
                   near = a.sag + b.sag;
      if (std::min(from, to) > near || std::max(from, to) < -near) continue;
      const double length = 2.0 * half, apart = std::max(std::abs(from), std::abs(to));
      double moved = 0.25 * length * near;
      if (apart < 0.1 * length) {  // nearly along each other: what they share is nothing
        const double sign = glm::dot(a.normal, b.normal) < 0.0 ? -1.0 : 1.0;
        const double bends = std::abs(a.bend - sign * b.bend) * length * length / 12.0,
                     shift = 0.5 * std::abs(a.bend) * length * apart;
        moved = std::min(moved, length * (bends + shift));
      }
      sum += moved;
    }
  return sum;
}

/// Adds a polygon in which paints vary, by triangles with three places in each, exact for polynomials of degree
/// two. By how much the colour at the centroid differs is the estimated error, or by how much corners differ from what
/// both tell: a ridge past all of them cuts one off.
void SquareResolver::add_varied(glm::dvec2 center, const Scope& scope,
                                std::span<const glm::dvec2> corners) {
  // Of the way to the middle: a corner may be on an outline. And what such a ridge cuts off at most, of the area.
  constexpr double kIn = 0.05, kCorner = 0.15;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const glm::dvec2 t[] = {corners[0], corners[i - 1], corners[i]};
    const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0], middle = (t[0] + t[1] + t[2]) / 3.0;
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    if (!(area > 0.0)) continue;
    const Mix inmost = color(center + middle, scope);
    Mix mean{0.0};
    double off = 0.0;
    for (const glm::dvec2 p : t) {
      const Mix half = color(center + 0.5 * (p + middle), scope);
      const Mix told = inmost + 2.0 * (1.0 - kIn) * (half - inmost);
      off = std::max(off, kCorner * largest(color(center + p + kIn * (middle - p), scope) - told));
      mean += half / 3.0;
    }
    sum_ += area * mean;
    bent_ += area * std::max(off, largest(mean - inmost));
  }
}

/// Adds a polygon of the square, cut by the lines from `done` on.
void SquareResolver::polygon(const Square& s, const Scope& scope, std::size_t done,
                             std::span<const glm::dvec2> corners) {
  const Moments m = moments(corners);
  if (!(m.area > 0.0)) return;
  if (done == lines_.size()) {
    for (const Cut& cut : cuts_) {
      bool inside = true;
      for (int k = 0; k < 2; ++k)
        if (cut.line[k] >= 0) inside &= sides_[std::size_t(cut.line[k])] == cut.inside[k];
      inside_[std::size_t(cut.set)] = inside != cut.opposite;
    }
    const glm::dvec2 centroid = place(s.x, s.y) + corners[0] + m.first / (3.0 * m.area);
    const Mix mix = color(centroid, scope);
    if (varies_here_)
      add_varied(place(s.x, s.y), scope, corners);
    else
      sum_ += 0.5 * m.area * mix;
    least_ = glm::min(least_, mix), most_ = glm::max(most_, mix);
    return;
  }
  const Line& line = lines_[done];
  for (const double sign : {1.0, -1.0}) {
    glm::dvec2 part[kMostCorners];
    std::size_t count = 0;
    const auto depth = [&](glm::dvec2 p) {
      return sign * (line.offset + glm::dot(line.normal, p));
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 p = corners[i], q = corners[i + 1 < corners.size() ? i + 1 : 0];
      const double d = depth(p), e = depth(q);
      if (d <= 0.0) part[count++] = p;
      if ((d < 0.0 && e > 0.0) || (d > 0.0 && e < 0.0)) part[count++] = p + d / (d - e) * (q - p);
    }
    sides_[done] = sign > 0.0;
    polygon(s, scope, done + 1, {part, count});
  }
}

}  // namespace mien
