#include "sdf/shape/shape_distances.h"
#include "lib/base/watch.h"
#include "sdf/shape/curve/path_tree.h"

#include "curve/path_sides_private.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

struct ShapeDistances::Kept {
  std::atomic<int> asked{0};
  std::atomic<const PathTree*> tree{nullptr};
  std::unique_ptr<const PathTree> own;
};

ShapeDistances::ShapeDistances(std::size_t shapes) : shapes_(shapes) {}
ShapeDistances::~ShapeDistances() = default;

void ShapeDistances::begin(std::size_t shapes) {
  of_ = nullptr, kept_.reset(), shapes_ = shapes;
}

double ShapeDistances::at(std::size_t index, const Shape& shape, glm::dvec2 p) const {
  const PathTree* const tree = tree_of(index, shape);
  return tree ? tree->distance(p) : distance(shape, p);
}

Outward ShapeDistances::outward(std::size_t index, const Shape& shape, glm::dvec2 p) const {
  // [of coordinates' unit] Distances are good to 1e-12 of it, and bend by less than 1 over themselves.
  constexpr double kStep = 1e-5;
  const auto grows = [&](double d, const auto& at) {
    const glm::dvec2 by{at({p.x + kStep, p.y}) - d, at({p.x, p.y + kStep}) - d};
    const double length = glm::length(by);
    return length > 0.0 ? by / length : glm::dvec2{0.0};
  };
  const PathTree* const tree = tree_of(index, shape);
  const PathTree::Nearest found = tree ? tree->nearest(p) : PathTree::Nearest{0.0, nullptr};
  if (!found.side) {
    const double d = at(index, shape, p);
    return {d, grows(d, [&](glm::dvec2 q) { return at(index, shape, q); })};
  }
  const double away = std::abs(found.distance);
  const glm::dvec2 way = grows(away, [&](glm::dvec2 q) { return distance_to_side(*found.side, q); });
  return {found.distance, found.distance < 0.0 ? -way : way};
}

const PathTree* ShapeDistances::tree_of(std::size_t index, const Shape& shape) const {
  const Path* const path = std::get_if<Path>(&shape);
  if (!path) return nullptr;
  std::size_t sides = 0;
  for (const Path::Loop& loop : path->loops) sides += loop.sides.size();
  if (sides < PathTree::kFewSides) return nullptr;
  Kept* of = of_.load(std::memory_order_acquire);
  if (!of) {
    const std::lock_guard lock(making_);
    if (!kept_) kept_ = std::make_unique<Kept[]>(shapes_);
    of_.store(of = kept_.get(), std::memory_order_release);
  }
  Kept& kept = of[index];
  if (const PathTree* tree = kept.tree.load(std::memory_order_acquire)) return tree;
  // One thread makes it; the others go on side by side.
  if (kept.asked.fetch_add(1, std::memory_order_relaxed) !=
      (sides > 1000 ? kAskedOften / 16 : kAskedOften)) {
    worked(4 * std::int64_t(sides));
    return nullptr;
  }
  kept.own = std::make_unique<const PathTree>(*path);
  kept.tree.store(kept.own.get(), std::memory_order_release);
  return kept.own.get();
}

}  // namespace mien
