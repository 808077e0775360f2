#pragma once
// A mouth as a system: a jaw, two lips that can always meet, teeth and a tongue. Plain data; lib/rig/mouth moves it.
//
// The inner edges of the lips run between the same two corners, so an edge is its bends. An edge has one bend, between
// the corners, or three: a handle, a middle on the curve, and a handle. "Left" is the subject's left.

#include <mien/index.h>

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace mien {

struct Channel;

/// What a mouth can do. Each is a control of its face (MouthControl).
enum class MouthAct : unsigned char {
  jaw_open,
  jaw_aside,
  jaw_forward,
  close,
  part,
  pucker,
  funnel,
  stretch,
  aside,
  press,
  roll_upper,
  roll_lower,
  shrug_upper,
  shrug_lower,
  dimple,
  puff,
  bite,
  tongue_up,
  tongue_between,
  tongue_out,
  tongue_wide,
  tongue_back
};
inline constexpr std::size_t kMouthActs = std::size_t(MouthAct::tongue_back) + 1;

/// The control of an act. It goes from `least` to 1 and rests at 0; one with sides has a left and a right half.
struct MouthControl {
  std::string_view name;
  double least;
  bool sided;
};

/// In the order of MouthAct.
inline constexpr std::array<MouthControl, kMouthActs> kMouthControls{{
    {"jaw.open", 0, false},          {"jaw.aside", -1, false},
    {"jaw.forward", 0, false},       {"mouth.close", 0, false},
    {"mouth.part", 0, false},        {"mouth.pucker", 0, false},
    {"mouth.funnel", 0, false},      {"mouth.stretch", 0, true},
    {"mouth.aside", -1, false},      {"mouth.press", 0, true},
    {"mouth.roll_upper", 0, false},  {"mouth.roll_lower", 0, false},
    {"mouth.shrug_upper", 0, false}, {"mouth.shrug_lower", 0, false},
    {"mouth.dimple", 0, true},       {"mouth.puff", 0, false},
    {"mouth.bite", 0, false},        {"tongue.up", 0, false},
    {"tongue.between", 0, false},    {"tongue.out", 0, false},
    {"tongue.wide", 0, false},       {"tongue.back", 0, false},
}};

/// A point that is written once, or twice where the features of both sides share it; −1: once.
struct MouthPoint {
  int slice = -1, twin = -1;
};

/// The bends of one inner edge: left handle, middle, right handle; of an edge with one bend the middle alone.
using MouthEdge = std::array<MouthPoint, 3>;

/// A point of a painted lip. It keeps its place beside a bend of an edge.
struct LipPoint {
  int slice;
  bool upper;
  int bend;  ///< of the edge
};

/// How thick a painted lip is.
struct LipWidth {
  int slice;
  bool upper;
  int side;  ///< 0: left, 1: right, 2: both
};

/// How a point goes with the jaw: shares of the drop at full opening, of the way aside, and of the drop towards the axis.
struct JawShare {
  int slice;
  double down, aside, in;
};

/// How far full cheeks move a point.
struct CheekSwell {
  int slice;
  glm::dvec2 by;
};

/// A point that moves with others by shares of their ways.
struct MouthRider {
  struct With {
    int slice;
    double share;
  };
  int slice;
  std::vector<With> with;
  bool stiff = false;  ///< follows corners that go in or down by a third, as a moustache does
};

struct MouthTongue {
  int center = -1, radii = -1;          ///< slices of its body, an ellipse; −1: the face has none
  int tip_center = -1, tip_radii = -1;  ///< of its tip before the teeth
  std::vector<int> out;                 ///< the seven bends of a tongue that is out
  int out_opacity = -1;
  std::vector<int> groove;  ///< the three points of a line along it
  int groove_opacity = -1;
};

struct Mouth {
  std::array<MouthPoint, 2> corners;  ///< left, right
  MouthEdge upper, lower;
  bool has_handles = false;
  double seam =
      0.32;  ///< where lips meet: 0 at the upper edge, 1 at the lower; the corners' share of the jaw, too
  double width = 1;  ///< of the face [face units]; lengths of the laws are shares of it
  double drop = 0;   ///< of the lower lip at full opening [face units]
  std::optional<glm::dvec2> under;  ///< the nose's base, which the upper lip stays below
  int open = -1;                    ///< slice: how far muscles open the jaw, a ratio
  std::vector<LipPoint> lip_points;
  std::vector<LipWidth> lip_widths;
  /// Three bends in a row of the upper teeth's edge; −1: the face has no teeth.
  std::array<int, 3> teeth_edge{-1, -1, -1};
  std::vector<int> skull_teeth;  ///< points of what belongs to the skull
  std::vector<JawShare> jaw;
  std::vector<CheekSwell> cheeks;
  MouthTongue tongue;
  std::vector<MouthRider> riders;
  /// The channels of each act: both halves, or twice the same.
  std::array<std::array<Index<Channel>, 2>, kMouthActs> channels;
  std::vector<Index<Channel>> speech;  ///< the strengths of visemes
};

}  // namespace mien
