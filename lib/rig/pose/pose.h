#pragma once
// Posing: a face, a moment and settings in, a posed face out. A pure function of those three.

#include <mien/api.h>
#include <mien/basis.h>
#include <mien/expected.h>
#include <mien/face.h>
#include <mien/unwrap_mode.h>

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// One named number (or slice of numbers) held at a value: a control ("gaze.x", "blink.left") or a
/// slice of the face vector ("brow.left/spine/1"). Made by read_setting, valid for that face's
/// model.
struct Setting {
  bool control = false;
  int index = 0;  ///< of the control, or the first number in the face vector
  std::vector<double> values;
};

/// Reads "NAME=VALUE" or "NAME=V,V,…" against a face's names: a control, a slice, or one number of
/// a slice
/// ("brow.left/spine/1/y"). A colour is linear r,g,b or r,g,b,a, or "#rrggbb" or "#rrggbbaa"
/// (sRGB-encoded). Errors: an unknown name (with the nearest known one), a number that is not
/// finite, or out of its range, or too few or many of them. The error's `where` is the text itself.
MIEN_API Expected<Setting> read_setting(const Face& face, std::string_view text);

/// One clip of a mix: laid over those before it. What it moves goes `weight` of the way to its own
/// values; an additive clip adds `weight` times what it differs from rest by.
struct ClipLayer {
  int clip = 0;  ///< of the model
  double weight = 1;
  double begin = 0;  ///< [s] when its own time is 0
};

/// Reads "NAME", "NAME=WEIGHT" or "NAME=WEIGHT@BEGIN" against a face's clips. Errors as of
/// read_setting.
MIEN_API Expected<ClipLayer> read_clip_layer(const Face& face, std::string_view text);

/// Reads "NAME=WEIGHT", or "NAME" for a weight of 1, against a face's named poses alone. Errors as
/// of read_setting.
MIEN_API Expected<Setting> read_pose(const Face& face, std::string_view text);

/// Reads "X,Y,Z": a point in face units, z towards the viewer. An error for a face without eyes that
/// can look.
MIEN_API Expected<glm::dvec3> read_look_at(const Face& face, std::string_view text);

struct Pose {
  std::optional<double> time = {};         ///< [s]; without one no clip runs
  std::vector<Setting> settings = {};      ///< beat clips and gaze; later ones beat earlier ones
  std::vector<ClipLayer> clips = {};       ///< bottom to top; none: the face's default clip
  std::optional<glm::dvec3> look_at = {};  ///< what all eyes look at [face units]; beats clips
  double unwrap = 0;  ///< 0 … 1: how far the features have travelled to their chart (unwrap.h)
  UnwrapMode unwrap_mode = UnwrapMode::linear;
  /// Of this face: its vector takes the rest vector's place. The default clip does not run then,
  /// being in the basis already; clips that are named do. The eyes' laws act then on what controls
  /// move on top of it.
  std::shared_ptr<const FaceBasis> basis = {};
  std::vector<double> basis_weights = {};  ///< empty: those at `time`; without a time all 0
};

/// The face at that pose. Order: rest → channels take their values (rest, clips, look_at, settings,
/// then what
/// expressions and poses move them by) → poses → muscles → controls act in the model's order (offsets, scales, key
/// shapes) → eyes (lid follow, blink, bulge; settings of eyeballs act before them) → head turn → unwrap → slice
/// settings → rules (clamp, wrap), applied once,
/// so a posed face is always valid. Without a time, a gaze and settings it is the rest vector, bit
/// for bit. Total: a setting or clip that is not of this model does nothing, numbers out of range
/// follow their rule.
MIEN_API Face pose_face(const Face& face, const Pose& pose = {});

/// A name that read_setting takes.
struct SettableName {
  std::string name;
  std::string unit;           ///< "face units", "ratio", "linear light", …
  double lo, hi;              ///< range; may be infinite
  std::vector<double> value;  ///< at rest
  bool control;
  bool pose;  ///< a control that is the weight of a pose
};

/// All of them: controls first (poses among them), then slices in the vector's order.
MIEN_API std::vector<SettableName> settable_names(const Face& face);

}  // namespace mien
