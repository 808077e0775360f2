#include "pattern_private.h"

#include "face_numbers_private.h"
#include "lib/math/chance.h"
#include "lib/rig/eye/lid.h"
#include "smooth_curve_private.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// What chance is asked, each in a stream of its own.
enum class Asked : std::uint32_t { start_u, start_v, along, across, size, turn, begin, end };

/// In [0, 1), the same for the same figure of the same pattern.
double share(const PatternChance& chance, Asked what, int figure) {
  return mien::chance(chance.seed, std::uint32_t(what), figure);
}
/// In [−1, 1).
double either_way(const PatternChance& chance, Asked what, int figure) {
  return 2 * share(chance, what, figure) - 1;
}

/// A place on a pattern, and its direction there.
struct PatternPlace {
  glm::dvec2 at{0.0}, way{1.0, 0.0};
};

/// Bernstein's polynomials of 2 or 3 points at t.
std::array<double, 3> shares_at(int points, double t) {
  if (points == 2) return {1 - t, t, 0};
  return {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
}

/// The curve along the rows at v; a straight one has its bend half-way.
QuadBezier row_at(const PatternPatch& patch, const FaceNumbers& n, double v) {
  const std::array<double, 3> of = shares_at(patch.rows(), v);
  std::array<glm::dvec2, 3> p{};
  for (int c = 0; c < patch.columns; ++c)
    for (int r = 0; r < patch.rows(); ++r)
      p[std::size_t(c)] +=
          of[std::size_t(r)] * n.point(patch.points[std::size_t(r * patch.columns + c)]);
  if (patch.columns == 2) return {p[0], 0.5 * (p[0] + p[1]), p[1]};
  return {p[0], p[1], p[2]};
}

PatternPlace place_on(const QuadBezier& curve, double t) {
  const glm::dvec2 way = tangent(curve, t);
  const double length = glm::length(way);
  return {point(curve, t), length > 0 ? way / length : glm::dvec2{1.0, 0.0}};
}

class Mark {
 public:
  Mark(const PatternMark& mark, const PatternChance& chance, const FaceNumbers& n)
      : mark_(mark), chance_(chance), n_(n) {}

  Shape at(const PatternPlace& place, int figure) const {
    const double size = 1 - chance_.vary * share(chance_, Asked::size, figure);
    const glm::dvec2 way = turned(place.way, figure);
    if (mark_.kind == PatternMark::Kind::disc) return Disc{place.at, size * n_(mark_.size)};
    if (mark_.kind == PatternMark::Kind::ellipse)
      return Ellipse{.center = place.at, .radii = size * n_.point(mark_.size), .axis = way};
    const glm::dvec2 half = 0.5 * size * n_(mark_.size) * way;
    const QuadBezier spine{place.at - half, place.at, place.at + half};
    const int w = mark_.half_width;
    if (n_.size(w) == 1) return QuadStroke{spine, n_(w)};
    return TaperedStroke{spine, {n_(w, 0), n_(w, 1), n_(w, 2)}};
  }

 private:
  glm::dvec2 turned(glm::dvec2 way, int figure) const {
    double degrees = mark_.tilt < 0 ? 0 : n_(mark_.tilt);
    if (chance_.sway != 0)
      degrees +=
          (chance_.mirrored ? -1 : 1) * chance_.sway * either_way(chance_, Asked::turn, figure);
    if (degrees == 0) return way;
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * way.x - s * way.y, s * way.x + c * way.y};
  }

  const PatternMark& mark_;
  const PatternChance& chance_;
  const FaceNumbers& n_;
};

/// The i-th of places that fill the unit square evenly however many they are: the additive recurrence of the
/// plastic number (M. Roberts, 2018), from a start by chance.
glm::dvec2 even_place(const PatternChance& chance, int i) {
  constexpr double kPlastic = 1.324717957244746;
  const auto part = [](double v) { return v - std::floor(v); };
  return {part(share(chance, Asked::start_u, 0) + i / kPlastic),
          part(share(chance, Asked::start_v, 0) + i / (kPlastic * kPlastic))};
}

/// Up to one step of jitter moves a place by half a step either way, not beyond the square.
glm::dvec2 jittered(glm::dvec2 uv, glm::dvec2 step, const PatternChance& chance, int i) {
  if (chance.jitter == 0) return uv;
  const glm::dvec2 by{either_way(chance, Asked::along, i), either_way(chance, Asked::across, i)};
  return glm::clamp(uv + chance.jitter * step * by, 0.0, 1.0);
}

