#include "lib/parts/compose/compose.h"
#include "lib/base/memory_ran_out.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/parts/compose/composed_text.h"
#include "lib/parts/compose/flat_feature.h"
#include "lib/parts/compose/flat_mouth.h"
#include "lib/parts/compose/flat_rig.h"
#include "lib/parts/compose/part_palette.h"
#include "lib/parts/compose/part_style.h"
#include "lib/parts/compose/style_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace mien {
namespace {

class Composition {
 public:
  explicit Composition(const ChosenParts& parts)
      : parts_(parts),
        library_(parts.library()),
        recipe_(parts.recipe()),
        geometry_(library_, recipe_),
        style_(library_, recipe_.style, parts.person()),
        tree_(recipe_.name.empty() ? "composed face" : one_line(recipe_.name)) {}

  JsonTree tree() {
    for (const Family& family : library_.families())
      if (const Part* part = parts_.of(family.name)) tell(*part, family.name);
    cover();
    geometry_.clear();
    out_.object();
    out_.key("format"), out_.string("mien-face");
    out_.key("format_version"), out_.number(1);
    out_.key("name"), out_.kept_string(well_formed(recipe_.name));
    out_.key("credit"), out_.kept_string(credit());
    write_features();
    if (!groups_.empty()) write_groups();
    write_rest();
    out_.close();
    return std::move(tree_);
  }

 private:
  const JsonNode& need(std::string_view key) const {
    return library_.topology().in().need(*library_.topology().node, key);
  }

  void write_features() {
    out_.key("features");
    const std::int32_t array = out_.next();
    out_.array();
    draw_families(true);
    draw(library_.topology(), "");
    draw_families(false);
    draw_style();
    out_.close();
    features_.sort();
    std::vector<std::int32_t> order;
    order.reserve(features_.all().size());
    for (const FlatFeatures::One& one : features_.all()) order.push_back(one.node);
    out_.arrange(array, order);
  }

  /// Those of all parts that are drawn.
  void write_groups() {
    std::set<std::string_view> names;
    out_.key("groups"), out_.object();
    for (const auto& [in, node] : groups_)
      in->for_each(*node, [&, in = in](const JsonNode& group, int) {
        const std::string_view name = in->tree.key(group);
        if (name == "comment") return;
        if (!names.insert(name).second)
          in->refuse(group, fmt::format("another part has a group named {}, too", in_quotes(name)));
        out_.key(name), out_.stems_from(in->tree, group), out_.copy(in->tree, group);
      });
    out_.close();
  }

  /// What a rig needs to know which features there are, and what needs none.
  void write_rest() {
    const Reading& in = library_.topology().in();
    const RigPlace place{library_, geometry_, features_};
    const auto rig = [&](const char* key) { out_.key(key), write_rig(in, need(key), place, out_); };
    for (const char* key : {"canvas", "background", "light"})
      if (const JsonNode* own = style_.find(key))
        out_.key(key), write_rig(style_.in(), *own, place, out_);
      else
        rig(key);
    out_.key("palette"), write_palette(parts_, geometry_, style_, out_);
    out_.key("controls"), write_controls(in, need("controls"), style_, place, out_);
    rig("eyes");
    out_.key("mouth"), write_mouth(in, need("mouth"), place, out_);
    out_.key("turn"), write_turn(in, need("turn"), place, out_);
    out_.key("muscles");
    write_muscles(in, need("muscles"), geometry_, features_, style_.find("muscles"), out_);
    for (const char* key : {"emotions", "expressions", "mood", "clips", "default_clip"})
      if (key != std::string_view("mood") || in.find(*library_.topology().node, key)) rig(key);
  }

  std::string credit() const {
    return recipe_.code.empty() ? "Composed of mien's parts"
                                : "Composed of mien's parts, code " + well_formed(recipe_.code);
  }

