#pragma once
// What distances to shapes are measured to: the shapes themselves, but for paths whose loops overlap. Those are
// measured to their visible outlines (curve/path_outline.h), found when they are first asked for.

#include <mien/shape.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>

namespace mien {

/// What is kept about a list of shapes, by index. Several threads may ask at once.
class ShapeOutlines {
 public:
  explicit ShapeOutlines(std::size_t shapes);
  ~ShapeOutlines();

  /// The shape at that index, which stays where it is, or its outline.
  const Shape& of(std::size_t index, const Shape& shape) const;

 private:
  struct Kept;

  const std::size_t shapes_;
  mutable std::mutex making_;
  mutable std::unique_ptr<Kept[]> kept_;
  mutable std::atomic<Kept*> of_{nullptr};  ///< by shape, once a path was asked for
};

}  // namespace mien
