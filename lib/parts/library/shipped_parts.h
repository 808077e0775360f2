#pragma once
// The files of parts/, compiled in: no file is read at run time.

#include <span>
#include <string_view>

namespace mien {

struct ShippedPart {
  std::string_view name, text;  ///< "hair/bob.part.json"
};

std::span<const ShippedPart> shipped_parts();

}  // namespace mien
