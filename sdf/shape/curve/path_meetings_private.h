#pragma once
// Where the sides of a path meet.

#include <mien/box2.h>
#include <mien/shape.h>

#include "side_crossings_private.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace mien {

/// A place on a side where it meets another one.
struct SideCut {
  std::size_t side;
  double t;
  int place;
};

class PathMeetings {
 public:
  /// Places nearer to each other than `share` of the largest coordinate are one.
  PathMeetings(const Path& path, double share);

  /// Cuts all sides. False if they meet too often.
  bool find();

  double tolerance() const { return tolerance_; }
  /// Sides of some length: of each loop in order, and none of them folds back on itself.
  const std::vector<QuadBezier>& sides() const { return sides_; }
  /// Where a loop's sides end in the list.
  const std::vector<std::size_t>& loop_ends() const { return loop_ends_; }
  /// By side and t. Ends of sides are none.
  const std::vector<SideCut>& cuts() const { return cuts_; }
  const std::vector<glm::dvec2>& places() const { return places_; }
  int begin_of(std::size_t side) const { return begins_[side]; }
  int end_of(std::size_t side) const { return begins_[next_[side]]; }

 private:
  struct Extent {
    Box2 box;
    std::size_t side;
  };
  void add_side(const QuadBezier& side);
  void end_loop(std::size_t first);
  int place_at(glm::dvec2 p);
  void meet(const Extent& a, const Extent& b);
  void end_on(const Extent& ending, const Extent& on, bool swapped);
  bool alike_between(std::size_t i, std::size_t k, const SideCrossing& a,
                     const SideCrossing& b) const;
  void cut(std::size_t side, double t, int place);

  double tolerance_;
  std::vector<QuadBezier> sides_;
  std::vector<std::size_t> loop_ends_;
  std::vector<std::size_t> next_;  ///< by side, in its loop
  std::vector<int> begins_;        ///< by side: a place
  std::vector<SideCut> cuts_;
  std::vector<SideCrossing> contacts_;  ///< of two sides
  std::vector<glm::dvec2> places_;
  std::vector<int> others_;                       ///< by place: another one in its cell; −1: none
  std::unordered_map<std::uint64_t, int> cells_;  ///< one of the places in each
};

}  // namespace mien
