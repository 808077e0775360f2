#pragma once
// Clips: curves in time that move controls.

#include <string>
#include <variant>
#include <vector>

namespace mien {

/// How a curve goes from one key to the next.
enum class Ease : unsigned char {
  linear,
  step,    ///< stays, and jumps at the next key
  smooth,  ///< starts and stops softly: 3u² − 2u³
  in,      ///< starts softly: u²
  out      ///< stops softly: 1 − (1−u)²
};

struct CurveKey {
  double time;  ///< [s]
  double value;
  Ease ease = Ease::linear;  ///< towards the next key
};

/// Through keys; held before the first and after the last.
struct KeyCurve {
  std::vector<CurveKey> keys;  ///< times rising; at least 1
  double period = 0;           ///< [s] time is taken modulo this; 0: once only
};

/// offset + amplitude · sin(frequency · t + phase), or · |sin …|
struct SineCurve {
  double amplitude = 1;
  double frequency = 1;  ///< [rad/s]
  double phase = 0;      ///< [rad]
  double offset = 0;
  bool absolute = false;
};

using Curve = std::variant<KeyCurve, SineCurve>;

struct ClipTrack {
  int control;  ///< of the model
  Curve curve;
};

struct Clip {
  std::string name;
  std::vector<ClipTrack> tracks;  ///< later ones beat earlier ones
};

}  // namespace mien
