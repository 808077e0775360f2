#pragma once
// Outlines → order, regions and visible fragments: one sweep from the top, as if the picture were
// tilted a little (of two things at one height the left one comes first).
//
// The state is the list of active chains from left to right, the region right of each, and every
// chain's own winding number. THE PERMUTATION IS THE TRUTH: a crossing swaps two neighbours, and looks
// come from the order, so along any row their differences telescope by construction and no rounding
// can travel along a row.
//
// The sweep goes in steps, to the next border of bands or the next height at which chains begin or end. All active
// chains are placed at the lower height at once. Neighbours are proven to be in order over the whole height at which
// they are neighbours, to a tolerance, most of them by their extents alone. Those that are in the other order at the
// lower height cross. Where a proof fails, the step is halved; where that does not help, the place is reported as a
// doubt, and its pixels are resolved by distances.
//
// At the top of a band of 16 rows the order is by places alone, whatever it was above: bands do not depend on each
// other.
//
// Outlines that are cut off at the picture's sides have no order: left of the picture there is one region, right of
// it nothing.
//
// No colours here: the sweep only asks whether two regions look alike (regions.h).

#include "sdf/arrange/piece_run.h"
#include "sdf/arrange/regions.h"
#include "sdf/arrange/sweep_lanes.h"

#include <span>
#include <vector>

namespace mien {

/// A stretch of a piece whose two sides look different.
struct Fragment {
  int piece;
  int left, right;     ///< looks
  double top, bottom;  ///< heights [px], top < bottom
};

/// A place where the order of outlines could not be proven [px].
struct Doubt {
  double left, right, top, bottom;
};

struct SweepStats {
  long pieces = 0, steps = 0, halvings = 0, crossings = 0, forced = 0, regions = 0;
};

/// Sweeps one arrangement after another; keeps its scratch.
class Sweep {
 public:
  static constexpr int kBandRows = 16;

  /// The arrangement between two heights. `regions` has begun with the number of outlines. `order`: how far
  /// neighbours may be out of order [px]. The outlines are referred to.
  void run(const Outlines& outlines, double top, double bottom, Regions& regions,
           double order = kOrder) {
    in_bands_ = false;
    sweep(outlines, top, bottom, regions, order);
  }
  /// The same from a band's top, with fragments that end where their band does.
  void run_in_bands(const Outlines& outlines, int top, int bottom, Regions& regions, double order) {
    in_bands_ = true;
    sweep(outlines, top, bottom, regions, order);
  }

  std::span<const Fragment> fragments() const { return fragments_; }
  /// Those of a band, the first one's number being 0, after run_in_bands().
  std::span<const Fragment> of_band(int band) const {
    const auto first = std::size_t(first_in_band_[std::size_t(band)]);
    return fragments().subspan(first, std::size_t(first_in_band_[std::size_t(band) + 1]) - first);
  }
  /// Of a fragment: one of the outlines', or the picture's left side.
  const OutlinePiece& piece(int i) const {
    return std::size_t(i) < outlines_->pieces.size() ? outlines_->pieces[std::size_t(i)] : side_;
  }
  std::span<const Doubt> doubts() const { return doubts_; }
  const SweepStats& stats() const { return stats_; }

 private:
  friend class SweepProbe;  // plants faults, in tests
  /// A chain that is active, by lane.
  struct Active {
    int chain, outline, turn;
    int above, piece,
        last;  ///< pieces at the upper and the lower height of a step; the chain's last one
    int left_look, right_look;
    int winding;        ///< of its outline, to the left
    bool flips;         ///< whether its outline's inside changes across it
    int shown_piece;    ///< at that height:
    double shown_from;  ///< from what height the looks are as they are
  };
  struct Swap {  ///< of a slot and the next
    double y;
    int number;  ///< in which it was found
    int slot;
    bool proven;  ///< that these two are in order before, and the other way round afterwards
  };
  struct Slopes {
    double least, most;  ///< dx/dy
    long step;           ///< of which
  };

