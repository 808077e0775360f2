#include "lib/parts/compose/part_style.h"

#include <algorithm>
#include <array>
#include <string>

namespace mien {
namespace {

std::vector<std::string_view> listed_names(const Reading& in, const JsonNode* list) {
  std::vector<std::string_view> names;
  if (list) in.for_each(*list, [&](const JsonNode& one, int) { names.push_back(in.string(one)); });
  return names;
}

}  // namespace

bool is_of_paint(std::string_view member) {
  constexpr std::array<std::string_view, 6> kOfPaint{"paint", "relief",  "shadow",
                                                     "glow",  "contour", "feather"};
  return std::find(kOfPaint.begin(), kOfPaint.end(), member) != kOfPaint.end();
}

PartStyle::PartStyle(const PartLibrary& library, std::string_view style, std::uint64_t person)
    : sheet_(library.topology()) {
  const Reading& in = sheet_.in();
  sheet_.node = &in.need(in.need(*sheet_.node, "styles"), style);
  gone_ = names("gone"), drawn_ = names("drawn");
  if (const JsonNode* figure = find("figure"))
    figure_ = listed_names(in, &in.need(*figure, "slots"));
  if (const JsonNode* hand = find("hand")) {
    by_hand_ = listed_names(in, &in.need(*hand, "slots"));
    hand_.emplace(person, in.number(in.need(*hand, "amplitude")),
                  in.number(in.need(*hand, "width")));
  }
}

std::vector<std::string_view> PartStyle::names(std::string_view key) const {
  return listed_names(in(), find(key));
}

bool PartStyle::has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const JsonNode* PartStyle::figure_clip() const {
  const JsonNode* figure = find("figure");
  return figure ? in().find(*figure, "clip") : nullptr;
}

const Hand* PartStyle::hand(std::string_view slot) const {
  return hand_ && has(by_hand_, slot) ? &*hand_ : nullptr;
}

PartStyle::Role PartStyle::role(const Reading& in, const JsonNode& feature) const {
  const JsonNode* named = in.find(feature, "role");
  Role role;
  if (named) role.name = in.string(*named);
  const JsonNode* slot = in.find(feature, "slot");
  const std::string stem = slot ? std::string(in.string(*slot)) + '/' : "/";
  const std::string in_slot = stem + '*', both = stem + std::string(role.name);
  const auto sheet = [&](std::string_view kind, std::string_view key) {
    const JsonNode* sheets = find(kind);
    const JsonNode* found = sheets ? this->in().find(*sheets, key) : nullptr;
    if (found) role.sheets.push_back(found);
  };
  if (named) sheet("roles", role.name);
  sheet("roles", in_slot);
  if (named) sheet("roles", both);
  const JsonNode* name = in.find(feature, "name");
  if (name) sheet("features", in.string(*name));
  const auto listed = [&](const std::vector<std::string_view>& names) {
    return has(names, role.name) || has(names, in_slot) || has(names, both);
  };
  role.gone = listed(gone_) || (!drawn_.empty() && !listed(drawn_)) ||
              (name && left_out_.contains(in.string(*name)));
  const JsonNode* paint = in.find(feature, "paint");
  role.keeps_paint = role.gone && paint && paint->kind == JsonKind::object;
  return role;
}

bool PartStyle::leaves_out_all_of(const JsonNode& added) const {
  const JsonNode* any = in().find(added, "any");
  if (!any || any->kind != JsonKind::array) return false;
  bool all = true;
  in().for_each(*any, [&](const JsonNode& one, int) {
    const std::string_view name = in().string(one);  // "lip_upper.left" is lip_upper's
    all = all && left_out_.contains(name.substr(0, name.find('.')));
  });
  return all;
}

bool PartStyle::replaces(const Role& role, std::string_view key) const {
  if (role.keeps_paint) return key == "opacity" || (is_of_paint(key) && key != "paint");
  if (role.gone && is_of_paint(key)) return true;
  return std::any_of(role.sheets.begin(), role.sheets.end(),
                     [&](const JsonNode* sheet) { return in().find(*sheet, key); });
}

bool PartStyle::among(Members which, std::string_view key) {
  if (which == Members::all) return true;
  const bool seen = is_of_paint(key) || key == "opacity" || key == "group";
  return seen == (which == Members::paint);
}

bool PartStyle::paints(const Role& role, bool painted) const {
  if (role.gone) return false;
  for (auto sheet = role.sheets.rbegin(); sheet != role.sheets.rend(); ++sheet)
    if (const JsonNode* paint = in().find(**sheet, "paint")) return paint->kind != JsonKind::null;
  return painted || (!role.name.empty() && role.name != "none");
}

void PartStyle::write_members(const Role& role, bool painted, Members which, const Place& place,
                              TreeWriter& to) const {
  for (auto sheet = role.sheets.begin(); sheet != role.sheets.end(); ++sheet)
    in().for_each(**sheet, [&](const JsonNode& member, int) {
      const std::string_view key = in().tree.key(member);
      if (role.keeps_paint && key == "opacity") return;
      painted = painted || key == "paint";
      const bool replaced = std::any_of(sheet + 1, role.sheets.end(), [&](const JsonNode* later) {
        return in().find(*later, key);
      });
      if (replaced || !among(which, key) || member.kind == JsonKind::null) return;
      if (role.gone && is_of_paint(key)) return;
      to.key(key), to.copy(in().tree, member, place);
    });
  // Gone is invisible, not removed: the rig names it.
  if (role.keeps_paint) to.key("opacity"), to.number(0);
  if (which == Members::figure || role.gone || painted || role.name.empty() || role.name == "none")
    return;
  std::string color(role.name);
  std::replace(color.begin(), color.end(), '.', '_');
  to.key("paint"), to.kept_string(color);
}

}  // namespace mien
