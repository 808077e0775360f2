#pragma once
// What the standard names mean for the muscles of facemotion.js, which are named as anatomy names them.

#include <span>
#include <string_view>

namespace mien {

struct StandardTable {
  std::string_view set;
  /// A line each: NAME MUSCLE AMOUNT MUSCLE AMOUNT … With a * in NAME it is two lines, one for Left
  /// and one for Right, whose muscles are those of that side.
  std::string_view lines;
};

std::span<const StandardTable> standard_tables();

}  // namespace mien
