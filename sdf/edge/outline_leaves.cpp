// Closed outlines in leaves: which sides come into a leaf, how they hang together there, and how
// often the outline winds around it.

#include <mien/sdf/edge/leaf_edges.h>
#include <mien/sdf/shape/path.h>
#include <mien/sdf/shape/quad_bezier.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Lengths just beyond a leaf's radius count as in it, so that a joint and the sides that share it
/// are never told apart by a rounding.
constexpr double kWide = 1.0 + 1e-9;

glm::dvec2 right_of(glm::dvec2 way) {
  return {way.y, -way.x};
}

/// A side in a leaf.
struct Passing {
  int side;
  LeafEdge::Body body;  ///< out is the side's right
  double error;
  bool begins, ends;  ///< in the leaf
};

/// The sides in one leaf; more than a few are asked for in smaller leaves.
struct Passings {
  static constexpr int kMost = 5;
  std::array<Passing, kMost> list;
  int count = 0;
  bool unproven = false;

  const Passing* of(int side) const {
    for (int i = 0; i < count; ++i)
      if (list[std::size_t(i)].side == side) return &list[std::size_t(i)];
    return nullptr;
  }
  void add(const Passing& p) {
    if (count == kMost)
      unproven = true;
    else
      list[std::size_t(count++)] = p;
  }
};

LeafEdge edge_of(const LeafEdge::Body& b, double error) {
  return {.x = b.x,
          .y = b.y,
          .nx = b.nx,
          .ny = b.ny,
          .bend = b.bend,
          .c3 = b.c3,
          .c4 = b.c4,
          .turn = 1,
          .error = float(error)};
}

/// The same outline, its other side out.
void turn_over(LeafEdge::Body& b) {
  b.nx = -b.nx, b.ny = -b.ny, b.bend = -b.bend, b.c4 = -b.c4;  // X changes its sign too: c3 stays
}
void turn_over(LeafEdge& e) {
  LeafEdge::Body b{e.x, e.y, e.nx, e.ny, e.bend, e.c3, e.c4};
  turn_over(b), turn_over(e.next);
  e.nx = b.nx, e.ny = b.ny, e.bend = b.bend, e.c4 = b.c4;
}

/// Roughly the signed distance from p to the edge.
double value(const LeafEdge& e, glm::dvec2 p) {
  if (e.has_end() || e.joined) {
    const glm::dvec2 u = p - glm::dvec2{e.end_x, e.end_y};
    if (glm::dot(u, glm::dvec2{e.along_x, e.along_y}) > 0.0) {
      if (e.joined) {
        LeafEdge other = e.beyond();
        other.joined = false;
        return value(other, p);
      }
      return glm::dot(u, glm::dvec2{e.end_nx, e.end_ny}) >= 0.0
                 ? glm::length(u) - 1.0 / double(e.end_bend)
                 : -1e6;
    }
  }
  const glm::dvec2 u = p - glm::dvec2{e.x, e.y}, n{e.nx, e.ny};
  const double x = u.y * n.x - u.x * n.y;
  return glm::dot(u, n) + 0.5 * e.bend * glm::dot(u, u) + x * x * x * (e.c3 + e.c4 * x);
}

/// A run of sides through a leaf, from its border to its border: the area on its left.
struct Chain {
  std::array<LeafEdge, 2> edges;
  int count = 1;
  bool any = false;  ///< of two edges: inside either; else inside both
  bool proven = true;

  double value_at(glm::dvec2 p) const {
    const double a = value(edges[0], p);
    if (count == 1) return a;
    const double b = value(edges[1], p);
    return any ? std::min(a, b) : std::max(a, b);
  }
};

class LeafOfOutline {
 public:
  LeafOfOutline(const OutlineForm& form, const Passings& found, glm::dvec2 c, double radius)
      : form_(form), found_(found), c_(c), radius_(radius) {}

  LeafOutline outline(std::vector<LeafEdge>& edges) {
    LeafOutline unproven{.error = kUnproven};
    if (found_.unproven || !collect()) return unproven;
    const glm::dvec2 from = counting_point();
    int winds = winding(form_.path, c_ + from);
    if (count_ == 0)
      return {.rule = is_inside(form_.path.rule, winds) ? EdgeRule::inside : EdgeRule::outside,
              .error = 0.0};
    for (int i = 0; i < count_; ++i) winds -= chains_[std::size_t(i)].value_at(from) < 0.0;
    return count_ == 1 ? of_one(winds, edges) : of_many(winds, edges);
  }

