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

#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
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

/// A point of a file, found. Its names are the geometry's, which must outlive it.
struct FoundPoint {
  glm::dvec2 at{0.0};
  std::optional<double> depth;
  std::vector<std::pair<std::string_view, double>> rides;  ///< slices it moves with, how much
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

  void add_point(std::string name, PartPoint point) {
    points_.insert_or_assign(std::move(name), std::move(point));
  }
  void add_value(std::string name, double value) {
    values_.insert_or_assign(std::move(name), value);
  }

 private:
  double told(const Reading& in, const JsonNode& name) const;
  double value(const LibraryNumber& number) const;
  /// The family's own number of that name, or else a common one.
  const LibraryNumber& number(const Reading& in, const JsonNode& node, std::string_view name,
                              std::string_view family) const;
  template <class Each>
  void each_add(const Reading& in, const JsonNode& node, std::string_view family,
                Each&& each) const;
  FoundPoint beside(const Reading& in, const JsonNode& at, std::optional<double> share) const;

  const PartLibrary& library_;
  std::vector<double> values_of_numbers_;  ///< in the library's order
  std::map<std::string_view, PartFrame> frames_;
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::unordered_map<std::string, PartPoint, Hash, std::equal_to<>> points_;
  std::map<std::string, double, std::less<>> values_;
  std::map<std::string_view, std::string_view> anchors_;  ///< other names of points
};

}  // namespace mien
