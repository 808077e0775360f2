#pragma once
// What people typed after `mien animate`, `mien morph` and `mien mesh`.

#include "tools/mien/cli/arguments.h"

#include <optional>
#include <string>
#include <vector>

namespace mien::command {

struct AnimateArguments {
  RenderArguments render;  ///< `output`: a pattern of names, or a film
  std::optional<std::string> frames, fps, sound;
  bool again = false;
};

/// `mien say`: text as speech, and a face that speaks it.
struct SayArguments {
  AnimateArguments animate;  ///< `output` may be empty or a track's; `sound` is one that is written
  std::string text;
  std::optional<std::string> voice, rate, pitch;
  bool voices = false;
};

struct MorphArguments {
  bool from_obj = false;  ///< `mien morph from-obj`, not `make`
  std::string rest, map, neutral, output;
  std::vector<std::string> targets;  ///< FILE or NAME=FILE

  std::vector<std::string> people;  ///< `mien morph between`: two recipes or codes
  std::optional<std::string> steps, at, parts_at, size, style, columns, gap, fps;
};

struct MeshArguments {
  std::string neutral, output;
  std::vector<std::string> targets;  ///< FILE or NAME=FILE
  std::vector<std::string> weights;  ///< NAME=WEIGHT
  std::optional<std::string> size, yaw, pitch;
};

}  // namespace mien::command
