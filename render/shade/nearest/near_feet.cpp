#include "render/shade/nearest/near_feet.h"
#include "lib/base/monotonic_seconds.h"
#include "lib/base/watch.h"
#include "sdf/csg/combine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

namespace mien {
namespace {

double key(const Spine<double>& s, double t, glm::dvec2 p) {
  return glm::distance(on_spine(s, t), p) - (s.w0 + t * (s.w1 + t * s.w2));
}

Spine<float> seen_from(const Spine<double>& s, glm::dvec2 p) {
  return {float(s.x0 - p.x), float(s.x1),    float(s.x2),    float(s.y0 - p.y), float(s.y1),
          float(s.y2),       float(s.w0),    float(s.w1),    float(s.w2),       float(s.begin_x),
          float(s.begin_y),  float(s.end_x), float(s.end_y), float(s.side)};
}

/// Whether |p − B| − w has no second minimum in t for any p of a disc: |B'|² stays above what the bends of spine
/// and width can take away from it.
bool has_one_foot(const Spine<double>& s, double from, double to, double farthest) {
  double slowest = std::numeric_limits<double>::infinity(), w = 0.0, fastest = 0.0;
  const double dot = s.x1 * s.x2 + s.y1 * s.y2, bend2 = s.x2 * s.x2 + s.y2 * s.y2;
  const double still = bend2 > 0.0 ? std::clamp(-0.5 * dot / bend2, from, to) : from;
  for (const double t : {from, to, still}) {
    const double speed2 = std::pow(s.x1 + 2.0 * t * s.x2, 2) + std::pow(s.y1 + 2.0 * t * s.y2, 2);
    slowest = std::min(slowest, speed2), fastest = std::max(fastest, speed2);
    w = std::max(w, std::abs(s.w1 + 2.0 * t * s.w2));
  }
  const double taken = 2.0 * farthest * (std::sqrt(bend2) + std::abs(s.w2));
  return slowest - taken - w * std::sqrt(fastest) > 0.3 * slowest;
}

/// Whether a line through its ends is as good [px].
bool is_straight(const Spine<double>& s) {
  return std::abs(s.x2) + std::abs(s.y2) < 1e-5;
}

/// How far apart samples may lie [px]: a third of the tile's radius; where the spine turns more tightly than that,
/// close enough for both sides of the bend to be seen, but at least a tenth.
double sample_gap(const Spine<double>& s, double from, double to, double radius) {
  const double dot = s.x1 * s.x2 + s.y1 * s.y2, bend2 = s.x2 * s.x2 + s.y2 * s.y2;
  const double slowest = bend2 > 0.0 ? std::clamp(-0.5 * dot / bend2, from, to) : from;
  const double speed = std::hypot(s.x1 + 2.0 * slowest * s.x2, s.y1 + 2.0 * slowest * s.y2);
  const double turn = 2.0 * std::abs(s.x1 * s.y2 - s.y1 * s.x2);  // |B' x B''|, the same for all t
  const double tightest = speed > 0.0 ? speed * speed * speed / turn : 0.0;
  return turn == 0.0 && speed > 0.0 ? 0.3 * radius
                                    : std::clamp(tightest, 0.1 * radius, 0.3 * radius);
}

constexpr int kSteps = 32;  // in which a spine is searched for what is near
using Keys = std::array<double, kSteps + 1>;

/// The stretch of a spine that may be within `most` of the middle; none if first >= last.
struct Stretch {
  int first = kSteps, last = 0;
};
Stretch stretch_within(double most, const Keys& keys, double apart) {
  Stretch found;
  for (int i = 0; i < kSteps; ++i) {
    const double low = std::min(keys[std::size_t(i)], keys[std::size_t(i) + 1]) - 0.5 * apart;
    if (low > most) continue;
    found.first = std::min(found.first, i), found.last = std::max(found.last, i + 1);
  }
  return found;
}

/// Sets as many samples along [from, to] as the spine's bend asks for.
void place_samples(const Spine<double>& s, double reach, double from, double to, double radius,
                   NearSpine& near) {
  const double count = std::ceil((to - from) * reach / sample_gap(s, from, to, radius)) + 1.0;
  near.samples = int(std::clamp(count, 2.0, near.single ? 4.0 : double(NearSpine::kMostSamples)));
  if (reach == 0.0) near.samples = 1;
  near.first = float(from), near.step = float((to - from) / std::max(1, near.samples - 1));
  near.apart = float(0.5 * reach) * near.step;
}

}  // namespace

void NearFeet::narrow(const FeetArea& area, glm::dvec2 middle, double radius) {
  area_ = &area, middle_ = middle, radius_ = radius;
  leaves_.clear(), spines_.clear();
  tangled_ = false;
  const auto& all = area.area()->nodes();
  if (all.size() < kLargeTree)
    tree_.assign(all.begin(), all.end());
  else
    prune(all, middle - area.center(), radius, tree_);
  for (Node& n : tree_) {
    if (n.op != Op::shape) continue;
    n.b = int(leaves_.size());
    const SpineShape& shape = area.shapes()[std::size_t(n.a)];
    Leaf leaf{std::size_t(n.a), &shape, spines_.size(), 0};
    if (!shape.slow) narrow_shape(shape);
    leaf.count = spines_.size() - leaf.first;
    tangled_ = tangled_ || (shape.crosses && (shape.slow || leaf.count > 1));
    leaves_.push_back(leaf);
  }
}

/// Whether a path's side has its foot at one of its ends, seen from anywhere in the disc, where another side goes
/// on that is equally near.
bool NearFeet::ends_beside(const SpineShape& shape, std::size_t index) const {
  const auto leans = [&](const Spine<double>& s, double t) {
    const glm::dvec2 speed{s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2};
    return std::pair{glm::dot(on_spine(s, t) - middle_, speed), radius_ * glm::length(speed)};
  };
  const auto begins = [&](const Spine<double>& s) {
    const auto [slope, slack] = leans(s, 0.0);
    return slope > slack;
  };
  const Spine<double>& s = shape.spines[index];
  if (begins(s)) return true;
  const auto [slope, slack] = leans(s, 1.0);
  return slope < -slack && !begins(shape.spines[shape.next[index]]);
}

void NearFeet::narrow_shape(const SpineShape& shape) {
  worked(30 * std::int64_t(shape.spines.size()));
  const std::size_t begin = spines_.size();
  // First an upper bound, from a few places of every spine.
  double best = std::numeric_limits<double>::infinity();
  for (const Spine<double>& s : shape.spines)
    for (const double t : {0.0, 0.5, 1.0}) best = std::min(best, key(s, t, middle_));
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 0; k < shape.spines.size(); ++k) {
      const Spine<double>& s = shape.spines[k];
      const double apart = shape.reach[k] / kSteps;
      if (key(s, 0.5, middle_) - 0.5 * shape.reach[k] > best + 2.0 * radius_) continue;
      Keys v;
      for (int i = 0; i <= kSteps; ++i) {
        v[std::size_t(i)] = key(s, double(i) / kSteps, middle_);
        best = std::min(best, v[std::size_t(i)]);
      }
      if (pass == 0) continue;
      const Stretch stretch = stretch_within(best + 2.0 * radius_, v, apart);
      if (stretch.first >= stretch.last) continue;
      NearSpine near{seen_from(s, middle_), 1, 0, 0, false, 0, 0};
      near.least = float(*std::min_element(v.begin(), v.end()) - 0.5 * apart);
      const double from = double(stretch.first) / kSteps, to = double(stretch.last) / kSteps;
      const double widest = std::max({s.w0, s.w0 + 0.5 * s.w1 + 0.25 * s.w2, s.w0 + s.w1 + s.w2});
      const double farthest = std::abs(best) + 3.0 * radius_ + std::abs(widest);
      near.single = has_one_foot(s, from, to, farthest);
      near.line = shape.tree && is_straight(s);
      if (!shape.next.empty() && has_one_foot(s, 0.0, 1.0, farthest) && ends_beside(shape, k))
        continue;
      place_samples(s, shape.reach[k], from, to, radius_, near);
      spines_.push_back(near);
    }
  }
  std::sort(spines_.begin() + std::ptrdiff_t(begin), spines_.end(),
            [](const NearSpine& a, const NearSpine& b) { return a.least < b.least; });
}

