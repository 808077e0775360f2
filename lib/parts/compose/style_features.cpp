#include "lib/parts/compose/style_features.h"

#include <algorithm>
#include <set>

namespace mien {

std::vector<std::string> selected_features(const Reading& in, const JsonNode& selection,
                                           std::size_t order, const PartLibrary& library,
                                           const FlatFeatures& features) {
  std::set<std::string_view> roles;
  std::set<std::size_t> slots;
  const JsonNode* role_list = in.find(selection, "roles");
  const JsonNode* slot_list = in.find(selection, "slots");
  if (role_list)
    in.for_each(*role_list, [&](const JsonNode& one, int) { roles.insert(in.string(one)); });
  if (slot_list)
    in.for_each(*slot_list,
                [&](const JsonNode& one, int) { slots.insert(slot_named(in, one, library)); });
  std::vector<const FlatFeatures::One*> found;
  for (const FlatFeatures::One& one : features.all()) {
    if (one.order > order) continue;
    if (one.role == "none" || (role_list && !roles.contains(one.role))) continue;
    if (slot_list && !slots.contains(one.slot)) continue;
    found.push_back(&one);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto* a, const auto* b) { return drawn_before(*a, *b); });
  std::vector<std::string> names;
  for (const FlatFeatures::One* one : found)
    for (std::string& name : names_of(*one)) names.push_back(std::move(name));
  return names;
}

}  // namespace mien
