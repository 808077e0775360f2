#include "lib/parts/compose/style_features.h"

#include <algorithm>
#include <set>
#include <utility>

namespace mien {

namespace {

/// Whether it is cut to one of the others, as a knit is to its jumper: then it adds nothing to their union.
bool lies_in_another(const FlatFeatures::One& one,
                     const std::vector<const FlatFeatures::One*>& others) {
  return std::any_of(others.begin(), others.end(), [&](const FlatFeatures::One* other) {
    return std::find(one.clips.begin(), one.clips.end(), other->name) != one.clips.end() &&
           (!other->sided() || other->side == one.side);
  });
}

}  // namespace

std::vector<std::string> selected_features(const Reading& in, const JsonNode& selection,
                                           std::size_t order, const PartLibrary& library,
                                           const FlatFeatures& features, Operands which) {
  std::set<std::string_view> roles;
  std::set<std::pair<std::size_t, std::string_view>> roles_in_slots;
  std::set<std::size_t> slots;
  const JsonNode* role_list = in.find(selection, "roles");
  const JsonNode* slot_list = in.find(selection, "slots");
  if (role_list)
    in.for_each(*role_list, [&](const JsonNode& one, int) {
      const std::string_view role = in.string(one);
      const std::size_t slash = role.find('/');
      if (slash == std::string_view::npos)
        roles.insert(role);
      else
        roles_in_slots.emplace(slot_named(in, role.substr(0, slash), one, library),
                               role.substr(slash + 1));
    });
  if (slot_list)
    in.for_each(*slot_list,
                [&](const JsonNode& one, int) { slots.insert(slot_named(in, one, library)); });
  std::vector<const FlatFeatures::One*> found;
  for (const FlatFeatures::One& one : features.all()) {
    if (one.order > order) continue;
    const bool listed = roles.contains(one.role) || roles_in_slots.contains({one.slot, one.role});
    if (one.role == "none" || (role_list && !listed)) continue;
    if (slot_list && !slots.contains(one.slot)) continue;
    found.push_back(&one);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto* a, const auto* b) { return drawn_before(*a, *b); });
  std::vector<std::string> names;
  for (const FlatFeatures::One* one : found) {
    if (which == Operands::of_union && lies_in_another(*one, found)) continue;
    for (std::string& name : names_of(*one)) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace mien
