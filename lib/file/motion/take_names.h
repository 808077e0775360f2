#pragma once
// What the columns and names of takes mean for a face.

#include <string>
#include <string_view>
#include <vector>

namespace mien {

enum class TakeUnit : unsigned char {
  share,   ///< 0 to 1; programs also write 0 to 100
  degrees  ///< from −180 to 180
};

/// One channel that a number of a take moves: by `factor` times the number.
struct TakeTarget {
  std::string channel;  ///< "arkit.jawOpen", "yaw"
  TakeUnit unit = TakeUnit::share;
  double factor = 1;
  bool one_sided = false;  ///< what is below 0 counts as 0
  bool scaled = false;     ///< the number has a scale of its own: never 0 to 100
};

/// What a name means, in any spelling: of ARKit ("JawOpen"), visemes ("viseme_PP", "ih"), OpenFace ("AU12_r", "pose_Rx",
/// "gaze_angle_x"), turns of the head in radians ("HeadYaw"), or with its set before it, "vrm.happy", "emotion.joy". Empty:
/// nothing that moves a face.
std::vector<TakeTarget> take_targets(std::string_view name);

/// Whether a name is known to say something that moves no face: counts, frames' numbers, eyes' angles, which the shapes of
/// the gaze repeat.
bool is_beside_the_face(std::string_view name);

/// The angles of head and eyes, which stand beside ARKit's 52 shapes in many files.
bool is_turn_of_head_or_eye(std::string_view name);

}  // namespace mien
