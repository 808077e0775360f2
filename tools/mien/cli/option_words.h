#pragma once
// The words that some options take, defined once for help, man page, completion and reading.

#include <string_view>

namespace mien::command {

inline constexpr std::string_view kFits = "meet|slice";
inline constexpr std::string_view kBlends = "linear|srgb";
inline constexpr std::string_view kDebugs =
    "outlines|regions|fragments|looks|distance|normals|morph|muscles|points";
inline constexpr std::string_view kFaceDebugs = "muscles|points";  ///< those that are scenes
inline constexpr std::string_view kMorphDebug = "morph";           ///< so is this, of two faces
inline bool is_face_debug(std::string_view word) {
  return word == "muscles" || word == "points";
}
inline constexpr std::string_view kDithers = "on|off";
inline constexpr std::string_view kDepths = "8|16|half|float";
inline constexpr std::string_view kStats = "json";
inline constexpr std::string_view kProgress = "auto|json|none";
inline constexpr std::string_view kShells = "bash|zsh|fish";

}  // namespace mien::command
