#pragma once
// Areas' programs as tests by masks that end as soon as the answer is known, as compilers write conditions.
//
// A test asks whether a place is inside or outside of any of some outlines, all bits of one word, and tells which test
// comes next for either answer. Operands that stand next to each other in a union share a test, and by De Morgan those
// of an intersection do, too: a union of twenty strokes cut to a head takes two or three tests.

#include "sdf/outline/area_program.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mien {

class AreaTests {
 public:
  /// Of a program: the test it begins with. Negative: the answer is known, by no test.
  using Start = int;

  void clear() { tests_.clear(); }
  /// Time and memory follow the program's length; programs may be any depth. A program without steps holds everywhere.
  Start add(std::span<const AreaStep> program);
  /// Whether the program's area holds a point, by the bits of its outlines. Counts what it does as work.
  bool holds(Start start, const std::uint64_t* inside) const;

 private:
  static constexpr int kHolds = -1, kFails = -2;
  struct Test {
    std::uint64_t inside, outside;
    int word;
    int if_any, if_none;  ///< a test, kHolds or kFails
  };
  /// Ways out of tests that lead to the same place, as a list through `links_`. Way 2i is that of test i if any of its
  /// outlines holds, 2i + 1 if none does.
  struct Ways {
    int first = -1, last = -1;
  };
  /// An operand's tests reach from `first` to where the next one's begin.
  struct Operand {
    int first;
    Ways if_holds, if_fails;
    bool outline;
  };
  void push_outline(int outline);
  void join(bool all);
  bool share_test(const Operand& a, const Operand& b, bool all);
  void turn(Operand& operand, bool all);
  Ways together(Ways a, Ways b);
  void lead(Ways ways, int to);

  std::vector<Test> tests_;
  std::vector<int> links_;  ///< by way: the list's next
  std::vector<Operand> operands_;
};

}  // namespace mien