std::vector<glm::dvec2> places_of(const ScatterFigure& f) {
  std::vector<glm::dvec2> places;
  if (f.rows > 0) {
    const glm::dvec2 step{1.0 / f.columns, 1.0 / f.rows};
    for (int i = 0; i < f.columns * f.rows; ++i) {
      const int r = i / f.columns, c = i % f.columns;
      const double shift = f.stagger ? (r % 2 == 0 ? 0.25 : 0.75) : 0.5;
      places.push_back(jittered(step * glm::dvec2{c + shift, r + 0.5}, 0.5 * step, f.chance, i));
    }
    return places;
  }
  const double filled = f.round ? std::numbers::pi / 4 : 1;
  const double step = std::sqrt(filled / f.columns);
  // Even places fill the ellipse by its share; so this ends soon.
  for (int i = 0; int(places.size()) < f.columns; ++i) {
    const glm::dvec2 uv = jittered(even_place(f.chance, i), glm::dvec2{step}, f.chance, i);
    const glm::dvec2 from_middle = 2.0 * uv - 1.0;
    if (!f.round || glm::dot(from_middle, from_middle) <= 1) places.push_back(uv);
  }
  return places;
}

/// Places along curves by their length, which is that of kChords chords for each.
class Walk {
 public:
  explicit Walk(std::vector<QuadBezier> curves) : curves_(std::move(curves)) {
    for (const QuadBezier& curve : curves_)
      for (std::size_t i = 0; i < kChords; ++i)
        ends_.push_back(
            (ends_.empty() ? 0 : ends_.back()) +
            glm::length(point(curve, double(i + 1) / kChords) - point(curve, double(i) / kChords)));
  }

  /// At a share of the way.
  PatternPlace at(double of_all) const {
    const double wanted = of_all * ends_.back();
    const auto end =
        std::min(std::upper_bound(ends_.begin(), ends_.end(), wanted), ends_.end() - 1);
    const std::size_t chord = std::size_t(end - ends_.begin());
    const double begin = chord == 0 ? 0 : ends_[chord - 1], length = *end - begin;
    const double part = length > 0 ? (wanted - begin) / length : 0;
    return place_on(curves_[chord / kChords], (double(chord % kChords) + part) / kChords);
  }

 private:
  static constexpr std::size_t kChords = 16;
  std::vector<QuadBezier> curves_;
  std::vector<double> ends_;
};

}  // namespace

std::vector<Shape> pattern_shapes(const ScatterFigure& figure, const Face& face) {
  const FaceNumbers n(face);
  const Mark mark(figure.mark, figure.chance, n);
  std::vector<Shape> shapes;
  for (const glm::dvec2 uv : places_of(figure)) {
    const PatternPlace place = place_on(row_at(figure.patch, n, uv.y), uv.x);
    shapes.push_back(mark.at(place, int(shapes.size())));
  }
  return shapes;
}

std::vector<Shape> pattern_shapes(const RepeatFigure& figure, const Face& face) {
  const FaceNumbers n(face);
  const Mark mark(figure.mark, figure.chance, n);
  std::vector<glm::dvec2> points;
  for (const int p : figure.points)
    if (points.empty() || n.point(p) != points.back()) points.push_back(n.point(p));
  if (points.size() == 1) points.push_back(points[0]);
  const bool line = points[0] == points.back() && points.size() == 2;
  const Walk walk(figure.smooth && !line ? smooth_curve(points, face.model->canvas.twice_axis())
                                         : straight_curve(points));
  std::vector<Shape> shapes;
  for (int i = 0; i < figure.count; ++i) {
    const double by = figure.chance.jitter == 0
                          ? 0
                          : 0.5 * figure.chance.jitter * either_way(figure.chance, Asked::along, i);
    shapes.push_back(mark.at(walk.at((i + 0.5 + by) / figure.count), i));
  }
  return shapes;
}

std::vector<Shape> pattern_shapes(const StripesFigure& figure, const Face& face) {
  const FaceNumbers n(face);
  const PatternChance& chance = figure.chance;
  constexpr double kShorter = 0.25;  // of a stripe's length, at either end
  std::vector<Shape> shapes;
  for (int i = 0; i < figure.count; ++i) {
    double across = i + 0.5, from = 0, to = 1;
    if (chance.jitter != 0) {
      across += 0.5 * chance.jitter * either_way(chance, Asked::across, i);
      from = kShorter * chance.jitter * share(chance, Asked::begin, i);
      to = 1 - kShorter * chance.jitter * share(chance, Asked::end, i);
    }
    const QuadBezier row = row_at(figure.patch, n, across / figure.count);
    const QuadBezier spine = chance.jitter == 0
                                 ? row
                                 : QuadBezier{polar_form(row, from, from),
                                              polar_form(row, from, to), polar_form(row, to, to)};
    const double size = 1 - chance.vary * share(chance, Asked::size, i);
    const int w = figure.half_width;
    if (n.size(w) == 1)
      shapes.push_back(QuadStroke{spine, size * n(w)});
    else
      shapes.push_back(TaperedStroke{spine, {size * n(w, 0), size * n(w, 1), size * n(w, 2)}});
  }
  return shapes;
}

}  // namespace mien
