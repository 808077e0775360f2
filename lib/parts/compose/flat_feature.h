#pragma once
// Features of parts as features of a face file: points in the face's own coordinates, paints by role, and what the rig
// has to know of them.

#include <mien/name_table.h>
#include "lib/file/json/tree_writer.h"
#include "lib/parts/compose/part_geometry.h"
#include "lib/parts/compose/part_style.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A slice that moves with another one.
struct Ride {
  std::string_view slice;
  double weight;
  int side;       ///< 1 left, −1 right: the muscle of that side only; 0: as it is
  glm::dvec2 at;  ///< its place
  int next = -1;  ///< the next one with the same slice
};

/// How deep something lies for the head's turn.
struct Depth {
  std::string_view name;
  double depth;
};

/// What parts drew, bottom to top after sorting, and what moves with what. All names are the tree's that it is written to.
class FlatFeatures {
 public:
  struct One {
    std::size_t slot;
    std::int32_t node;  ///< of the tree that it was written to
    std::string_view name;
    std::string_view role = {};
    std::string_view side = {};  ///< "both", "left", "right"; empty: none
    std::size_t order = 0;       ///< of drawing, then by slot; even: before a slot, of a figure
    bool still = false;
    /// Features that it is drawn inside of: the first two.
    std::array<std::string_view, 2> clips = {};

    bool sided() const { return !side.empty(); }
  };
  std::vector<Depth> flat, raised, plates;
  bool by_style = false;  ///< what is composed now is the style's own

  const std::vector<One>& all() const { return features_; }
  /// Null: none.
  const One* find(std::string_view name) const;
  /// The name must be new.
  void add(One feature);
  void stand_still(std::string_view feature);
  /// What stands still while the head turns, in the order it was said.
  const std::vector<std::string_view>& still() const { return still_; }
  /// Bottom to top; those of one slot that are drawn together stay in their order.
  void sort();

  void add_ride(std::string_view with, Ride ride);
  /// Calls each(Ride) for what moves with a slice, in the order it was added. Whether there is any.
  template <class Each>
  bool for_each_ride(std::string_view with, Each&& each) const {
    const int known = ridden_of_.find(with, [&](int i) { return ridden_[std::size_t(i)].slice; });
    if (known < 0) return false;
    for (int i = ridden_[std::size_t(known)].first; i >= 0; i = rides_[std::size_t(i)].next)
      each(rides_[std::size_t(i)]);
    return true;
  }

 private:
  struct Ridden {
    std::string_view slice;
    int first, last;  ///< of its rides
  };
  std::vector<One> features_;
  NameTable feature_of_;  ///< by name
  std::vector<std::string_view> still_;
  std::vector<Ridden> ridden_;
  NameTable ridden_of_;  ///< by slice
  std::vector<Ride> rides_;
};

/// Whether it is only known, of a figure that is drawn later.
inline bool is_ahead(const FlatFeatures::One& one) {
  return one.order % 2 == 0;
}

/// As the face has it: "ear.left", "ear.right".
std::vector<std::string> names_of(const FlatFeatures::One& one);

/// The order of drawing.
inline bool drawn_before(const FlatFeatures::One& a, const FlatFeatures::One& b) {
  return a.order != b.order ? a.order < b.order : a.slot < b.slot;
}

/// The place of a slot, by its name, among the library's. Refuses unknown ones.
std::size_t slot_named(const Reading& in, const JsonNode& wanted, const PartLibrary& library);
/// The same by a name that stands in a node.
std::size_t slot_named(const Reading& in, std::string_view name, const JsonNode& at,
                       const PartLibrary& library);

/// Writes a feature of a part to `out` and adds what is known of it to `to`. Its points become known to `geometry`.
void flatten_feature(const Reading& in, const JsonNode& node, std::string_view family,
                     const PartLibrary& library, const PartStyle& style, PartGeometry& geometry,
                     FlatFeatures& to, TreeWriter& out);

}  // namespace mien