  /// The points and values that a part tells others, and what it covers.
  void tell(const Part& part, const std::string& family) {
    const Reading& in = part.at.in();
    PartFrame frame;
    if (const JsonNode* own = in.find(*part.at.node, "in")) frame = geometry_.frame(in, *own);
    if (const JsonNode* points = in.find(*part.at.node, "points"))
      in.for_each(*points, [&](const JsonNode& node, int) {
        const FoundPoint found = geometry_.point(in, node, frame, family);
        geometry_.add_point(in.tree.key(node), {found.at, found.depth, false});
      });
    if (const JsonNode* values = in.find(*part.at.node, "values"))
      in.for_each(*values, [&](const JsonNode& node, int) {
        geometry_.add_value(in.tree.key(node), geometry_.scalar(in, node, family));
      });
    if (const JsonNode* covers = in.find(*part.at.node, "covers"))
      in.for_each(*covers, [&](const JsonNode& node, int) {
        covers_.emplace_back(family, in.string(node));
      });
    if (const JsonNode* gone = in.find(*part.at.node, "gone"))
      in.for_each(*gone, [&](const JsonNode& node, int) { leave_out(in, node); });
  }

  /// Hair below a scarf covers no ears: what a covered part covers does not count.
  void cover() {
    std::set<std::string, std::less<>> told;
    for (const auto& [family, covered] : covers_) told.insert(covered);
    for (const auto& [family, covered] : covers_)
      if (!told.contains(family) && !told.contains(family + '/' + parts_.of(family)->name))
        covered_.insert(covered);
  }

  /// A feature that all faces share, which nobody with the part shows.
  void leave_out(const Reading& in, const JsonNode& feature) {
    const Reading& shared = library_.topology().in();
    std::vector<std::string_view> names;
    shared.for_each(need("features"), [&](const JsonNode& one, int) {
      names.push_back(shared.string(shared.need(one, "name")));
    });
    const std::string_view name = in.string(feature);
    if (std::find(names.begin(), names.end(), name) == names.end())
      in.refuse(feature, unknown_name("feature that all faces share", name, names));
    style_.leave_out(name);
  }

  /// What the topology's own features are beside comes first.
  void draw_families(bool first) {
    for (const Family& family : library_.families()) {
      const Part* part = parts_.of(family.name);
      if (part && family.first == first && !is_covered(family, *part)) draw(part->at, family.name);
    }
  }

  /// Whether another part covers the family, or this part of it.
  bool is_covered(const Family& family, const Part& part) const {
    return covered_.contains(family.name) || covered_.contains(family.name + '/' + part.name);
  }

  void draw(const LibraryNode& from, std::string_view family) {
    const Reading& in = from.in();
    if (const JsonNode* groups = in.find(*from.node, "groups")) groups_.emplace_back(&in, groups);
    if (const JsonNode* features = in.find(*from.node, "features"))
      in.for_each(*features, [&](const JsonNode& node, int) {
        flatten_feature(in, node, family, library_, style_, geometry_, features_, out_);
      });
  }

  /// "with": beside a feature that may not be there; "worn": beside some parts; and not of features that parts leave out.
  bool is_wanted(const Reading& in, const JsonNode& added) const {
    const JsonNode *with = in.find(added, "with"), *worn = in.find(added, "worn");
    if (with && !features_.find(in.string(*with))) return false;
    if (style_.leaves_out_all_of(added)) return false;
    return !worn || parts_.wears(in, *worn);
  }

  /// What the style adds may be beside all that parts drew.
  void draw_style() {
    features_.by_style = true;
    if (const JsonNode* adds = style_.find("adds"))
      style_.in().for_each(*adds, [&](const JsonNode& node, int) {
        if (!is_wanted(style_.in(), node)) return;
        flatten_feature(style_.in(), node, "", library_, style_, geometry_, features_, out_);
      });
  }

  const ChosenParts& parts_;
  const PartLibrary& library_;
  const Recipe& recipe_;
  PartGeometry geometry_;
  PartStyle style_;
  FlatFeatures features_;
  JsonTree tree_;
  TreeWriter out_{tree_};
  std::vector<std::pair<std::string, std::string>>
      covers_;  ///< a family whose part covers, what it covers
  std::set<std::string, std::less<>> covered_;
  std::vector<std::pair<const Reading*, const JsonNode*>> groups_;
};

}  // namespace

Expected<JsonTree> composed_face(const ChosenParts& parts) {
  try {
    return Composition(parts).tree();
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

Expected<std::string> face_text_from_recipe(const Recipe& recipe) try {
  const auto parts = ChosenParts::read(recipe);
  if (!parts) return parts.error();
  const auto tree = composed_face(*parts);
  if (!tree) return tree.error();
  return composed_text(*tree);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
