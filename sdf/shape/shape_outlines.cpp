#include "sdf/shape/shape_outlines.h"

#include "sdf/shape/curve/path_outline.h"

#include <utility>

namespace mien {

struct ShapeOutlines::Kept {
  std::atomic<const Shape*> outline{nullptr};
  std::unique_ptr<const Shape> own;
};

ShapeOutlines::ShapeOutlines(std::size_t shapes) : shapes_(shapes) {}
ShapeOutlines::~ShapeOutlines() = default;

const Shape& ShapeOutlines::of(std::size_t index, const Shape& shape) const {
  const Path* const path = std::get_if<Path>(&shape);
  if (!path || path->rule == FillRule::even_odd || path->loops.empty()) return shape;
  const Kept* const known = of_.load(std::memory_order_acquire);
  if (const Shape* made = known ? known[index].outline.load(std::memory_order_acquire) : nullptr)
    return *made;
  // The others wait for it: pictures do not depend on who asks first.
  const std::lock_guard lock(making_);
  if (!kept_) kept_ = std::make_unique<Kept[]>(shapes_);
  Kept& kept = kept_[index];
  if (!kept.outline.load(std::memory_order_relaxed)) {
    if (std::optional<Path> outline = visible_outline(*path))
      kept.own = std::make_unique<const Shape>(*std::move(outline));
    kept.outline.store(kept.own ? kept.own.get() : &shape, std::memory_order_release);
  }
  of_.store(kept_.get(), std::memory_order_release);
  return *kept.outline.load(std::memory_order_relaxed);
}

}  // namespace mien
