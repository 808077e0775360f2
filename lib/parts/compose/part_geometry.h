#pragma once
// Where things are on one face: numbers, frames and points as the library's files write them.
//
//   number   0.056   or   {"is": 0.056, "adds": {"brow.thickness": 0.056}}
//            {"of": "lid.inner"}                                              a value that a part tells
//   radii    {"radius": "iris.radius", "times": [0.87, 1], "adds": {"iris.size": [0.87, 1]}}    more of the same radius
//   point    [x, y]  or   {"xy": [x, y], "adds": {"jaw": [1, 0]}}             in the frame
//            {"at": "mouth.corner", "plus": [0.03, 0.06]}                     beside a point of the face
//            {"at": {"mouth.corner": 0.8, "head.jaw": 0.2}, "plus": [x, y]}   a weighted sum of such
//
// "adds" counts by how far a number is from its rest, so that every file shows the face at rest.

#include <mien/name_table.h>
#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

#include <array>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien {

/// How much points of a height rise: none up to `from`, all of it from `to` on; between the two `ends` it dies away.
struct PartLift {
  double by = 0;
  double from = 0, to = 1;
  std::optional<std::pair<double, double>> ends;

  double at(double y) const;
};

/// Canonical coordinates to the face's: about `from`, scaled, turned, moved to `to`.
struct PartFrame {
  glm::dvec2 from{0.0}, to{0.0}, scale{1.0};
  double cosine = 1, sine = 0;
  std::vector<PartLift> lifts;

  glm::dvec2 vector(glm::dvec2 v) const;
  glm::dvec2 place(glm::dvec2 p) const;
  double length(double l) const { return l * 0.5 * (scale.x + scale.y); }
};

/// A point that others can be beside, and how deep it lies for the head's turn.
struct PartPoint {
  glm::dvec2 at{0.0};
  std::optional<double> depth;
  bool is_slice = false;  ///< of a feature, "upper_edge/spine/2", which may be moved
};

/// A point of a file, found.
struct FoundPoint {
  /// Slices it moves with: so many of the geometry's rides, from this one on.
  struct Rides {
    std::size_t first = 0, count = 0;
  };
  glm::dvec2 at{0.0};
  std::optional<double> depth;
  Rides rides;
};

/// A slice that a point moves with, and how much.
struct PointRide {
  std::string_view slice;
  double weight;
};

class PartGeometry {
 public:
  PartGeometry(const PartLibrary& library, const Recipe& recipe);

  /// The value that a number of the library's has in this recipe.
  double value(std::string_view number) const;

  /// `family`: whose own numbers may be called without its name.
  double scalar(const Reading& in, const JsonNode& node, std::string_view family) const;
  glm::dvec2 pair(const Reading& in, const JsonNode& node, std::string_view family) const;
  FoundPoint point(const Reading& in, const JsonNode& node, const PartFrame& frame,
                   std::string_view family) const;

  const PartFrame& frame(const Reading& in, const JsonNode& node) const;

  /// Of a point that this has found.
  std::span<const PointRide> rides(const FoundPoint& found) const {
    return std::span(rides_).subspan(found.rides.first, found.rides.count);
  }

  /// Lifts what would hide others, once all parts have told their points: {"between": …, "clears": {"at": "hairline", "frame":
  /// "brow", "by": 0.01, "most": 0.05}} lifts fringes and brims so that a point is so much above the middle of a frame.
  void clear();

  /// Names must outlive this. A point of a name that is known stands for the one before.
  void add_point(std::string_view name, PartPoint point);
  void add_value(std::string_view name, double value) { values_.insert_or_assign(name, value); }

 private:
  double told(const Reading& in, const JsonNode& name) const;
  double value(const LibraryNumber& number) const;
  /// The family's own number of that name, or else a common one.
  const LibraryNumber& number(const Reading& in, const JsonNode& node, std::string_view name,
                              std::string_view family) const;
  /// The members of a point, in the order of its keys.
  using PointMembers = std::array<const JsonNode*, 11>;
  glm::dvec2 pair(const Reading& in, const JsonNode& node, const PointMembers& has,
                  std::string_view family) const;
  template <class Each>
  void each_add(const Reading& in, const JsonNode* adds, std::string_view family,
                Each&& each) const;
  /// A lift of a frame that follows from what it must clear.
  struct Clearance {
    std::string_view frame;
    std::size_t lift;
    const JsonNode* node;
  };
  PartPoint* told_point(std::string_view name);
  struct NamedPoint {
    std::string_view name;
    PartPoint point;
  };
  /// Of that name or anchor's name; null: none.
  const NamedPoint* find_point(std::string_view name) const;
  FoundPoint beside(const Reading& in, const JsonNode& at, std::optional<double> share) const;
  /// What is beside a point of the face, or beside several.
  FoundPoint beside(const Reading& in, const JsonNode& at, const PointMembers& has,
                    const PartFrame& frame, std::string_view family) const;

  const PartLibrary& library_;
  std::vector<double> values_of_numbers_;  ///< in the library's order
  std::map<std::string_view, PartFrame> frames_;
  std::vector<Clearance> clearances_;
  std::vector<NamedPoint> points_;
  NameTable point_of_;  ///< by name
  std::map<std::string_view, double> values_;
  std::vector<std::pair<std::string_view, std::string_view>>
      anchors_;                           ///< other names of points, by name
  mutable std::vector<PointRide> rides_;  ///< of all points found
};

}  // namespace mien
