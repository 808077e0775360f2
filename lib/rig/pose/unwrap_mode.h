#pragma once
// How features progress while a face unwraps; docs/rig.md has the formulas.

#include <string_view>

namespace mien {

enum class UnwrapMode : unsigned char { linear, delayed, sine };
inline constexpr std::string_view kUnwrapModes = "linear|delayed|sine";  ///< as enum UnwrapMode

}  // namespace mien
