#pragma once
// What is drawn: a face at a pose, at one size, and the same never twice.
//
// Scene A is the eyes (faces/compat/seed0, gaze (0.03, −0.02)), B the male face at rest, C toon, D bruno,
// E clay, F bruno without reliefs. B and E are square pictures, the others wide ones.

#include <mien/mien.h>

#include <optional>
#include <string>
#include <vector>

namespace mien::bench {

struct FrameCase {
  char scene;
  const char* face;                   ///< its file is faces/compat/NAME.face.json
  std::vector<const char*> settings;  ///< as `mien render --set` takes them
  bool reliefs;                       ///< false: taken out of the scene
  int width, height;
};

/// All of them, scene by scene, small pictures first.
std::vector<FrameCase> frame_cases();

/// The five faces at 640 x 360.
std::vector<FrameCase> reuse_cases();

std::string face_path(const FrameCase& c);

/// The face of a case, and faces that differ from it in every length.
class Subject {
 public:
  explicit Subject(const FrameCase& c);

  /// The face, `step` hundred-thousandths smaller (of a hundred: it begins again then): every point
  /// and length of it is another number, so nothing made for one step is of use for the next.
  Face face(int step) const;
  /// The pose; its gaze `step` ten-thousandths further to the side, where the face has a gaze.
  Pose pose(int step = 0) const;
  bool has_gaze() const { return gaze_.has_value(); }

  /// The scene as the case wants it: with or without reliefs.
  Scene as_wanted(Scene scene) const;
  Scene scene(int step) const;

 private:
  Face face_;
  Pose pose_;
  std::optional<Setting> gaze_;  ///< where it is at step 0
  bool reliefs_;
};

}  // namespace mien::bench
