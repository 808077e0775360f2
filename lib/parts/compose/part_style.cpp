#include "lib/parts/compose/part_style.h"

#include <algorithm>

namespace mien {

PartStyle::PartStyle(const PartLibrary& library, std::string_view style)
    : sheet_(library.topology()) {
  const Reading& in = sheet_.in();
  sheet_.node = &in.need(in.need(*sheet_.node, "styles"), style);
}

const JsonNode* PartStyle::palette() const {
  return in().find(*sheet_.node, "palette");
}

const JsonNode* PartStyle::light() const {
  return in().find(*sheet_.node, "light");
}

PartStyle::Role PartStyle::role(const Reading& in, const JsonNode& feature) const {
  const JsonNode* named = in.find(feature, "role");
  if (!named) return {};
  Role role{.name = in.string(*named)};
  if (const JsonNode* roles = this->in().find(*sheet_.node, "roles"))
    role.sheet = this->in().find(*roles, role.name);
  if (const JsonNode* gone = this->in().find(*sheet_.node, "gone"))
    this->in().for_each(*gone, [&](const JsonNode& one, int) {
      role.gone = role.gone || this->in().string(one) == role.name;
    });
  const JsonNode* feature_name = in.find(feature, "name");
  role.gone = role.gone || (feature_name && left_out_.contains(in.string(*feature_name)));
  return role;
}

bool PartStyle::replaces(const Role& role, std::string_view key) const {
  if (key == "opacity" && role.gone) return true;
  return role.sheet && in().find(*role.sheet, key);
}

void PartStyle::write_members(const Role& role, bool painted, TreeWriter& to) const {
  if (role.sheet) {
    painted = painted || in().find(*role.sheet, "paint");
    in().for_each(*role.sheet, [&](const JsonNode& member, int) {
      const std::string_view key = in().tree.key(member);
      if (!role.gone || key != "opacity") to.key(key), to.copy(in().tree, member);
    });
  }
  // Gone is invisible, not removed: the rig names it.
  if (role.gone) to.key("opacity"), to.number(0);
  if (painted || role.name.empty() || role.name == "none") return;
  std::string color(role.name);
  std::replace(color.begin(), color.end(), '.', '_');
  to.key("paint"), to.kept_string(std::move(color));
}

}  // namespace mien
