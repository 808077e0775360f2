#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/pixel.h>

#include <cmath>

namespace mien {
namespace {

constexpr double kHalfDiagonal = 0.70710678118654757;  // of a unit square, rounded up

/// The side that a rule gives for the sides of its edges.
Side side_by_rule(const LocalOutline& outline, std::span<const Edge> edges, std::uint32_t inside) {
  const auto yes = [](bool in) { return in ? Side::in : Side::out; };
  switch (outline.rule) {
    case EdgeRule::outside:
      return Side::out;
    case EdgeRule::inside:
      return Side::in;
    default:
      break;
  }
  bool all = true, any = false;
  int winding = outline.winding;
  for (int i = outline.first; i < outline.first + outline.count; ++i) {
    const bool in = inside >> i & 1u;
    all &= in, any |= in;
    if (in) winding += edges[std::size_t(i)].turn;
  }
  switch (outline.rule) {
    case EdgeRule::all:
      return yes(all);
    case EdgeRule::any:
      return yes(any);
    case EdgeRule::nonzero:
      return yes(winding != 0);
    default:
      return yes(winding & 1);
  }
}

}  // namespace

Mix PixelResolver::pixel(const Scope& scope, glm::dvec2 center) {
  const auto mark = scopes_.mark();
  const Scope narrow = scopes_.narrowed(scope, center, kHalfDiagonal);
  varied_ = narrow.varied;
  error_ = 0.0;
  const Mix mix = square(narrow, center, 1.0, 0);
  scopes_.reset(mark);
  return mix;
}

/// Collects the edges of the scope's outlines around a square; whether they describe it well
/// enough.
bool PixelResolver::describe(const Scope& scope, glm::dvec2 center, double side) {
  const double radius = kHalfDiagonal * side;
  edges_.clear();
  locals_.clear();
  double error = 0.0;
  for (const int outline : scopes_.outlines(scope)) {
    const LocalOutline local =
        edges_near(tape_.outlines[std::size_t(outline)], center, radius, edges_);
    error += local.error;
    locals_.push_back(local);
  }
  if (edges_.size() > Arrangement::kMaxCuts) return false;
  if (edges_.size() == 1 && !scope.varied) {
    if (!(std::abs(edges_[0].bend * side) <= 1.0)) return false;
  } else {
    for (const Edge& edge : edges_)  // which are straightened
      error += EdgeCoverageContract::kStraightenedPerBend * std::abs(edge.bend) * side * side;
  }
  square_error_ = error;
  return error <= fine_.outline;
}

void PixelResolver::set_sides(const Scope& scope, std::uint32_t inside) {
  const auto outlines = scopes_.outlines(scope);
  for (std::size_t i = 0; i < outlines.size(); ++i)
    scopes_.set_side(outlines[i], side_by_rule(locals_[i], edges_, inside));
}

/// The mean over a square as its edges describe it.
Mix PixelResolver::resolve(const Scope& scope, double side) {
  if (edges_.empty()) {
    set_sides(scope, 0);
    return scopes_.color(scope);
  }
  if (edges_.size() == 1) {
    const Edge& e = edges_[0];
    const double covered = bent_edge_coverage(e.d / side, e.normal, e.bend * side);
    set_sides(scope, 1);
    const Mix in = scopes_.color(scope);
    set_sides(scope, 0);
    return covered * in + (1.0 - covered) * scopes_.color(scope);
  }
  cuts_.clear();
  for (const Edge& e : edges_)
    cuts_.push_back({straightened(e.d / side, e.normal, e.bend * side), e.normal});
  Mix mix{0.0};
  for (const Arrangement::Piece& piece : arrangement_.cut(cuts_)) {
    set_sides(scope, piece.inside);
    mix += piece.area * scopes_.color(scope);
  }
  return mix;
}

/// For cells of 1/64 px with more edges than an arrangement takes: their centre stands for them.
Mix PixelResolver::at_center(const Scope& scope, glm::dvec2 center) {
  for (const int outline : scopes_.outlines(scope))
    scopes_.set_side(outline, distance(tape_.outlines[std::size_t(outline)], center) <= 0.0
                                  ? Side::in
                                  : Side::out);
  return scopes_.color(scope);
}

Mix PixelResolver::square(const Scope& scope, glm::dvec2 center, double side, int depth) {
  if (depth > 0) ++stats_.cells;
  if (scope.varied) return varied_square(scope, center, side, depth);
  if (scope.outline_count == 0) {
    if (depth == 0) ++stats_.fill_pixels;
    return scopes_.color(scope);
  }
  const bool described = describe(scope, center, side);
  if (depth == 0)
    ++(described && edges_.size() <= 1 ? stats_.one_edge_pixels : stats_.divided_pixels);
  if (described) {
    constexpr double kChord = 1.4142135623730952;  // the longest line through a unit square
    error_ += std::min(side, kChord * square_error_) * side;
    return resolve(scope, side);
  }
  if (depth == fine_.depth) error_ += side * side;
  if (depth == fine_.depth)
    return edges_.size() <= Arrangement::kMaxCuts ? resolve(scope, side) : at_center(scope, center);
  return quarters(scope, center, side, depth);
}

Mix PixelResolver::quarters(const Scope& scope, glm::dvec2 center, double side, int depth) {
  const double quarter = 0.25 * side, half = 0.5 * side;
  Mix mix{0.0};
  for (const double y : {-quarter, quarter})
    for (const double x : {-quarter, quarter}) {
      const auto mark = scopes_.mark();
      const glm::dvec2 c = center + glm::dvec2{x, y};
      mix += 0.25 * square(scopes_.narrowed(scope, c, kHalfDiagonal * half), c, half, depth + 1);
      scopes_.reset(mark);
    }
  return mix;
}

}  // namespace mien
