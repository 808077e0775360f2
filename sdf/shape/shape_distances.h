#pragma once
// Distances to shapes that are asked many times: a path of many sides gets its tree (path_tree.h) when it turns out
// to be one.

#include <mien/shape.h>
#include "sdf/shape/outward.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>

namespace mien {

class PathTree;

/// What is kept about a list of shapes, by index. Several threads may ask at once.
class ShapeDistances {
 public:
  explicit ShapeDistances(std::size_t shapes = 0);
  ~ShapeDistances();

  /// Questions after which a tree is made: about as many as one costs. Of long paths fewer.
  static constexpr int kAskedOften = 64;

  /// Forgets all; there are so many shapes now.
  void begin(std::size_t shapes);

  /// distance(shape, p), of the shape at that index.
  double at(std::size_t index, const Shape& shape, glm::dvec2 p) const;
  /// With its gradient: of a path with a tree that of the nearest side alone.
  Outward outward(std::size_t index, const Shape& shape, glm::dvec2 p) const;

 private:
  struct Kept;
  /// Null: it has fewer sides than `few`, or was not asked often yet.
  const PathTree* tree_of(std::size_t index, const Shape& shape, std::size_t few) const;

  std::size_t shapes_;
  mutable std::mutex making_;
  mutable std::unique_ptr<Kept[]> kept_;
  mutable std::atomic<Kept*> of_{nullptr};  ///< by shape, once one of many sides was asked for
};

}  // namespace mien
