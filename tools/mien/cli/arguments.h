#pragma once
// What people typed, sorted but not yet understood: texts as given, empty where nothing was.

#include <optional>
#include <string>
#include <vector>

namespace mien::command {

/// FACE and how it is posed.
struct PosedFace {
  std::string face;
  std::optional<std::string> style;  ///< of a face by code
  bool neutral = false;
  std::optional<std::string> time;
  std::vector<std::string> clips, poses;
  std::optional<std::string> seed, liveliness, gestures;
  std::optional<std::string> motion, speech;  ///< files
  std::optional<std::string> look_at, blink, bias, unwrap, unwrap_mode;
  std::vector<std::string> emotions, muscles;
  std::optional<std::string> arkit;
  bool clamp = false;
  std::vector<std::string> settings;
  std::vector<std::string> morphs;  ///< files with more poses
  std::optional<std::string> basis, weights;
};

struct RenderArguments {
  PosedFace posed;
  std::string output;
  std::optional<std::string> size, fit, region, background, blend, depth, threads, memory,
      most_steps, stats;
  std::optional<std::string> light, legible, dither, debug, error_map, id_prefix, dpi;
  std::vector<std::string> effects;
};

struct BenchArguments {
  RenderArguments render;  ///< without output
  std::optional<std::string> repeat;
  bool json = false;
};

struct CheckArguments {
  std::vector<std::string> faces;
  bool nonsense = false;
  std::vector<std::string> people;  ///< after --nonsense: one word at most
  std::optional<std::string> seed;
  std::optional<std::string> style;   ///< of all people
  std::vector<std::string> worn;      ///< part files; by all people
  std::optional<std::string> output;  ///< a picture of what is wrong most
  bool json = false;
};

struct SceneArguments {
  PosedFace posed;
  std::optional<std::string> debug;
};

struct ImportArguments {
  std::string format, output;
  std::vector<std::string> files;  ///< facemotion: one; obj-targets: FACE MAP NEUTRAL TARGETS…
  std::optional<std::string> morphology;
  bool smooth = false;
};

struct FitArguments {
  std::string face, targets;
};

struct SheetArguments {
  std::optional<std::string> face, output;
  std::optional<std::string> people, parts, seed, style;
  std::optional<std::string> cell, columns, gap;
  std::vector<std::string> pictures;
  std::optional<std::string> turned;
  bool emotions = false, half = false, neutral = false;
  bool statistics = false, json = false;
};

/// mien new.
struct NewArguments {
  std::optional<std::string> output, seed, code, style;
  std::optional<std::string> near, by, at;
  std::vector<std::string> between, child_of;  ///< two codes, or none
  std::vector<std::string> held;
  bool clamp = false, flat = false;
};

/// mien code.
struct CodeArguments {
  std::optional<std::string> face, seed;
};

/// mien parts.
struct PartsArguments {
  enum class Verb { list, begin, check };
  Verb verb = Verb::list;
  std::optional<std::string> family, output;  ///< listed or begun
  std::string name;                           ///< begun
  std::vector<std::string> files;             ///< checked
  std::optional<std::string> people, seed;
};

/// mien chernoff.
struct ChernoffArguments {
  std::string table, output;
  std::optional<std::string> map, legend, manifest, style, cell, columns, gap;
};

/// mien stimuli.
struct StimuliArguments {
  std::string plan, output;
};

/// mien set.
struct SetArguments {
  std::string face, output;
  std::vector<std::string> settings;
};

struct ListArguments {
  std::string face;                  ///< empty: none, only with `moves`
  std::optional<std::string> moves;  ///< a standard name
};

}  // namespace mien::command