 private:
  static constexpr int kMostChains = 3;

  bool in_leaf(glm::dvec2 p) const { return glm::length(p - c_) <= radius_ * kWide; }

  /// All chains; false where one is too crooked for a leaf of this size.
  bool collect() {
    int used = 0;
    for (int i = 0; i < found_.count; ++i) {
      const Passing& p = found_.list[std::size_t(i)];
      if (p.begins) continue;
      if (!chain_from(p, used)) return false;
    }
    for (const RoundEnd& end : form_.ends) {
      const OutlineSide &from = form_.sides[std::size_t(end.from)],
                        &to = form_.sides[std::size_t(end.to)];
      if (in_leaf(from.end)) continue;  // seen from the side that leads to it
      if (in_leaf(to.begin)) {
        const Passing* second = found_.of(end.to);
        if (!second || second->ends || !round(end, nullptr, second)) return false;
        ++used;
      } else if (!round_alone(end)) {
        return false;
      }
    }
    return used == found_.count;  // else a loop lies in the leaf
  }

  Chain* another() {
    if (count_ == kMostChains) return nullptr;
    chains_[std::size_t(count_)] = {};
    return &chains_[std::size_t(count_++)];
  }

  bool chain_from(const Passing& first, int& used) {
    ++used;
    if (!first.ends) {
      Chain* const chain = another();
      if (chain) chain->edges[0] = edge_of(first.body, first.error);
      return chain;
    }
    const OutlineSide& side = form_.sides[std::size_t(first.side)];
    const Passing* const second = found_.of(side.next);
    if (second) ++used;
    if (side.round_after >= 0) {
      if (second && (!second->begins || second->ends)) return false;
      return round(form_.ends[std::size_t(side.round_after)], &first, second);
    }
    return second && second->begins && !second->ends && corner(first, *second);
  }

  /// Two sides and their joint.
  bool corner(const Passing& a, const Passing& b) {
    Chain* const chain = another();
    if (!chain) return false;
    const glm::dvec2 joint = form_.sides[std::size_t(a.side)].end - c_;
    const glm::dvec2 in = form_.sides[std::size_t(a.side)].end_way,
                     out = form_.sides[std::size_t(b.side)].begin_way;
    const double cross = in.x * out.y - in.y * out.x, dot = glm::dot(in, out);
    chain->edges[0] = edge_of(a.body, std::max(a.error, b.error));
    if (dot > 0.0 && std::abs(cross) < kMostJointTurn) {
      LeafEdge& e = chain->edges[0];
      e.joined = true;
      e.next = b.body;
      const glm::dvec2 way = glm::normalize(in + out);
      e.end_x = float(joint.x), e.end_y = float(joint.y);
      e.along_x = float(way.x), e.along_y = float(way.y);
      return true;
    }
    // Seen from the joint, an arm of arc s turns by at most bend s/2 from its tangent; twice the bend
    // at the foot covers its change. Arms that stay in sectors of their own meet at the joint alone.
    const double turn = std::abs(std::atan2(cross, dot)), sector = std::min(turn, 3.14159 - turn);
    const double sway =
        2.4 * radius_ * (std::abs(double(a.body.bend)) + std::abs(double(b.body.bend)));
    if (!(sway < sector)) return false;
    chain->edges[1] = edge_of(b.body, b.error);
    chain->count = 2;
    chain->any = cross < 0.0;
    return true;
  }

