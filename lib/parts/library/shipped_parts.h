#pragma once
// The files of all editions, compiled in: no file is read at run time.

#include <span>
#include <string_view>

namespace mien {

struct ShippedPart {
  std::string_view name, text;
};

/// What lies in parts/EDITION.
struct ShippedFolder {
  char edition;
  std::span<const ShippedPart> parts;
};

/// By their edition's sign.
std::span<const ShippedFolder> shipped_folders();

}  // namespace mien
