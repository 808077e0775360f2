#pragma once
// Muscles as data: what they are attached to, how hard they pull, and the expressions that pull them.
//
// A muscle is a spring between its fixed origin and points of the face; a pull shortens it by its stroke.
// Another spring ties each of these points to its place at rest (lib/rig/muscle/law.h has the law). Numbers
// other than points (a radius, a width) are held in the same way, each along its own line.

#include <mien/index.h>
#include <mien/side.h>

#include <array>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

namespace mien {

struct Channel;

/// One side of a group, or a muscle that has no side.
struct Muscle {
  std::string_view name;  ///< its group's name: "zygomaticus"; the model's names keep it
  Side side = Side::none;
  glm::dvec2 origin;       ///< on the muscle's own side
  double strength = 0;     ///< [1/s²] stiffness of the spring at full pull, >= 0
  double stroke = 0;       ///< [face units] how much a full pull shortens it, >= 0
  Index<Channel> channel;  ///< sets its pull directly, 0 … 1
};

/// The attachment of a muscle to a point or number.
struct MuscleHold {
  Index<Muscle> muscle;
  double weight;  ///< of the muscle's strength, 0 … 1
  double stroke =
      0;  ///< of a number: how far a full pull would take it, in its own unit; may be negative
};

/// A point that muscles hold.
struct MusclePoint {
  int slice;
  /// The same point of the mirrored feature, if both lie on the axis; −1: none. The two are one point, which
  /// stays on the axis. The muscles of both sides hold it with half their strength.
  int twin = -1;
  std::vector<MuscleHold> holds;
};

/// A number that muscles hold, or the size of a feature.
struct MuscleNumber {
  int slice;
  int component = 0;  ///< of the slice; −1: all of them, scaled by 1 + what the muscles do
  std::vector<MuscleHold> holds;
};

struct MuscleSystem {
  double stiffness = 1;  ///< [1/s²] of the springs to rest, for a unit mass
  double damping = 1;    ///< [1/s]
  std::vector<Muscle> muscles;
  std::vector<MusclePoint> points;
  std::vector<MuscleNumber> numbers;
};

/// The effect of an expression at full strength on one Muscle or Channel. `side` is the half of the
/// expression that counts: left, right, or the mean of both (none).
template <class T>
struct ExpressionPart {
  Index<T> index;
  double amount;
  Side side = Side::none;
  /// Of another expression: the amount is divided by its strength, by 0.1 at least, and is 1 at most; none: it is not.
  Index<Channel> per{};
};

/// What VRM calls procedural expressions: those that others can override.
enum class ExpressionGroup : unsigned char { none, blink, look, mouth };
inline constexpr std::size_t kExpressionGroups = 4;

/// What an expression does to those of a group: nothing, takes its own strength from theirs, or stops them.
enum class Override : unsigned char { none, blend, block };

/// An emotion, or an expression of a standard set: a number from 0 to 1 that pulls muscles and moves controls.
struct Expression {
  std::string_view name;       ///< "emotion.joy", "arkit.jawOpen"; the model's names keep it
  Index<Channel> left, right;  ///< the strength of each half; the same if it has none
  bool binary = false;         ///< its strength is 1 above a half, and else 0
  ExpressionGroup group = ExpressionGroup::none;
  std::array<Override, kExpressionGroups> overrides{};  ///< by group
  std::vector<ExpressionPart<Muscle>> pulls;            ///< 0 … 1
  std::vector<ExpressionPart<Channel>> moves;           ///< in the channels' own units
};

}  // namespace mien
