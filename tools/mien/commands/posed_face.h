#pragma once
// The FACE argument and its pose options, shared by render and scene.

#include <mien/face.h>
#include <mien/pose.h>
#include <mien/recipe.h>
#include <mien/scene.h>
#include "tools/mien/cli/arguments.h"
#include "tools/mien/terminal/messages.h"

#include <optional>

namespace mien::command {

/// The face of a file or code, or nothing; warnings and the error have been printed.
std::optional<Face> read_face_or_report(const std::string& path,
                                        const std::optional<std::string>& style = {},
                                        bool neutral = false);

/// Whether a FACE is a code, and no file of that name is there.
bool is_given_as_code(const std::string& text);

/// The recipe of a code, or of a face file that is one.
Expected<Recipe> read_given_recipe(const std::string& text, std::vector<Error>* warnings = nullptr);

/// A face file, the face of a code, or a sample face by its name; `style` paints the latter. A file of that name comes first. `neutral`: without
/// smile or mood; the smile of a face in full is in its points, and stays.
Expected<Face> read_face_or_code(const std::string& text,
                                 const std::optional<std::string>& style = {},
                                 std::vector<Error>* warnings = nullptr, bool neutral = false);

/// The face of a recipe, in a style of its own if one is given.
Expected<Face> face_of_recipe(Recipe recipe, const std::optional<std::string>& style, bool neutral);

/// The pose that the options ask for, but for those that name files. Errors have the option as their address.
Expected<Pose> read_pose_options(const Face& face, const PosedFace& arguments);

/// A face and the pose asked for, or the exit code after the error has been printed. `known`: the face, if
/// it has been read already.
struct FaceAndPoseOrCode {
  std::optional<Face> face;
  Pose pose;
  int code = kDone;
};
FaceAndPoseOrCode read_face_and_pose(const PosedFace& arguments, const Face* known = nullptr);

/// A face at the pose asked for, or the exit code after the error has been printed.
struct PosedOrCode {
  std::optional<Face> face;
  int code = kDone;
};
PosedOrCode read_posed_face(const PosedFace& arguments, const Face* known = nullptr);

/// Its scene; with `debug`, one of kFaceDebugs, what moves it is drawn over it.
struct SceneOrCode {
  std::optional<Scene> scene;
  int code = kDone;
  double read = 0, made = 0;  ///< [s] reading and posing; making the scene
};
SceneOrCode read_scene(const PosedFace& arguments, const std::optional<std::string>& debug);

}  // namespace mien::command
