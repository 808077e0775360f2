#include <mien/sdf/edge/leaf_edges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Collects edges of an area that is the intersection of their insides.
class AllOfLeaf {
 public:
  explicit AllOfLeaf(std::vector<LeafEdge>& edges) : edges_(edges), first_(int(edges.size())) {}

  void outside() { outside_ = true; }
  void add(const LeafEdge& edge) {
    edges_.push_back(edge);
    error_ = std::max(error_, double(edge.error));
  }
  LeafOutline outline() const {
    const int count = int(edges_.size()) - first_;
    if (outside_) {
      edges_.resize(std::size_t(first_));
      return {.rule = EdgeRule::outside, .error = 0.0};
    }
    if (count == 0) return {.rule = EdgeRule::inside, .error = 0.0};
    return {.rule = EdgeRule::all, .first = first_, .count = count, .error = error_};
  }

 private:
  std::vector<LeafEdge>& edges_;
  int first_;
  bool outside_ = false;
  double error_ = 0;
};

/// The edge whose outline point is at distance d from the leaf's centre, against its normal.
LeafEdge edge_at(double d, glm::dvec2 n, double bend, double c3, double c4, double error) {
  return {.x = float(-d * n.x),
          .y = float(-d * n.y),
          .nx = float(n.x),
          .ny = float(n.y),
          .bend = float(bend),
          .c3 = float(c3),
          .c4 = float(c4),
          .turn = 1,
          .error = float(error)};
}

/// Leaves up to this radius are asked of edges_near where the vectors prove nothing; larger ones are
/// divided first, which is cheaper.
constexpr double kPixel = 1.0;

/// How far an edge's distance may be from 0 for its outline to come into the disc.
double reach_of(double bend, double error, double radius) {
  return radius * (1.0 + 0.5 * std::abs(bend) * radius) + (error < kUnproven ? error : 0.0);
}

LeafOutline circle_outline(glm::dvec2 center, double circle_radius, glm::dvec2 c, double radius,
                           std::vector<LeafEdge>& edges) {
  const glm::dvec2 m = c - center;
  const double rho = glm::length(m), d = rho - circle_radius;
  AllOfLeaf all(edges);
  if (d > radius) all.outside();
  if (std::abs(d) <= radius) {
    const glm::dvec2 n = rho > 0.0 ? m / rho : glm::dvec2{1.0, 0.0};
    all.add(edge_at(d, n, 1.0 / circle_radius, 0.0, 0.0, 0.0));
  }
  return all.outline();
}

/// Where a piece of parabola ends, in pixels.
struct End {
  glm::dvec2 point, along, normal;  ///< along: unit, out of the piece; normal: the frame's up side
};
End end_of(const ParabolaForm& f, double x, double outward) {
  const glm::dvec2 up{-f.right.y, f.right.x};
  const double y = 2.0 * f.a * x;
  const glm::dvec2 along = (f.right + y * up) / std::sqrt(1.0 + y * y);
  return {f.origin + x * f.right + f.a * x * x * up, outward * along, {-along.y, along.x}};
}

}  // namespace

Leaves packed_to_front(const Leaves& leaves) {
  Leaves packed{.wanted = 0, .radius = leaves.radius};
  std::size_t n = 0;
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1, ++n) {
    const auto i = std::size_t(std::countr_zero(left));
    packed.x[n] = leaves.x[i], packed.y[n] = leaves.y[i];
    packed.wanted |= 1u << n;
  }
  for (std::size_t i = n; n > 0 && i < Leaves::kMost; ++i)
    packed.x[i] = packed.x[n - 1], packed.y[i] = packed.y[n - 1];
  return packed;
}

LeafOutline leaf_outline_near(const OffsetShape& shape, glm::dvec2 c, double radius,
                              std::vector<LeafEdge>& edges) {
  thread_local std::vector<Edge> found;
  found.clear();
  const LocalOutline local = edges_near(shape, c, radius, found);
  const LeafOutline outline{local.rule, int(edges.size()), local.count, local.winding,
                            local.count ? local.round_error : local.error};
  for (int i = local.first; i < local.first + local.count; ++i) {
    const Edge& e = found[std::size_t(i)];
    edges.push_back(edge_at(e.d, e.normal, e.bend, 0.0, 0.0, outline.error));
    edges.back().turn = e.turn;
  }
  return outline;
}

LeafOutlines::LeafOutlines(const OffsetShape& shape, double tolerance) : shape_(&shape) {
  if (const auto parabola = parabola_form(shape))
    form_ = *parabola;
  else if (const auto ellipse = ellipse_form(shape))
    form_ = *ellipse;
  else if (auto outline = outline_form(shape, tolerance))
    form_ = std::move(*outline);
}

void LeafOutlines::in_leaves(const Leaves& leaves, std::span<LeafOutline, Leaves::kMost> outlines,
                             std::vector<LeafEdge>& edges) const {
  if (const auto* f = std::get_if<ParabolaForm>(&form_))
    return parabola(*f, leaves, outlines, edges);
  if (const auto* f = std::get_if<EllipseForm>(&form_)) return ellipse(*f, leaves, outlines, edges);
  if (const auto* f = std::get_if<OutlineForm>(&form_))
    return outline_leaves(*f, leaves, outlines, edges);
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1) {
    const auto i = std::size_t(std::countr_zero(left));
    const glm::dvec2 c{leaves.x[i], leaves.y[i]};
    if (const auto* disc = std::get_if<Disc>(&shape_->shape);
        disc && disc->radius + shape_->offset > 0.0)
      outlines[i] =
          circle_outline(disc->center, disc->radius + shape_->offset, c, leaves.radius, edges);
    else
      outlines[i] = leaf_outline_near(*shape_, c, leaves.radius, edges);
  }
}

