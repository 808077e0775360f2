#pragma once
// A style: which features are drawn, with what, and which it adds. Poses are those of the parts, so every one works in every
// style.
//
//   "roles"     {"skin": {…}, "nose/skin.shade": {…}, "nose/*": {…}}   members of features by role, or by slot and role
//   "features"  {"upper_line": {…}}                                    by name; null takes a member away
//   "gone"      ["cheek", "nose/*"]                                    not drawn: they keep their points and lose their paint
//   "drawn"     ["skin", "hair"]                                       instead: nothing else is drawn
//   "adds"      features, as a part has them; an area's "any" may be {"roles": […], "slots": […]}
//   "figure"    {"slots": […], "before": SLOT, "clip": NAME}           what makes the figure is known before it is drawn
//   "hand"      {"amplitude": …, "width": …, "slots": […]}             lines of a person's own hand

#include "lib/file/json/tree_writer.h"
#include "lib/parts/compose/hand.h"
#include "lib/parts/library/part_library.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

class PartStyle {
 public:
  /// The library must outlive this; the name must be one of its styles. `person`: whose hand draws.
  PartStyle(const PartLibrary& library, std::string_view style, std::uint64_t person = 0);

  /// How the style paints a feature, by its role, slot and name.
  struct Role {
    std::string_view name;                ///< empty: none
    std::vector<const JsonNode*> sheets;  ///< later ones replace members of earlier ones
    bool gone = false;
    bool keeps_paint = false;  ///< gone, and the rig moves its gradient: it is invisible instead
  };
  Role role(const Reading& in, const JsonNode& feature) const;

  /// From now on features of this name are gone, whatever their role.
  void leave_out(std::string_view feature) { left_out_.emplace(feature); }
  /// Whether an area that the style adds is of features that are all left out: `any` of lips that nobody shows.
  bool leaves_out_all_of(const JsonNode& added) const;

  /// Members of a feature: those of its figure, or those by which it is seen.
  enum class Members { all, figure, paint };
  static bool among(Members which, std::string_view key);

  /// Whether a feature is drawn. `painted`: the part has a paint.
  bool paints(const Role& role, bool painted) const;

  /// Whether the style sets this member of a feature, or takes it away, whatever the part has.
  bool replaces(const Role& role, std::string_view key) const;

  /// What stands for an object of the style, such as a place in a frame; tells whether it wrote it.
  using Place = std::function<bool(const JsonNode&)>;
  /// What follows a feature's own members: {"paint": "skin_shade"}. `painted`: the part has a paint.
  void write_members(const Role& role, bool painted, Members which, const Place& place,
                     TreeWriter& to) const;

  /// A key of the style: colours that differ from the topology's, a lamp, a canvas; may be null.
  const JsonNode* find(std::string_view key) const { return in().find(*sheet_.node, key); }
  const Reading& in() const { return sheet_.in(); }
  LibraryNode sheet() const { return sheet_; }

  /// Whether features in a slot make the figure, and are drawn as areas that were there before.
  bool figure_has(std::string_view slot) const { return has(figure_, slot); }
  /// The slot before whose features those of the figure are known; of a style that has one.
  const JsonNode* figure_before() const { return &in().need(*find("figure"), "before"); }
  /// What the figure's features are clipped to; null: nothing.
  const JsonNode* figure_clip() const;
  /// Whose lines a hand draws; null: nobody's, or not in this slot.
  const Hand* hand(std::string_view slot) const;

 private:
  static bool has(const std::vector<std::string_view>& names, std::string_view name);
  std::vector<std::string_view> names(std::string_view key) const;

  LibraryNode sheet_;
  std::set<std::string, std::less<>> left_out_;
  std::vector<std::string_view> gone_, drawn_, figure_, by_hand_;
  std::optional<Hand> hand_;
};

/// Members that make a feature seen; without paint it has none of them.
bool is_of_paint(std::string_view member);

}  // namespace mien
