#pragma once
// Outlines as chains: closed loops cut where they turn up or down, each chain a run of quadratic pieces that goes down
// the picture (y down), each piece monotone in x and in y, on the grid of the whole picture's pixels.
//
// An outline is what one winding number counts: it is inside where the sum over its loops is not 0,
// or odd (see FillRule). Neighbouring pieces share their ends bit for bit, so loops are closed
// exactly and no rounding can open them.

#include <mien/shape.h>

#include <cmath>
#include <utility>
#include <vector>

namespace mien {

/// The curve (x, y)(t) = (x0, y0) + t (2 (ax, ay) + t (bx, by)), t in [0, 1], from (x0, y0) to
/// (x1, y1). It runs down the picture: y0 <= y1, x0 < x1 where y0 == y1; its control point
/// (x0 + ax, y0 + ay) lies in the box of its ends, so x and y are monotone. A straight piece has
/// bx = by = 0 exactly. Ends are multiples of 2⁻²⁰ px.
struct OutlinePiece {
  double x0, y0, ax, ay, bx, by, x1, y1;
  bool operator==(const OutlinePiece&) const = default;
};

/// Pieces one below the other: each begins where the one before ends.
struct OutlineChain {
  int first, last;  ///< pieces, from the top down
  int outline;      ///< whose winding number it changes
  int turn;         ///< winding number to its right minus that to its left: +1 or −1
};

/// Where chains of a loop begin or end: two at a turn of the loop, or one where the loop comes from beyond a side of
/// the picture or leaves through it.
struct OutlineEnd {
  double y, x;
  int chain;
  int other;    ///< the second chain; −1: the loop passes through the side at x
  bool begins;  ///< they begin here and lie below
};

/// Every chain begins at one of the ends and ends at another one.
struct Outlines {
  std::vector<OutlinePiece> pieces;
  std::vector<OutlineChain> chains;
  std::vector<OutlineEnd> ends;  ///< from the top down, those of one height from the left
  std::vector<FillRule> rules;   ///< by outline
  /// By outline: where its chains and its part of `turns`, the ends outline by outline, begin.
  struct Start {
    int chain, turn;
  };
  std::vector<Start> starts;
  std::vector<OutlineEnd> turns;
  /// [px] The picture's sides, where outlines are cut. What runs along them is no part of a chain.
  double left = -HUGE_VAL, right = HUGE_VAL;

  void clear() {
    pieces.clear(), chains.clear(), ends.clear(), rules.clear(), starts.clear(), turns.clear();
  }
  void begin(FillRule rule) {
    rules.push_back(rule), starts.push_back({int(chains.size()), int(turns.size())});
  }
  /// Some of another's outlines after these.
  void add(const Outlines& other, int first, int end);
  /// Sorts the ends. Nothing is added afterwards.
  void finish();
  /// The heights that an outline lies in; the first is the greater one where it has no piece.
  std::pair<double, double> heights(int outline) const;

 private:
  Start end_of(int outline) const {
    return std::size_t(outline) + 1 < starts.size() ? starts[std::size_t(outline) + 1]
                                                    : Start{int(chains.size()), int(turns.size())};
  }
};

}  // namespace mien