void LeafOutlines::parabola(const ParabolaForm& form, const Leaves& leaves,
                            std::span<LeafOutline, Leaves::kMost> outlines,
                            std::vector<LeafEdge>& edges) const {
  CurveLeaves found;
  const Leaves packed = packed_to_front(leaves);
  parabola_leaves(form, packed, found);
  const double r = leaves.radius, h = form.level;
  const bool ends = std::isfinite(form.lo);
  const End begin = ends ? end_of(form, form.lo, -1.0) : End{};
  const End end = ends ? end_of(form, form.hi, 1.0) : End{};
  std::size_t place = 0;
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1, ++place) {
    const auto i = std::size_t(std::countr_zero(left));
    const glm::dvec2 c{leaves.x[i], leaves.y[i]};
    if (!(found.proven >> place & 1u)) {
      outlines[i] =
          r > kPixel ? LeafOutline{.error = kUnproven} : leaf_outline_near(*shape_, c, r, edges);
      continue;
    }
    const glm::dvec2 normal{found.nx[place], found.ny[place]};
    AllOfLeaf all(edges);
    if (!form.stroke) {
      const CurveLeaves::Level& l = found.levels[0];
      const double d = h - found.side[place];
      if (d > reach_of(l.bend[place], l.error[place], r)) all.outside();
      if (std::abs(d) <= reach_of(l.bend[place], l.error[place], r))
        all.add(edge_at(d, -normal, l.bend[place], l.c3[place], l.c4[place], l.error[place]));
      outlines[i] = all.outline();
      continue;
    }
    const End* joined = nullptr;
    bool alone = false, both = false;
    const End* cap = nullptr;
    for (const End* e : {&begin, &end}) {
      const glm::dvec2 m = c - e->point;
      if (glm::dot(m, m) > (h + 2.0 * r) * (h + 2.0 * r)) continue;
      const double beyond = glm::dot(m, e->along);
      if (beyond > r) alone = true, cap = e;
      if (std::abs(beyond) <= r) both = joined != nullptr, joined = e;
    }
    if (both || (alone && joined)) {
      outlines[i] = leaf_outline_near(*shape_, c, r, edges);
      outlines[i].error = kUnproven;
      continue;
    }
    if (alone) {
      outlines[i] = circle_outline(cap->point, h, c, r, edges);
      continue;
    }
    if (!joined && !(found.foot[place] >= form.lo && found.foot[place] <= form.hi)) {
      outlines[i] = {.rule = EdgeRule::outside, .error = 0.0};  // the ends are too far
      continue;
    }
    for (const int toward : {1, -1}) {
      const CurveLeaves::Level& l = found.levels[toward > 0 ? 0 : 1];
      const double d = toward * found.side[place] - h,
                   reach = reach_of(l.bend[place], l.error[place], r);
      if (d > reach) all.outside();
      bool crosses = std::abs(d) <= reach;
      if (joined) {
        const glm::dvec2 m = c - joined->point;
        crosses |= std::abs(glm::length(m) - h) <= r && toward * glm::dot(m, joined->normal) >= -r;
      }
      if (!crosses) continue;
      LeafEdge edge = edge_at(d, double(toward) * normal, l.bend[place], l.c3[place], l.c4[place],
                              l.error[place]);
      if (joined) {
        const glm::dvec2 at = joined->point - c, n = double(toward) * joined->normal;
        edge.end_x = float(at.x), edge.end_y = float(at.y);
        edge.along_x = float(joined->along.x), edge.along_y = float(joined->along.y);
        edge.other_x = edge.along_x, edge.other_y = edge.along_y;
        edge.end_bend = float(1.0 / h);
        edge.end_nx = float(n.x), edge.end_ny = float(n.y);
      }
      all.add(edge);
    }
    outlines[i] = all.outline();
  }
}

void LeafOutlines::ellipse(const EllipseForm& form, const Leaves& leaves,
                           std::span<LeafOutline, Leaves::kMost> outlines,
                           std::vector<LeafEdge>& edges) const {
  CurveLeaves found;
  ellipse_leaves(form, packed_to_front(leaves), found);
  std::size_t place = 0;
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1, ++place) {
    const auto i = std::size_t(std::countr_zero(left));
    if (!(found.proven >> place & 1u)) {
      outlines[i] = leaves.radius > kPixel ? LeafOutline{.error = kUnproven}
                                           : leaf_outline_near(*shape_, {leaves.x[i], leaves.y[i]},
                                                               leaves.radius, edges);
      continue;
    }
    const CurveLeaves::Level& l = found.levels[0];
    const double d = found.side[place],
                 reach = reach_of(l.bend[place], l.error[place], leaves.radius);
    AllOfLeaf all(edges);
    if (d > reach) all.outside();
    if (std::abs(d) <= reach)
      all.add(edge_at(d, {found.nx[place], found.ny[place]}, l.bend[place], l.c3[place],
                      l.c4[place], l.error[place]));
    outlines[i] = all.outline();
  }
}

}  // namespace mien
