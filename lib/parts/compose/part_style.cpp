#include "lib/parts/compose/part_style.h"
#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"

#include <fmt/format.h>

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

/// What the style says of the feature's role; null: nothing.
const JsonNode* PartStyle::sheet_of(const Reading& in, const JsonNode& feature) const {
  const JsonNode* role = in.find(feature, "role");
  const JsonNode* roles = this->in().find(*sheet_.node, "roles");
  return role && roles ? this->in().find(*roles, in.string(*role)) : nullptr;
}

bool PartStyle::is_gone(const Reading& in, const JsonNode& feature) const {
  const JsonNode* role = in.find(feature, "role");
  const JsonNode* gone = this->in().find(*sheet_.node, "gone");
  if (!role || !gone) return false;
  bool is = false;
  this->in().for_each(*gone, [&](const JsonNode& one, int) {
    is = is || this->in().string(one) == in.string(*role);
  });
  return is;
}

bool PartStyle::replaces(const Reading& in, const JsonNode& feature, std::string_view key) const {
  if (key == "opacity" && is_gone(in, feature)) return true;
  const JsonNode* sheet = sheet_of(in, feature);
  return sheet && this->in().find(*sheet, key);
}

std::string PartStyle::members(const Reading& in, const JsonNode& feature, bool painted) const {
  std::string text;
  const JsonNode* sheet = sheet_of(in, feature);
  if (sheet)
    this->in().for_each(*sheet, [&](const JsonNode& member, int) {
      painted = painted || this->in().tree.key(member) == "paint";
      text += fmt::format(", {}: {}", json_string(this->in().tree.key(member)),
                          json_copy(this->in(), member));
    });
  // Gone is invisible, not removed: the rig names it.
  if (is_gone(in, feature)) text += ", \"opacity\": 0";
  const JsonNode* role = in.find(feature, "role");
  if (painted || !role || in.string(*role) == "none") return text;
  std::string color(in.string(*role));
  std::ranges::replace(color, '.', '_');
  return text + fmt::format(", \"paint\": {}", json_string(color));
}

}  // namespace mien