  /// A round end with the sides that lead to it and from it, as far as they are in the leaf: beyond
  /// the leaf tangents stand for them.
  bool round(const RoundEnd& end, const Passing* first, const Passing* second) {
    if (count_ > 0) return false;
    Chain* const chain = another();
    const OutlineSide &from = form_.sides[std::size_t(end.from)],
                      &to = form_.sides[std::size_t(end.to)];
    const auto tangent = [&](glm::dvec2 p, glm::dvec2 way) {
      const glm::dvec2 n = right_of(way), at = p - c_;
      return LeafEdge::Body{float(at.x), float(at.y), float(n.x), float(n.y), 0, 0, 0};
    };
    chain->edges[0] =
        edge_of(first ? first->body : tangent(from.end, from.end_way), first ? first->error : 0.0);
    chain->edges[1] = edge_of(second ? second->body : tangent(to.begin, to.begin_way),
                              second ? second->error : 0.0);
    chain->count = 2;
    const glm::dvec2 axis = glm::normalize(from.end_way - to.begin_way);
    const std::array<glm::dvec2, 2> along{from.end_way, -to.begin_way},
        normal{right_of(axis), -right_of(axis)};
    for (std::size_t i = 0; i < 2; ++i) {
      LeafEdge& e = chain->edges[i];
      e.end_x = float(end.center.x - c_.x), e.end_y = float(end.center.y - c_.y);
      e.along_x = float(along[i].x), e.along_y = float(along[i].y);
      e.other_x = float(along[1 - i].x), e.other_y = float(along[1 - i].y);
      e.end_bend = float(1.0 / end.radius);
      e.end_nx = float(normal[i].x), e.end_ny = float(normal[i].y);
    }
    has_round_ = true;
    return true;
  }

  /// A round end whose joints are both beyond the leaf: a circle, if it comes in.
  bool round_alone(const RoundEnd& end) {
    const glm::dvec2 m = c_ - end.center;
    const double rho = glm::length(m), d = rho - end.radius;
    if (!(std::abs(d) <= radius_ * kWide)) return true;
    // On the arc: left of the way out and right of the way back, seen from the centre; arcs of more
    // than a half turn are not where both are missed.
    const glm::dvec2 out = form_.sides[std::size_t(end.from)].end_way,
                     back = form_.sides[std::size_t(end.to)].begin_way;
    const bool after = glm::dot(m, out) > 0.0, before = glm::dot(m, back) < 0.0;
    const bool wide = out.x * back.y - out.y * back.x < 0.0;  // more than half a turn
    if (wide ? !(after || before) : !(after && before)) return true;
    Chain* const chain = another();
    if (!chain || !(rho > 0.0)) return false;
    const glm::dvec2 n = m / rho;
    chain->edges[0] = edge_of(
        {float(-d * n.x), float(-d * n.y), float(n.x), float(n.y), float(1.0 / end.radius), 0, 0},
        0.0);
    return true;
  }

  /// A point of the leaf, from its centre, that no chain passes close by: where windings are
  /// counted, so that the count and the chains' sides can't contradict each other by a rounding.
  glm::dvec2 counting_point() const {
    if (count_ == 0) return glm::dvec2{0.0};
    constexpr std::array<glm::dvec2, 5> kTries{
        {{0.0, 0.0}, {0.29, 0.11}, {-0.13, 0.31}, {-0.27, -0.17}, {0.19, -0.23}}};
    glm::dvec2 best{0.0};
    double widest = -1.0;
    for (const glm::dvec2 step : kTries) {
      double gap = radius_;
      for (int i = 0; i < count_; ++i)
        gap = std::min(gap, std::abs(chains_[std::size_t(i)].value_at(radius_ * step)));
      if (gap > widest) widest = gap, best = radius_ * step;
    }
    return best;
  }

  LeafOutline take(EdgeRule rule, int winds, std::vector<LeafEdge>& edges) const {
    LeafOutline outline{.rule = rule, .first = int(edges.size()), .winding = winds, .error = 0.0};
    for (int i = 0; i < count_; ++i)
      for (int k = 0; k < chains_[std::size_t(i)].count; ++k) {
        edges.push_back(chains_[std::size_t(i)].edges[std::size_t(k)]);
        outline.error = std::max(outline.error, double(edges.back().error));
      }
    outline.error += form_.error;
    outline.count = int(edges.size()) - outline.first;
    return outline;
  }

  /// `winds`: on the right of the only chain.
  LeafOutline of_one(int winds, std::vector<LeafEdge>& edges) {
    const bool right = is_inside(form_.path.rule, winds),
               left = is_inside(form_.path.rule, winds + 1);
    if (left == right) return {.rule = left ? EdgeRule::inside : EdgeRule::outside, .error = 0.0};
    Chain& chain = chains_[0];
    if (right) {
      if (has_round_) return {.error = kUnproven};
      for (LeafEdge& e : chain.edges) turn_over(e);
      chain.any = !chain.any;
    }
    return take(chain.any && chain.count > 1 ? EdgeRule::any : EdgeRule::all, 0, edges);
  }

