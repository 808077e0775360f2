#include "sdf/shape/shape_distances.h"
#include "lib/base/watch.h"
#include "sdf/shape/curve/path_tree.h"

namespace mien {

struct ShapeDistances::Kept {
  std::atomic<int> asked{0};
  std::atomic<const PathTree*> tree{nullptr};
  std::unique_ptr<const PathTree> own;
};

namespace {

/// About what a distance takes [ns].
std::int64_t cost_of(const Shape& shape) {
  constexpr int kSimple = 30, kEllipse = 150, kCurve = 150, kTapered = 500;
  if (const auto* path = std::get_if<Path>(&shape)) {
    std::size_t sides = 0;
    for (const Path::Loop& loop : path->loops) sides += loop.sides.size();
    return kSimple + kCurve / 2 * std::int64_t(sides);
  }
  if (const auto* line = std::get_if<Polyline>(&shape))
    return kSimple * std::int64_t(line->points.size());
  return std::holds_alternative<TaperedStroke>(shape) ? kTapered
         : std::holds_alternative<QuadStroke>(shape)  ? kCurve
         : std::holds_alternative<Ellipse>(shape)     ? kEllipse
                                                      : kSimple;
}

}  // namespace

ShapeDistances::ShapeDistances(std::size_t shapes) : shapes_(shapes) {}
ShapeDistances::~ShapeDistances() = default;

void ShapeDistances::begin(std::size_t shapes) {
  of_ = nullptr, kept_.reset(), shapes_ = shapes;
}

double ShapeDistances::at(std::size_t index, const Shape& shape, glm::dvec2 p) const {
  const PathTree* const tree = tree_of(index, shape, PathTree::kFewSides);
  if (tree) return tree->distance(p);
  worked(cost_of(shape));
  return distance(shape, p);
}

Outward ShapeDistances::outward(std::size_t index, const Shape& shape, glm::dvec2 p) const {
  // It knows the nearest side's own gradient, where side by side takes three distances.
  constexpr std::size_t kLeastSides = 4;
  if (const PathTree* const tree = tree_of(index, shape, kLeastSides)) return tree->outward(p);
  worked(3 * cost_of(shape));
  const double d = distance(shape, p);
  return {d, way_of_growth(p, d, [&](glm::dvec2 q) { return distance(shape, q); })};
}

const PathTree* ShapeDistances::tree_of(std::size_t index, const Shape& shape,
                                        std::size_t few) const {
  const Path* const path = std::get_if<Path>(&shape);
  if (!path) return nullptr;
  std::size_t sides = 0;
  for (const Path::Loop& loop : path->loops) sides += loop.sides.size();
  if (sides < few) return nullptr;
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
      (sides > 1000 ? kAskedOften / 16 : kAskedOften))
    return nullptr;
  kept.own = std::make_unique<const PathTree>(*path);
  kept.tree.store(kept.own.get(), std::memory_order_release);
  return kept.own.get();
}

}  // namespace mien
