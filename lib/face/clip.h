#pragma once
// Clips: curves in time that move controls.

#include <mien/index.h>

#include <cstdint>
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
  std::uint32_t seed = 0;      ///< which random numbers
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
  std::uint32_t seed = 0, stream = 0;
};

using Curve = std::variant<KeyCurve, SineCurve, WanderCurve>;

struct Control;

struct ClipTrack {
  Index<Control> control;
  Curve curve;
};

struct Clip {
  std::string name;
  std::vector<ClipTrack> tracks;  ///< later ones beat earlier ones
  bool additive = false;          ///< adds its difference from rest instead of replacing values
};

}  // namespace mien
