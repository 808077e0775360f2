#pragma once
// Posing: a face, a moment and settings in, a posed face out. A pure function of those three.

#include <mien/lib/base/api.h>
#include <mien/lib/base/expected.h>
#include <mien/lib/face/face.h>

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

struct Pose {
  std::optional<double> time;     ///< [s]; without one no clip runs
  std::vector<Setting> settings;  ///< beat clips; later ones beat earlier ones
};

/// The face at that pose. Order: rest → controls take their values (rest, clip, settings) → each
/// channel acts in the model's order (offsets, scales, key shapes) → slice settings → rules (clamp,
/// wrap), applied once, so a posed face is always valid. Without a time and settings it is the rest
/// vector, bit for bit. Total: a setting that is not of this model does nothing, numbers out of
/// range follow their rule.
MIEN_API Face pose_face(const Face& face, const Pose& pose = {});

/// A name that read_setting takes.
struct SettableName {
  std::string name;
  std::string unit;           ///< "face units", "ratio", "linear light", …
  double lo, hi;              ///< range; may be infinite
  std::vector<double> value;  ///< at rest
  bool control;
};

/// All of them: controls first, then slices in the vector's order.
MIEN_API std::vector<SettableName> settable_names(const Face& face);

}  // namespace mien