  LeafOutline of_many(int winds, std::vector<LeafEdge>& edges) const {
    for (int i = 0; i < count_; ++i)
      if (chains_[std::size_t(i)].count > 1) return {.error = kUnproven};
    const bool nonzero = form_.path.rule == FillRule::nonzero;
    // A stroke between its sides: left of both. (Right of both winds −1 times too, but is nowhere.)
    if (!form_.ends.empty() && count_ == 2 && winds == -1) return take(EdgeRule::all, 0, edges);
    return take(nonzero ? EdgeRule::nonzero : EdgeRule::even_odd, winds, edges);
  }

  const OutlineForm& form_;
  const Passings& found_;
  const glm::dvec2 c_;
  const double radius_;
  std::array<Chain, kMostChains> chains_;
  int count_ = 0;
  bool has_round_ = false;
};

/// Bit i: leaf i may see the box.
std::uint32_t near_box(const Leaves& leaves, const Box2& box) {
  const Box2 wide = grown(box, leaves.radius * kWide);
  std::uint32_t lanes = 0;
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1) {
    const auto i = std::size_t(std::countr_zero(left));
    if (wide.contains({leaves.x[i], leaves.y[i]})) lanes |= 1u << i;
  }
  return lanes;
}

/// A side in all leaves of `lanes`.
void place_side(const OutlineForm& form, int index, const Leaves& leaves, std::uint32_t lanes,
                std::array<Passings, Leaves::kMost>& found) {
  const OutlineSide& side = form.sides[std::size_t(index)];
  Leaves asked = leaves;
  asked.wanted = lanes;
  ParabolaForm parabola = side.form;
  double margin = ParabolaForm::kMargin;
  std::size_t level = 0;
  // Feet lie within arc 2·radius beyond the ends, an outline in a leaf within that of its foot.
  while (level + 1 < OutlineSide::kReaches && 0.5 * margin > 2.83 * leaves.radius)
    margin *= 0.5, ++level;
  parabola.reach = side.reaches[level];
  CurveLeaves at;
  parabola_leaves(parabola, packed_to_front(asked), at);
  const double r = leaves.radius * kWide;
  std::size_t place = 0;
  for (; lanes; lanes &= lanes - 1, ++place) {
    const auto i = std::size_t(std::countr_zero(lanes));
    const glm::dvec2 c{leaves.x[i], leaves.y[i]};
    const bool begins = glm::length(side.begin - c) <= r, ends = glm::length(side.end - c) <= r;
    const bool met = std::abs(at.side[place]) <= r && at.foot[place] >= parabola.lo &&
                     at.foot[place] <= parabola.hi;
    if (!(at.proven >> place & 1u)) {
      if (distance(side.curve, c) <= r) found[i].unproven = true;
      continue;
    }
    if (!(begins || ends || met)) continue;
    const CurveLeaves::Level& l = at.levels[0];
    // Out is the side's right: below the frame's curve if it runs towards +x.
    const double d = -at.side[place];
    const glm::dvec2 n = -glm::dvec2{at.nx[place], at.ny[place]};
    Passing p{index,
              {float(-d * n.x), float(-d * n.y), float(n.x), float(n.y), float(l.bend[place]),
               float(l.c3[place]), float(l.c4[place])},
              l.error[place],
              begins,
              ends};
    if (!side.forwards) turn_over(p.body);
    found[i].add(p);
  }
}

}  // namespace

void outline_leaves(const OutlineForm& form, const Leaves& leaves,
                    std::span<LeafOutline, Leaves::kMost> outlines, std::vector<LeafEdge>& edges) {
  Box2 all;
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1) {
    const auto i = std::size_t(std::countr_zero(left));
    all = around(all, {leaves.x[i], leaves.y[i]});
  }
  all = grown(all, leaves.radius * kWide);
  std::array<Passings, Leaves::kMost> found;
  for (std::size_t i = 0; i < form.sides.size(); ++i) {
    const Box2& box = form.sides[i].box;
    if (common(box, all).empty()) continue;
    if (const std::uint32_t lanes = near_box(leaves, box))
      place_side(form, int(i), leaves, lanes, found);
  }
  for (std::uint32_t left = leaves.wanted; left; left &= left - 1) {
    const auto i = std::size_t(std::countr_zero(left));
    outlines[i] =
        LeafOfOutline(form, found[i], {leaves.x[i], leaves.y[i]}, leaves.radius).outline(edges);
  }
}

}  // namespace mien
