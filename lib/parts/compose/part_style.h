#pragma once
// A style: what features of a role are painted with. It touches no point, so every pose works in every style.

#include "lib/parts/library/part_library.h"

#include <string>

namespace mien {

class PartStyle {
 public:
  /// The library must outlive this; the name must be one of its styles.
  PartStyle(const PartLibrary& library, std::string_view style);

  /// Whether the style says what this member of a feature is, whatever the part says.
  bool replaces(const Reading& in, const JsonNode& feature, std::string_view key) const;

  /// What follows a feature's own members: ", "paint": "skin_shade"". `painted`: the part has a paint.
  std::string members(const Reading& in, const JsonNode& feature, bool painted) const;

  /// Colours that differ from the topology's; may be null.
  const JsonNode* palette() const;
  /// The lamp, where it is another than the topology's; may be null.
  const JsonNode* light() const;
  const Reading& in() const { return sheet_.in(); }

 private:
  const JsonNode* sheet_of(const Reading& in, const JsonNode& feature) const;
  bool is_gone(const Reading& in, const JsonNode& feature) const;

  LibraryNode sheet_;
};

}  // namespace mien
