#pragma once
// Motions: named channels over time, each a sum of curves. A clip of a face file is one, a take of an actor is one, and so
// is a track of speech. A motion is a pure function of time.

#include <mien/index.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace mien {

/// How a curve goes from one key to the next; u is the share of the time between them.
enum class Ease : unsigned char {
  linear,
  step,      ///< stays, and jumps at the next key
  smooth,    ///< starts and stops softly: 3u² − 2u³
  in,        ///< starts softly: u²
  out,       ///< stops softly: 1 − (1−u)²
  overshoot  ///< goes a tenth too far, and back: 1 + 2.70158 (u−1)³ + 1.70158 (u−1)²
};

struct CurveKey {
  double time;  ///< [s]
  double value;
  Ease ease = Ease::linear;  ///< towards the next key
};

/// A curve through keys, held before the first and after the last.
struct KeyCurve {
  std::vector<CurveKey> keys;  ///< times rising; at least 1
  double period = 0;           ///< [s] time is taken modulo this; 0: once only
  double offset = 0;           ///< [s] later by this
  double jitter = 0;           ///< [s] each period later by a random part of this; needs a period
  std::uint32_t seed = 0;
};

/// offset + amplitude · sin(frequency · t + phase), or · |sin …|
struct SineCurve {
  double amplitude = 1;
  double frequency = 1;  ///< [rad/s]
  double phase = 0;      ///< [rad]
  double offset = 0;
  bool absolute = false;
};

/// Saccades: rests at a random value for each period and moves quickly to the next. Curves of one seed move
/// at the same times and are home together; `stream` gives them different values.
struct WanderCurve {
  double center = 0;
  double amplitude = 1;  ///< values lie within center ± amplitude
  double home = 0;       ///< share of the periods spent at the centre, 0 … 1
  double period = 1;     ///< [s] > 0
  double jitter = 0;     ///< [s] each move later by a random part of this
  double move = 0.05;    ///< [s] a move takes; jitter + move <= period
  double offset = 0;     ///< [s] later by this
  Ease ease = Ease::smooth;
  std::uint32_t seed = 0;
  std::uint32_t stream = 0;
};

/// Moments with a number for each of some columns, as cameras and programs write them.
struct SampleTable {
  std::vector<double> times;  ///< [s] rising; at least 1
  std::size_t columns = 0;
  std::vector<float> values;  ///< row by row

  float at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// A column of a table, linear between rows and held before the first and after the last.
struct SampledCurve {
  std::shared_ptr<const SampleTable> table;  ///< never null; shared by the curves of its columns
  std::size_t column = 0;
};

using Curve = std::variant<KeyCurve, SineCurve, WanderCurve, SampledCurve>;

struct Control;

/// The value of the control that it moves is the first curve's, plus the difference of each further one from the control's
/// rest.
struct MotionChannel {
  std::string name;           ///< of the control: "arkit.jawOpen", "yaw"
  std::vector<Curve> curves;  ///< at least 1
  Index<Control> control{};   ///< of the face that the motion is bound to; none: of no face yet
};

/// What a face does by itself (lib/rig/idle), each of its own seed (FaceModel::seed, Pose::seed).
enum class IdlePart : unsigned char {
  gaze_x,
  gaze_y,
  yaw,
  pitch,
  roll,
  blink_left,
  blink_right,
  breath,
  corner_left,
  corner_right,
  brow_left,
  brow_right,
  dilation
};

/// The value of the control is its rest plus `scale` times the part's number.
struct IdleChannel {
  IdlePart part;
  Index<Control> control;
  double scale = 1;
};

/// From when to when [s].
struct SpokenSpan {
  double begin, end;
};

/// A moment of speech that a speaker stresses.
struct SpokenAccent {
  double time;          ///< [s] of the vowel
  double strength;      ///< 0 … 1
  bool rising = false;  ///< with the voice going up, as far as a track tells
};

/// What head and brows do with the accents of speech (lib/rig/speech/gestures.h).
enum class GesturePart : unsigned char { nod, brows };

/// Adds `scale` times the part's number to the control.
struct GestureChannel {
  GesturePart part;
  Index<Control> control;
  double scale = 1;
};

/// What a speaker does beside moving the mouth.
struct SpokenGestures {
  std::vector<SpokenSpan>
      contacts;  ///< when lips, or lip and teeth, touch: apart, in order. No blink falls into them
  std::vector<SpokenAccent> accents;          ///< in order
  std::vector<GestureChannel> channels = {};  ///< of the face that the motion is bound to
};

struct Motion {
  std::string name;
  std::vector<MotionChannel> channels;  ///< later ones beat earlier ones
  std::vector<IdleChannel> idle = {};   ///< before them
  bool additive = false;  ///< adds its difference from rest instead of replacing values
  /// Its numbers were seen on a face, or planned for it: muscles are where they pull to at once. Those of others get there
  /// by the law of muscles.
  bool settled = false;
  SpokenGestures spoken = {};  ///< of a track of speech
};

}  // namespace mien