void NearFeet::slow_at(std::size_t shape, std::span<const float> x, std::span<const float> y,
                       const Feet& out) const {
  constexpr double kStep = 1e-5, kAside = 1e-3;  // [px]
  const AreaDistance& area = *area_->area();
  const auto distance_at = [&](glm::dvec2 p) { return area.of_shape(shape, p); };
  const auto gradient = [&](glm::dvec2 p, double d) {
    const glm::dvec2 g{distance_at(p + glm::dvec2{kStep, 0.0}) - d,
                       distance_at(p + glm::dvec2{0.0, kStep}) - d};
    const double length = glm::length(g);
    return length > 0.0 ? g / length : glm::dvec2{0.0};
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    worked(1500);
    const glm::dvec2 p = middle_ - area_->center() + glm::dvec2{x[i], y[i]};
    const double d = distance_at(p);
    const glm::dvec2 n = gradient(p, d), along_level{-n.y, n.x}, q = p + kAside * along_level;
    const double bend = glm::dot(gradient(q, distance_at(q)) - n, along_level) / kAside;
    out.d[i] = float(d), out.nx[i] = float(n.x), out.ny[i] = float(n.y);
    out.bend[i] = float(std::clamp(bend, -4.0, 4.0));
  }
}

void NearFeet::shape_at(const Leaf& leaf, std::span<const float> x, std::span<const float> y,
                        const Feet& out) {
  worked(std::int64_t(x.size() * (4 + leaf.count)));
  if (leaf.spines->slow) return slow_at(leaf.shape, x, y, out);
  if (const auto& e = leaf.spines->ellipse) {
    const glm::dvec2 at = e->center - middle_;
    return ellipse_feet({float(at.x), float(at.y), float(e->axis.x), float(e->axis.y),
                         float(e->radii.x), float(e->radii.y)},
                        x, y, out);
  }
  spine_feet(std::span<const NearSpine>{spines_}.subspan(leaf.first, leaf.count),
             leaf.spines->stroke, x, y, out);
  if (leaf.spines->tree) sign_by_windings(*leaf.spines->tree, x, y, out);
}

