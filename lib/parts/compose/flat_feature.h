#pragma once
// Features of parts as features of a face file: points in the face's own coordinates, paints by role, and what the rig
// has to know of them.

#include "lib/file/json/tree_writer.h"
#include "lib/parts/compose/part_geometry.h"
#include "lib/parts/compose/part_style.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace mien {

/// A slice that moves with another one.
struct Ride {
  std::string slice;
  double weight;
  int side;       ///< 1 left, −1 right: the muscle of that side only; 0: as it is
  glm::dvec2 at;  ///< its place
};

/// What parts drew, bottom to top after sorting, and what moves with what.
struct FlatFeatures {
  struct One {
    std::size_t slot;
    std::int32_t node;  ///< of the tree that it was written to
    std::string name;
    std::string_view role = {};
    std::string_view side = {};  ///< "both", "left", "right"; empty: none
    std::size_t order = 0;       ///< of drawing, then by slot; even: before a slot, of a figure
  };
  std::vector<One> features;
  bool by_style = false;  ///< what is composed now is the style's own
  std::set<std::string, std::less<>> names;
  std::vector<std::pair<std::string, double>> flat, raised, plates;  ///< depths for the head's turn
  std::vector<std::string> still;
  std::set<std::string, std::less<>> sided;                     ///< features on both sides
  std::map<std::string, std::vector<Ride>, std::less<>> rides;  ///< by the slice they move with
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
