#include <mien/render/tile/near_area.h>

#include <mien/sdf/csg/combine.h>
#include <mien/sdf/distance.h>
#include <mien/sdf/shape/path.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace mien {
namespace {

/// [px] Distances are rounded: what is decided by them is decided with this much to spare, relative
/// to the distance.
constexpr double kSlack = 1e-9;

template <class Visit>
void for_each_closed_side(const Path& path, const Visit& visit) {
  for (const Path::Loop& loop : path.loops) {
    if (loop.sides.empty()) continue;
    glm::dvec2 end = loop.sides.back().p2;
    for (const QuadBezier& side : loop.sides) {
      if (end != side.p0) visit(QuadBezier{end, 0.5 * (end + side.p0), side.p0});
      visit(side);
      end = side.p2;
    }
  }
}

QuadBezier moved(const QuadBezier& c, glm::dvec2 by) {
  return {c.p0 + by, c.p1 + by, c.p2 + by};
}

}  // namespace

void NearArea::narrow(const AreaDistance& area, glm::dvec2 center, double radius) {
  center_ = center, radius_ = radius;
  nodes_.clear(), parts_.clear(), sides_.clear();
  const auto& nodes = area.nodes();
  values_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    values_[i] = n.op == Op::shape ? distance(area.shapes()[std::size_t(n.a)], center)
                                   : combine(n.op, value(n.a), value(n.b), n.amount);
  }
  choose(area);
  place_.assign(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (uses_[i] == Uses::nothing) continue;
    const Node& n = nodes[i];
    const auto placed = [&](int operand) { return place_[std::size_t(operand)]; };
    Node made = n;
    switch (uses_[i]) {
      case Uses::shape:
        made.a = add_shape(area.shapes()[std::size_t(n.a)], values_[i]);
        break;
      case Uses::a_alone:
        place_[i] = placed(n.a);
        continue;
      case Uses::b_alone:
        place_[i] = placed(n.b);
        continue;
      case Uses::not_b:
        made = {.op = Op::complement, .a = placed(n.b), .b = placed(n.b)};
        break;
      default:
        made.a = placed(n.a), made.b = n.b < 0 ? made.a : placed(n.b);
    }
    nodes_.push_back(made);
    place_[i] = int(nodes_.size()) - 1;
  }
  sole_ = place_.back();
}

/// What each node uses of its operands in the disc: users before operands.
void NearArea::choose(const AreaDistance& area) {
  const auto& nodes = area.nodes();
  uses_.assign(nodes.size(), Uses::nothing);
  uses_.back() = Uses::all;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (uses_[i] == Uses::nothing) continue;
    const Node& n = nodes[i];
    Uses& use = uses_[i] = n.op == Op::shape ? Uses::shape : Uses::all;
    if (use == Uses::shape) continue;
    const double a = value(n.a), b = n.op == Op::without ? -value(n.b) : value(n.b);
    const double apart = 2.0 * radius_ + kSlack * (radius_ + std::abs(a) + std::abs(b));
    if (n.op == Op::either) {
      if (a > b + apart) use = Uses::b_alone;
      if (b > a + apart) use = Uses::a_alone;
    } else if (n.op == Op::both || n.op == Op::without) {
      if (a > b + apart) use = Uses::a_alone;
      if (b > a + apart) use = n.op == Op::both ? Uses::b_alone : Uses::not_b;
    }
    const auto need = [&](int operand) {
      if (operand >= 0) uses_[std::size_t(operand)] = Uses::all;
    };
    if (use == Uses::all || use == Uses::a_alone) need(n.a);
    if (use == Uses::all || use == Uses::b_alone || use == Uses::not_b) need(n.b);
  }
}

int NearArea::add_shape(const Shape& shape, double here) {
  Part part{.shape = &shape};
  if (const Path* path = std::get_if<Path>(&shape)) {
    part.path = path;
    part.first = sides_.size();
    const double reach = (std::abs(here) + 2.0 * radius_) * (1.0 + kSlack);
    for_each_closed_side(*path, [&](const QuadBezier& side) {
      if (distance(side, center_) <= reach) sides_.push_back(side);
    });
    part.count = sides_.size() - part.first;
    if (std::abs(here) > radius_ * (1.0 + kSlack)) part.sign = here < 0.0 ? -1.0 : 1.0;
  }
  parts_.push_back(part);
  return int(parts_.size()) - 1;
}

double NearArea::part_at(const Part& part, glm::dvec2 p) const {
  if (!part.path) return distance(*part.shape, p);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = part.first; i < part.first + part.count; ++i)
    nearest = std::min(nearest, distance(sides_[i], p));
  if (part.sign != 0.0) return part.sign * nearest;
  return is_inside(part.path->rule, winding(*part.path, p)) ? -nearest : nearest;
}

double NearArea::at(glm::dvec2 p) const {
  if (nodes_.size() == 1) return part_at(parts_[0], p);
  thread_local std::vector<double> values;
  values.resize(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    values[i] = n.op == Op::shape
                    ? part_at(parts_[std::size_t(n.a)], p)
                    : combine(n.op, values[std::size_t(n.a)], values[std::size_t(n.b)], n.amount);
  }
  return values[std::size_t(sole_)];
}

void NearArea::part_distances(const Part& part, std::span<const float> x, std::span<const float> y,
                              std::span<float> d) {
  const auto one_by_one = [&] {
    for (std::size_t i = 0; i < d.size(); ++i)
      d[i] = float(distance(*part.shape, center_ + glm::dvec2{x[i], y[i]}));
  };
  if (part.path) {
    local_.clear();
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
      local_.push_back(moved(sides_[i], -center_));
    mien::distances(local_, x, y, d);
    for (std::size_t i = 0; i < d.size(); ++i) {
      double sign = part.sign;
      if (sign == 0.0) {
        const glm::dvec2 p = center_ + glm::dvec2{x[i], y[i]};
        sign = is_inside(part.path->rule, winding(*part.path, p)) ? -1.0 : 1.0;
      }
      d[i] *= float(sign);
    }
    return;
  }
  std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Ellipse>) {
          Ellipse local = s;
          local.center -= center_;
          mien::distances(local, x, y, d);
        } else if constexpr (std::is_same_v<S, ParabolaSide>) {
          ParabolaSide local = s;
          local.vertex -= center_;
          mien::distances(local, x, y, d);
        } else if constexpr (std::is_same_v<S, TaperedStroke>) {
          TaperedStroke local = s;
          local.spine = moved(s.spine, -center_);
          mien::distances(local, x, y, d);
        } else if constexpr (std::is_same_v<S, QuadStroke>) {
          mien::distances(moved(s.spine, -center_), x, y, d);
          for (float& v : d) v -= float(s.half_width);
        } else {
          one_by_one();
        }
      },
      *part.shape);
}

void NearArea::distances(std::span<const float> x, std::span<const float> y, std::span<float> d) {
  if (nodes_.size() == 1) return part_distances(parts_[0], x, y, d);
  const std::size_t n = d.size();
  node_values_.resize(nodes_.size() * n);
  const auto of = [&](int node) {
    return std::span<float>{node_values_.data() + std::size_t(node) * n, n};
  };
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    const std::span<float> out = of(int(k));
    if (node.op == Op::shape) {
      part_distances(parts_[std::size_t(node.a)], x, y, out);
      continue;
    }
    const std::span<const float> a = of(node.a), b = of(node.b);
    for (std::size_t i = 0; i < n; ++i)
      out[i] = float(combine(node.op, double(a[i]), double(b[i]), node.amount));
  }
  std::ranges::copy(of(sole_), d.begin());
}

}  // namespace mien
