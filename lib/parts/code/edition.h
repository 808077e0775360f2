#pragma once
// The sign of the library of parts: the first of every code, and the "edition" of a recipe.

#include "lib/base/one_line.h"

#include <fmt/format.h>

namespace mien {

inline constexpr char kEdition = 'A';

/// Why a code or a recipe of another sign is refused.
inline std::string unknown_edition(std::string_view sign) {
  return fmt::format("edition {} is not known to this version, which has {}", one_line(sign, 20),
                     kEdition);
}

}  // namespace mien
