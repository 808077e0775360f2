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

/// Reads "NAME=VALUE" or "NAME=V,V,…" against a face's names. An unknown name is an error that
/// gives the nearest known one. Colours may be "#rrggbb".
MIEN_API Expected<Setting> read_setting(const Face& face, std::string_view text);

struct Pose {
  std::optional<double> time;     ///< [s]; without one no clip runs
  std::vector<Setting> settings;  ///< beat clips; later ones beat earlier ones
};

/// The face at that pose. Order: rest → controls by clips, then settings → key shapes → drives
/// (gaze, dilation) → slice settings → rules (clamp, wrap), applied once, so a posed face is always
/// valid.
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