void NearFeet::sign_by_windings(const PathTree& tree, std::span<const float> x,
                                std::span<const float> y, const Feet& out) const {
  worked(300 * std::int64_t(x.size()));
  // No side lies within a place's distance of it, so places there have its winding number: those of the place before,
  // and of the one before whose distance was the largest.
  struct Known {
    glm::dvec2 at{0.0};
    double around = 0.0;
    bool inside = false;
  } last, wide;
  for (std::size_t i = 0; i < x.size(); ++i) {
    constexpr double kFloats = 1e-3;  // [px] more than distances of floats are off by
    const glm::dvec2 p{x[i], y[i]};
    const auto knows = [&](const Known& k) { return glm::distance(p, k.at) < k.around; };
    last = {p, double(out.d[i]) - kFloats,
            knows(last)   ? last.inside
            : knows(wide) ? wide.inside
                          : tree.inside(middle_ - area_->center() + p)};
    if (!knows(wide) || last.around > wide.around) wide = last;
    const bool inside = last.inside;
    if (!inside) continue;
    out.d[i] = -out.d[i], out.nx[i] = -out.nx[i], out.ny[i] = -out.ny[i];
    out.bend[i] = -out.bend[i];
  }
}

void NearFeet::at(std::span<const float> x, std::span<const float> y, const Feet& out) {
  if (!work_) return combine_at(x, y, out);
  const double begin = monotonic_seconds();
  combine_at(x, y, out);
  work_->distances += (long long)(x.size() * leaves_.size());
  work_->seconds += monotonic_seconds() - begin;
}

void NearFeet::combine_at(std::span<const float> x, std::span<const float> y, const Feet& out) {
  const std::span<const Node> nodes = nodes_around(x, y);
  if (nodes.size() == 1) return shape_at(leaves_[std::size_t(nodes[0].b)], x, y, out);
  const std::size_t n = x.size();
  nodes_.resize(nodes.size() * 4 * n);
  const auto of = [&](std::size_t node) {
    float* first = nodes_.data() + node * 4 * n;
    return Feet{first, first + n, first + 2 * n, first + 3 * n};
  };
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node& node = nodes[k];
    const Feet to = of(k);
    if (node.op == Op::shape) {
      shape_at(leaves_[std::size_t(node.b)], x, y, to);
      continue;
    }
    const Feet a = of(std::size_t(node.a)), b = of(std::size_t(node.b));
    for (std::size_t i = 0; i < n; ++i) {
      const double d = combine(node.op, double(a.d[i]), double(b.d[i]), node.amount);
      const bool uses_b = (node.op == Op::unite && b.d[i] < a.d[i]) ||
                          (node.op == Op::intersect && b.d[i] > a.d[i]) ||
                          (node.op == Op::subtract && -b.d[i] > a.d[i]);
      const Feet& from = uses_b ? b : a;
      const bool turned = node.op == Op::complement || (node.op == Op::shell && a.d[i] < 0.0f) ||
                          (uses_b && node.op == Op::subtract);
      const float sign = turned ? -1.0f : 1.0f;
      to.d[i] = float(d), to.nx[i] = sign * from.nx[i], to.ny[i] = sign * from.ny[i];
      to.bend[i] = sign * from.bend[i];
    }
  }
  const Feet last = of(nodes.size() - 1);
  std::copy_n(last.d, n, out.d), std::copy_n(last.nx, n, out.nx);
  std::copy_n(last.ny, n, out.ny), std::copy_n(last.bend, n, out.bend);
}

}  // namespace mien
