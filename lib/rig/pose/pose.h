#pragma once
// Posing: a face, a time and settings give a posed face. It is a pure function of those three.

#include <mien/api.h>
#include <mien/basis.h>
#include <mien/expected.h>
#include <mien/face.h>
#include <mien/index.h>
#include <mien/unwrap_mode.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct Motion;

/// Holds a named number, or a slice of numbers, at a value. The name is a control ("gaze.x",
/// "blink.left") or a slice of the face vector ("brow.left/spine/1"). read_setting makes it, for faces
/// of one model.
struct Setting {
  bool control = false;
  int index = 0;  ///< of the control, or the first number in the face vector
  std::vector<double> values = {};
};

/// Reads "NAME=VALUE" or "NAME=V,V,…". NAME is one of the face's controls, a slice, or one number of a
/// slice ("brow.left/spine/1/y"). A colour is linear r,g,b or r,g,b,a, or "#rrggbb" or "#rrggbbaa"
/// (sRGB-encoded). Errors: an unknown name (with the nearest known one); a number that is not finite or
/// out of range; too few or too many numbers. The error's `where` is the text itself.
MIEN_API Expected<Setting> read_setting(const Face& face, std::string_view text);

/// One motion of a mix. It acts on the result of those before it: the controls that it moves go `weight` of the way to its
/// values. An additive one adds `weight` times its difference from rest.
struct MotionLayer {
  Index<Motion> clip = {};                    ///< of the model; none: `motion`
  std::shared_ptr<const Motion> motion = {};  ///< bound to a face of the model (bound_motion.h)
  double weight = 1;
  double begin = 0;  ///< [s] when the motion's own time is 0
};

/// Reads "NAME", "NAME=WEIGHT" or "NAME=WEIGHT@BEGIN" with the name of one of the face's clips. Errors as
/// for read_setting.
MIEN_API Expected<MotionLayer> read_clip_layer(const Face& face, std::string_view text);

/// Reads "NAME=WEIGHT", or "NAME" for a weight of 1, with the name of one of the face's poses. Errors as
/// for read_setting.
MIEN_API Expected<Setting> read_pose(const Face& face, std::string_view text);

/// Reads "X,Y,Z": a point in face units, z towards the viewer. It is an error if no eye of the face can
/// look.
MIEN_API Expected<glm::dvec3> read_look_at(const Face& face, std::string_view text);

inline constexpr double kMostLively = 2, kMostGestures = 2;

struct Pose {
  std::optional<double> time = {};        ///< [s]; without one no motion runs
  std::vector<Setting> settings = {};     ///< beat clips and gaze; later ones beat earlier ones
  std::vector<MotionLayer> motions = {};  ///< bottom to top; none: the face's default clip
  /// What idle life draws from; none: the face's own (FaceModel::seed). seed_from_word makes one.
  std::optional<std::uint64_t> seed = {};
  /// 0 … kMostLively: how far clips move the face from rest, and how often it blinks by itself. 1: as the clips have it; 0:
  /// no clip runs. Takes and speech go as far as they go.
  double liveliness = 1;
  /// 0 … kMostGestures: how far the head nods and brows rise with the stresses of speech, as `liveliness` lets them; 0: the mouth
  /// alone speaks.
  double gestures = 1;
  std::optional<glm::dvec3> look_at = {};  ///< what all eyes look at [face units]; beats clips
  double unwrap = 0;  ///< 0 … 1: how far the features have travelled to their chart (unwrap.h)
  UnwrapMode unwrap_mode = UnwrapMode::linear;
  /// A basis of this face, whose vector replaces the rest vector. The default clip, which the basis
  /// already contains, does not run then; named clips do. The eyes' laws act only on what controls move
  /// on top of it.
  std::shared_ptr<const FaceBasis> basis = {};
  std::vector<double> basis_weights = {};  ///< empty: those at `time`; without a time all 0
};

/// The face at that pose. The steps, in order:
///   1. channels take their values from rest, clips, look_at and settings; then expressions and poses
///      move them
///   2. poses
///   3. muscles
///   4. controls, in the model's order: offsets, scales, key shapes
///   5. eyes: lid follow, blink, bulge; settings of eyeballs act before them
///   6. head turn
///   7. unwrap
///   8. slice settings
///   9. rules (clamp, wrap), applied once, so a posed face is always valid
/// A face with a mood rests in it (docs/face-format.md). The steps begin without the mood, and where another emotion or
/// expression comes, the mood goes by twice as much.
/// Without time, gaze and settings the result is the rest vector, bit for bit. Total: a setting or clip
/// of another model does nothing, a liveliness out of range counts as its nearer end, and numbers out of range follow
/// their rule.
MIEN_API Face pose_face(const Face& face, const Pose& pose = {});

/// The same face, resting without its mood.
MIEN_API Face without_mood(const Face& face);

/// A name that read_setting takes.
struct SettableName {
  std::string name;
  std::string unit;           ///< "face units", "ratio", "linear light", …
  double lo, hi;              ///< range; may be infinite
  std::vector<double> value;  ///< at rest
  bool control;
  bool pose;  ///< whether it is a control that is the weight of a pose
};

/// All of them: controls first (poses among them), then slices in the vector's order.
MIEN_API std::vector<SettableName> settable_names(const Face& face);

}  // namespace mien
