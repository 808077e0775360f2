#pragma once
// Outlines → order, regions and visible fragments: one sweep from the top, as if the picture were
// tilted a little (of two things at one height the left one comes first).
//
// The state is the list of active pieces from left to right, the region right of each, and every
// piece's own winding number. THE PERMUTATION IS THE TRUTH: an event swaps two neighbours, and looks
// come from the order, so along any row their differences telescope by construction and no rounding
// can travel along a row. A wrong order heals when its pieces are next compared.
//
// Neighbours are proven to be in order over the whole height at which they are neighbours, to a tolerance. Where
// the proof fails, the place is reported as a doubt, and its pixels are resolved by distances.
//
// Outlines that are cut off at the picture's sides have no order: left of the picture there is one region, right of
// it nothing.
//
// No colours here: the sweep only asks whether two regions look alike (regions.h).

#include "sdf/arrange/crossings.h"
#include "sdf/arrange/order_proof.h"
#include "sdf/arrange/regions.h"

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
  long pieces = 0, pairs = 0, crossings = 0, forced = 0, proofs = 0, regions = 0;
};

/// Sweeps one arrangement after another; keeps its scratch.
class Sweep {
 public:
  /// The arrangement between two heights. `regions` has begun with the number of outlines. `order`: how far
  /// neighbours may be out of order [px].
  void run(const Outlines& outlines, double top, double bottom, Regions& regions,
           double order = kOrder);

  /// Ordered by their ends.
  std::span<const Fragment> fragments() const { return fragments_; }
  std::span<const SweepPiece> pieces() const { return pieces_; }
  std::span<const Doubt> doubts() const { return doubts_; }
  const SweepStats& stats() const { return stats_; }

 private:
  struct Event {  ///< `left` swaps with `right`
    double y, x;
    int left, right;
    int order;     ///< in which events were found
    bool one_way;  ///< proven: they are in order before, and the other way round afterwards
  };
  static bool later(const Event& a, const Event& b);

  void sort_vertices();
  void begin_at_top();
  /// Where pieces end, begin, or follow each other.
  struct Vertex {
    double y, x;
    int above, below;  ///< pieces; −1: none
    int end;           ///< of the outlines; −1: it is within a chain
  };
  void vertex(const Vertex& v);
  void end_or_begin(const OutlineEnd& e);
  void leave(int i, bool left, double y);
  void come(int i, bool left, double y);
  void show_left(double y);
  void go_on(int old, int now, double y);
  void start(int a, int b, const OutlineEnd& v);
  void end(int a, int b, const OutlineEnd& v);
  void events_until(double y, double x);
  void swap(int slot, double y, bool one_way = false);
  void swap_past(const Event& event, int from, int to);
  void meet_others(int slot, double y, int first_slot, int met = -1);
  void meet(int left, int right, double y);
  void compare(int a, int b, double y);
  void schedule(double y, int left, int right, bool one_way);
  void put(int slot, int piece);
  void enter(int slot, double y);
  void show(int slot, double y);
  void finish(int slot, double y);
  bool inside(int outline, int winding) const;
  std::size_t bytes() const;
  void tell_work();
  /// Tells it now and then.
  void step() {
    constexpr int kOften = 16;
    if (++since_told_ % kOften == 0) tell_work();
  }
  int region_left_of(int slot) const { return slot ? region_[std::size_t(slot) - 1] : left_; }
  int winding_left_of(int slot, int outline);
  void open_slots(int slot, int more);
  void close_slots(int slot, int fewer);
  SweepPiece& piece(int i) { return pieces_[std::size_t(i)]; }
  SweepPiece& at(int slot) { return pieces_[std::size_t(active_[std::size_t(slot)])]; }
  void room_for(int slots);
  void parted(int slot, double y);

  const Outlines* outlines_ = nullptr;
  Regions* regions_ = nullptr;
  double top_ = 0, bottom_ = 0, may_differ_ = kOrder;
  std::vector<SweepPiece> pieces_;
  std::vector<Fragment> fragments_;
  std::vector<Doubt> doubts_;
  SweepStats stats_;
  SweepStats told_;       ///< what the watch knows
  int told_regions_ = 0;  ///< likewise
  int since_told_ = 0;    ///< steps of the sweep
  int since_held_ = 0;    ///< times since it was told what is held

  // By slot, from left to right.
  int count_ = 0;
  std::vector<int> active_;              ///< pieces
  std::vector<int> region_;              ///< to the right of each
  std::vector<float> lowest_, highest_;  ///< their reach along x
  std::vector<double> together_;    ///< the height since which it and the next have been neighbours
  std::vector<std::uint64_t> met_;  ///< a bit by slot, scratch

  std::vector<Event> events_;  ///< a heap, the first on top
  int found_ = 0;
  std::vector<std::pair<int, int>> again_;  ///< to be compared again
  long again_left_ = 0;
  std::vector<Vertex> vertices_;  ///< from the top down
  std::vector<int> windings_;         ///< by outline, left of the picture
  int left_ = 0;                      ///< the region there
  int left_look_ = 0;
  double left_from_ = 0;  ///< the height since which it has looked so
};

}  // namespace mien
