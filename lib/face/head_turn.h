#pragma once
// A head as a body: the depth of each feature, and the channels that turn it. Plain data;
// lib/rig/pose/head_turn.h turns it.

#include <mien/index.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace mien {

/// How a slice follows a turning head.
enum class TurnKind : unsigned char {
  still,    ///< not at all
  surface,  ///< a point of the head's front, `depth` above it: turned, and foreshortened
  flat,     ///< a point of something that looks the same from every side (an outline), at `depth`
            ///< from the head's middle: shifted by parallax, not foreshortened
  plate,    ///< a point of a flat plate at `depth` from the head's middle: turned as one rigid body
  width,    ///< radii at a point: the first is foreshortened sideways, the second upwards
  size,     ///< a radius at a point: foreshortened by the geometric mean of both
  shift,    ///< x, y of an offset on the surface: foreshortened and rolled
  plate_width,  ///< radii on a plate
  plate_size,   ///< a radius on a plate: foreshortened by the geometric mean of both
  body,         ///< a point of shoulders and neck: it follows the yaw by a share
  length,       ///< lengths that no turn changes: they grow as a head comes nearer
  angle         ///< an angle of something on the head: rolled
};

struct TurnedSlice {
  int slice;
  TurnKind kind;
  double depth = 0;  ///< [face units] towards the viewer
  int at = -1;       ///< for width, size and shift: the slice of the point where it is
};

struct Channel;

/// Shoulders that follow a head's yaw: they turn about the same upright axis, and their front is a round of these half-axes.
struct TurnedBody {
  double share = 0;
  glm::dvec2 radii{1};  ///< sideways and towards the viewer; > 0
};

/// The front of the head is half an ellipsoid. A head without slices does not turn.
struct HeadTurn {
  glm::dvec3 pivot{0};   ///< what it turns about; z 0 is the ellipsoid's middle
  glm::dvec2 center{0};  ///< of the ellipsoid, in the picture
  glm::dvec3 radii{1};   ///< > 0
  /// How deep the skull is behind the ellipsoid's middle. With one the yaw is outermost, so eyes stay level, and outlines are
  /// those of a head: longer behind, hollow at the far temple. 0: the pitch is outermost, and outlines stay.
  double skull = 0;
  TurnedBody body;
  Index<Channel> yaw, pitch, roll;  ///< [degrees]
  Index<Channel> nearer;            ///< how much larger the head is seen, a ratio
  std::vector<TurnedSlice> slices;
};

}  // namespace mien