  void sweep(const Outlines& outlines, double top, double bottom, Regions& regions, double order);
  void begin_at(double y);
  void cross_border(double y);
  void end_or_begin(const OutlineEnd& e);
  void start(const OutlineEnd& e);
  void end(const OutlineEnd& e);
  void come(const OutlineEnd& e, bool left);
  void leave(const OutlineEnd& e, bool left);
  int enter(int slot, int chain, int piece, double x, double y);
  void leave_slot(int slot, double y);
  int slot_of(int chain) const;
  void show_left(double y);
  void finish_left(double y);
  void go_to(double y);
  void step(double y, int depth);
  void pass_pieces(double y);
  void stray(int lane, double y);
  bool in_order_until(double y);
  void plan_runs(double y);
  void plan_run(int first, int last, double y);
  void prove_swaps(double y);
  bool stays(int slot, double from, double to, double y);
  bool cheap(int left, int right) const;
  bool hidden(int slot) const;
  const Slopes& slopes(int lane);
  bool gap_goes_one_way(int left, int right);
  void sort_at_border();
  bool belongs_after(int a, int b) const;
  void swap(int slot, double y);
  void force(int slot, double y);
  void show(int slot, double y);
  void finish(int lane, double y);
  bool inside(int outline, int winding) const;
  int winding_left_of(int slot, int outline) const;
  int region_left_of(int slot) const { return slot ? region_[std::size_t(slot) - 1] : left_; }
  Active& at(int slot) { return active_[std::size_t(order_[std::size_t(slot)])]; }
  const Active& at(int slot) const { return active_[std::size_t(order_[std::size_t(slot)])]; }
  PieceRun run_of(int lane) const;
  double x_of_lane(int lane, double at, double y) const;
  int count() const { return int(order_.size()); }
  std::size_t bytes() const;

  const Outlines* outlines_ = nullptr;
  Regions* regions_ = nullptr;
  double y_ = 0, bottom_ = 0, may_differ_ = kOrder;
  OutlinePiece side_{};
  bool in_bands_ = false;
  std::vector<Fragment> fragments_;
  std::vector<int> first_in_band_;
  std::vector<Doubt> doubts_;
  SweepStats stats_;

  SweepLanes lanes_;
  std::vector<Active> active_;  ///< by lane
  std::vector<Slopes> slopes_;  ///< by lane, if they were asked for
  std::vector<int> free_;       ///< lanes
  // By slot, from left to right.
  std::vector<int> order_;   ///< lanes
  std::vector<int> region_;  ///< to the right of each

  // Of a step.
  std::vector<int> passed_;    ///< lanes that go on to another piece within it
  std::vector<int> unproven_;  ///< slots of neighbours whose extents and chords do not tell
  std::vector<int> planned_;   ///< the order as it will be
  std::vector<Swap> swaps_;    ///< from the top down
  std::vector<double> since_;  ///< by slot: since when it and the next will have been neighbours
  std::vector<char> in_run_;   ///< by slot: whether it takes part in a crossing
  std::vector<std::pair<int, int>> runs_;     ///< their first and last slots
  std::vector<double> least_;                 ///< by slot: of the places from there on
  std::vector<std::pair<double, int>> heap_;  ///< crossings of a run
  std::vector<double> met_;                   ///< by slot: where it crosses with the next
  std::vector<Doubt> unsure_;
  double fails_at_ = 0;     ///< a height near which a proof failed
  bool may_halve_ = false;  ///< so that nothing need be doubted yet
  static constexpr long kHalvingsOfPiece = 4;
  long halvings_left_ = 0;  ///< of a band, whatever is above it
  int most_halvings_ = 16;  ///< of a step

  std::vector<int> windings_;  ///< by outline, left of the picture
  int left_ = 0;               ///< the region there
  int left_look_ = 0;
  double left_from_ = 0;  ///< the height since which it has looked so
};

}  // namespace mien
