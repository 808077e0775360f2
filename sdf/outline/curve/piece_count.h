#pragma once
// A pen that only counts: how many pieces an outline is certain to have. It holds the last few of them and no more.

#include "sdf/outline/outline_loop.h"
#include "sdf/outline/outline_maker.h"

#include <cstddef>

namespace mien {

class PieceCount final : public CurvePen {
 public:
  explicit PieceCount(const OutlineFrame& frame);

  /// The path's fill.
  void add(const Path& path);

  void begin(glm::dvec2 p) override;
  void line(glm::dvec2 to) override;
  void quad(glm::dvec2 control, glm::dvec2 to) override;
  void close() override;

  /// Of all closed loops. A loop that runs back over more of itself than is held counts as nothing, any other as what
  /// OutlineLoop makes of it.
  std::size_t pieces() const { return pieces_; }

 private:
  void forget();

  Map<GridSpace, FaceSpace> map_;
  Outlines held_;  ///< the end of the loop at hand
  OutlineLoop loop_;
  std::size_t before_ = 0;  ///< pieces of that loop before those held
  bool lost_ = false;
  std::size_t pieces_ = 0;
};

}  // namespace mien
