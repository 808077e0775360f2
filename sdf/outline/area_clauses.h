#pragma once
// An area's program as clauses: a conjunction of disjunctions of outlines, such as a union of strokes cut to a head.
// Then a region is tested by masks instead of step by step.

#include "sdf/outline/area_program.h"

#include <span>
#include <vector>

namespace mien {

/// Reads programs; keeps its scratch.
class AreaClauses {
 public:
  /// False where the program, or its `opposite`, is no conjunction of disjunctions as it stands (opposites of either
  /// are turned inwards). The opposite of a union of areas that are conjunctions is one.
  bool read(std::span<const AreaStep> program, bool opposite = false);

  /// Outlines, or ~outline where a place is to be outside, clause after clause.
  std::span<const int> literals() const { return literals_; }
  bool begins(std::size_t literal) const { return begins_[literal] != 0; }

 private:
  enum class Kind : unsigned char { literal, any, all };
  /// Of an operand: its literals reach from `first` to where the next one's begin.
  struct Part {
    Kind kind;
    std::size_t first;
  };
  bool turn_around(Part& part);

  std::vector<int> literals_;
  std::vector<char> begins_;
  std::vector<Part> parts_;
};

}  // namespace mien
