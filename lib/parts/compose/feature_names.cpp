// Names of features and slots, as faces and the library have them.

#include "lib/base/nearest_name.h"
#include "lib/parts/compose/flat_feature.h"

#include <fmt/format.h>

namespace mien {

std::vector<std::string> names_of(const FlatFeatures::One& one) {
  if (one.side.empty()) return {std::string(one.name)};
  std::vector<std::string> names;
  for (const std::string_view side : {"left", "right"})
    if (one.side == "both" || one.side == side)
      names.push_back(fmt::format("{}.{}", one.name, side));
  return names;
}

std::size_t slot_named(const Reading& in, const JsonNode& wanted, const PartLibrary& library) {
  return slot_named(in, in.string(wanted), wanted, library);
}

std::size_t slot_named(const Reading& in, std::string_view name, const JsonNode& wanted,
                       const PartLibrary& library) {
  const Reading& own = library.topology().in();
  const JsonNode& slots = own.need(*library.topology().node, "slots");
  std::size_t at = 0;
  for (const JsonNode* one = own.tree.first(slots); one; one = own.tree.next(*one), ++at)
    if (own.string(*one) == name) return at;
  std::vector<std::string_view> names;
  own.for_each(slots, [&](const JsonNode& one, int) { names.push_back(own.string(one)); });
  in.refuse(wanted, unknown_name("slot", name, names));
}

}  // namespace mien
