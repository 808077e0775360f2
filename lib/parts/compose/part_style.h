#pragma once
// A style: what features of a role are painted with. It touches no point, so every pose works in every style.

#include "lib/file/json/tree_writer.h"
#include "lib/parts/library/part_library.h"

#include <set>
#include <string>
#include <string_view>

namespace mien {

class PartStyle {
 public:
  /// The library must outlive this; the name must be one of its styles.
  PartStyle(const PartLibrary& library, std::string_view style);

  /// How the style paints a feature, by its role.
  struct Role {
    std::string_view name;            ///< empty: none
    const JsonNode* sheet = nullptr;  ///< null: nothing
    bool gone = false;
  };
  Role role(const Reading& in, const JsonNode& feature) const;

  /// From now on features of this name are gone, whatever their role.
  void leave_out(std::string_view feature) { left_out_.emplace(feature); }

  /// Whether the style sets this member of a feature, whatever the part has.
  bool replaces(const Role& role, std::string_view key) const;

  /// What follows a feature's own members: {"paint": "skin_shade"}. `painted`: the part has a paint.
  void write_members(const Role& role, bool painted, TreeWriter& to) const;

  /// Colours that differ from the topology's; may be null.
  const JsonNode* palette() const;
  /// The lamp, where it is another than the topology's; may be null.
  const JsonNode* light() const;
  const Reading& in() const { return sheet_.in(); }

 private:
  LibraryNode sheet_;
  std::set<std::string, std::less<>> left_out_;
};

}  // namespace mien
