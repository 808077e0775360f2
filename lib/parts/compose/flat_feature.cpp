#include "lib/parts/compose/flat_feature.h"
#include "lib/math/degrees.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/flat_rig.h"
#include "lib/parts/compose/short_number.h"
#include "lib/parts/compose/style_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

constexpr double kAxis = 1e-9;             // nearer than this a point lies on the axis
constexpr std::size_t kMostPoints = 4000;  // of a feature, patterns included

/// A point of a list, or a reference to a slice.
struct ListPoint {
  FoundPoint found;
  std::string_view reference;  ///< "@mouth/spine/0"
  bool bend = false;
};

class Flattening {
 public:
  Flattening(const Reading& in, const JsonNode& node, std::string_view family,
             const PartLibrary& library, const PartStyle& style, PartGeometry& geometry,
             FlatFeatures& to, TreeWriter& out)
      : in_(in),
        node_(node),
        family_(family),
        library_(library),
        style_(style),
        geometry_(geometry),
        to_(to),
        out_(out) {
    if (const JsonNode* frame = in.find(node, "in")) frame_ = geometry.frame(in, *frame);
    const JsonNode& name = in.need(node, "name");
    name_ = in.checked_name(name, in.string(name));
    sided_ = in.find(node, "side") != nullptr;
  }

  void run() {
    if (is_empty_selection()) return;
    const std::string_view slot = in_.string(in_.need(node_, "slot"));
    hand_ = style_.hand(slot);
    const PartStyle::Role role = style_.role(in_, node_);
    const bool of_figure = !to_.by_style && style_.figure_has(slot);
    add(name_, role.name, of_figure ? figure_order() : order(),
        style_.replaces(role, "clip") ? Clips{} : clips());
    write(role, of_figure ? PartStyle::Members::figure : PartStyle::Members::all);
    add_depth();
    const bool painted = in_.find(node_, "paint") != nullptr;
    if (of_figure && style_.paints(role, painted)) write_seen(role);
  }

 private:
  std::size_t slot_place() const { return slot_named(in_, in_.need(node_, "slot"), library_); }
  std::size_t order() const { return 2 * slot_place() + 1; }
  /// What makes the figure is known before the first feature of a slot is drawn.
  std::size_t figure_order() const {
    return 2 * slot_named(style_.in(), *style_.figure_before(), library_);
  }

  using Clips = decltype(FlatFeatures::One::clips);

  /// What is written next is known by that name.
  void add(std::string_view name, std::string_view role, std::size_t order, Clips clips) {
    if (to_.find(name))
      in_.refuse(node_, fmt::format("another part has a feature named \"{}\", too", name));
    to_.add({slot_place(), out_.next(), name, role, side(), order, false, clips});
  }

  Clips clips() const {
    Clips found{};
    std::size_t count = 0;
    const auto note = [&](const JsonNode& one) {
      if (one.kind == JsonKind::string && count < found.size())
        found[count++] = out_.kept({in_.string(one)});
    };
    const JsonNode* clip = in_.find(node_, "clip");
    if (clip && clip->kind == JsonKind::array)
      in_.for_each(*clip, [&](const JsonNode& one, int) { note(one); });
    else if (clip)
      note(*clip);
    return found;
  }

  /// On which sides it is drawn.
  std::string_view side() const {
    const JsonNode* written = in_.find(node_, "side");
    if (!written) return {};
    const JsonNode* mirror = in_.find(node_, "mirror");
    return mirror && !in_.boolean(*mirror) ? in_.string(*written) : "both";
  }

  void write(const PartStyle::Role& role, PartStyle::Members which) {
    out_.stems_from(in_.tree, node_);
    out_.object();
    out_.key("name"), out_.string(name_);
    write_members(role, which);
    out_.close();
  }

  void write_members(const PartStyle::Role& role, PartStyle::Members which) {
    bool painted = false;
    in_.for_each(node_, [&](const JsonNode& member, int) {
      const std::string_view key = in_.tree.key(member);
      for (const std::string_view own :
           {"name", "slot", "role", "in", "turn", "half", "with", "worn", "comment"})
        if (key == own) return;
      if (style_.replaces(role, key) || !PartStyle::among(which, key)) return;
      painted = painted || key == "paint";
      out_.key(key);
      write_member(key, member);
    });
    int domes = 0;
    const auto placed = [&](const JsonNode& at) {
      if (style_.in().find(at, "raised")) raise_dome(domes++, at);
      return write_placed(style_.in(), at, {library_, geometry_, to_}, out_);
    };
    style_.write_members(role, painted, which, placed, out_);
  }

  /// A dome of a style's relief goes with the head's turn as a feature that lies so deep.
  void raise_dome(int dome, const JsonNode& center) {
    const std::string index = std::to_string(dome);
    const std::string_view slice = out_.kept({name_, "/relief/domes/", index, "/center"});
    to_.raised.push_back({slice, style_.in().number(style_.in().need(center, "raised"))});
  }

  /// The area of a feature that was known before, painted where the feature stood.
  void write_seen(const PartStyle::Role& role) {
    const std::string_view name = out_.kept({name_, "_seen"});
    add(name, "none", order(), {});
    out_.stems_from(in_.tree, node_);
    out_.object();
    out_.key("name"), out_.string(name);
    for (const char* key : {"side", "mirror"})
      if (const JsonNode* said = in_.find(node_, key)) out_.key(key), out_.copy(in_.tree, *said);
    out_.key("kind"), out_.string("area");
    out_.key("any"), out_.array(), out_.string(name_), out_.close();
    if (const JsonNode* clip = style_.figure_clip())
      out_.key("clip"), out_.copy(style_.in().tree, *clip);
    write_members(role, PartStyle::Members::paint);
    out_.close();
  }

  static bool is_operand(std::string_view key) {
    return key == "any" || key == "all" || key == "minus";
  }

  /// An area of roles that this face has nothing of.
  bool is_empty_selection() const {
    bool empty = false;
    in_.for_each(node_, [&](const JsonNode& member, int) {
      if (member.kind == JsonKind::object && is_operand(in_.tree.key(member)))
        empty =
            empty || selected_features(in_, member, order(), library_, to_, Operands::all).empty();
    });
    return empty;
  }

  void write_selection(const JsonNode& selection, Operands which) {
    out_.array();
    for (const std::string& name : selected_features(in_, selection, order(), library_, to_, which))
      if (name != name_) out_.kept_string(name);
    out_.close();
  }

  glm::dvec2 drawn(glm::dvec2 p) const { return short_pair(hand_ ? hand_->moved(p) : p); }

  void add_depth() {
    const JsonNode* turn = in_.find(node_, "turn");
    if (!turn) return;
    if (turn->kind == JsonKind::string) return to_.stand_still(name_);
    if (turn->kind == JsonKind::number) return to_.flat.push_back({name_, in_.number(*turn)});
    if (const JsonNode* plate = in_.find(*turn, "plate"))
      to_.plates.push_back({name_, in_.number(*plate)});
    else
      to_.raised.push_back({name_, in_.number(in_.need(*turn, "raised"))});
  }

  void write_member(std::string_view key, const JsonNode& member) {
    if (key == "points" || key == "spine") return write_points(key, list(member, half()));
    if (key == "loops" || key == "patch") return write_lists(key, member);
    if (key == "center" || key == "inner" || key == "upper" || key == "outer" || key == "lower")
      return write_single(key, member);
    if (key == "radii" && member.kind != JsonKind::string)
      return out_.pair(short_pair(geometry_.pair(in_, member, family_) * frame_.scale));
    constexpr std::array<std::string_view, 7> kLengths{"radius",  "half_width", "length", "corner",
                                                       "feather", "height",     "grow"};
    if (std::find(kLengths.begin(), kLengths.end(), key) != kLengths.end())
      return write_widths(member);
    if (key == "paint" && member.kind == JsonKind::object) return write_gradient(member);
    if (is_operand(key) && member.kind == JsonKind::object)
      return write_selection(member, key == "all" ? Operands::all : Operands::of_union);
    if (key == "left" || key == "right") return write_side(member);
    out_.copy(in_.tree, member);
  }

  bool half() const {
    const JsonNode* half = in_.find(node_, "half");
    return half && in_.boolean(*half);
  }

  void write_widths(const JsonNode& member) {
    const auto one = [&](const JsonNode& node, int at) {
      const double width = std::max(frame_.length(geometry_.scalar(in_, node, family_)), 0.0);
      out_.number(short_number(hand_ ? width * hand_->thickness(name_, at) : width));
    };
    if (member.kind != JsonKind::array) return one(member, 0);
    out_.array();
    in_.for_each(member, one);
    out_.close();
  }

  /// Its places are the frame's.
  void write_gradient(const JsonNode& member) {
    out_.object();
    in_.for_each(member, [&](const JsonNode& node, int) {
      const std::string_view key = in_.tree.key(node);
      out_.key(key);
      if ((key == "center" || key == "radii") && node.kind != JsonKind::string)
        out_.pair(short_pair(key == "radii" ? geometry_.pair(in_, node, family_) * frame_.scale
                                            : geometry_.point(in_, node, frame_, family_).at));
      else
        out_.copy(in_.tree, node);
    });
    out_.close();
  }

  /// What differs on one side: points are moved in the written side's frame, then mirrored.
  void write_side(const JsonNode& member) {
    const auto one = [&](const JsonNode& node) {
      out_.pair(drawn(mirrored(geometry_.point(in_, node, frame_, family_).at)));
    };
    in_.expect(member, JsonKind::object);
    out_.object();
    in_.for_each(member, [&](const JsonNode& node, int) {
      out_.key(in_.tree.key(node));
      if (node.kind != JsonKind::array) return one(node);
      out_.array();
      in_.for_each(node, [&](const JsonNode& point, int) { one(point); });
      out_.close();
    });
    out_.close();
  }

  static glm::dvec2 mirrored(glm::dvec2 p) { return {-p.x, p.y}; }

  void write_single(std::string_view key, const JsonNode& member) {
    if (member.kind == JsonKind::string && in_.string(member).starts_with('@'))
      return out_.string(in_.string(member));
    const FoundPoint found = geometry_.point(in_, member, frame_, family_);
    know(out_.kept({name_, "/", key}), found);
    out_.pair(drawn(found.at));
  }

  ListPoint list_point(const JsonNode& node) {
    ListPoint made;
    if (node.kind == JsonKind::string) {
      made.reference = in_.string(node);
      return made;
    }
    const JsonNode* last = nullptr;
    if (node.kind == JsonKind::array)
      for (const JsonNode* one = in_.tree.first(node); one; one = in_.tree.next(*one)) last = one;
    if (last && last->kind == JsonKind::string) {  // [x, y, "bend"], ["@name", "bend"]
      constexpr std::array<std::string_view, 1> kMarks{"bend"};
      in_.word(*last, "mark of a point", kMarks);
      made.bend = true;
      const JsonNode& first = *in_.tree.first(node);
      if (first.kind == JsonKind::string) {
        made.reference = in_.string(first);
      } else {
        const JsonNode& second = *in_.tree.next(first);
        made.found.at = frame_.place({in_.number(first), in_.number(second)});
      }
      return made;
    }
    if (node.kind == JsonKind::object)
      if (const JsonNode* bend = in_.find(node, "bend")) made.bend = in_.boolean(*bend);
    made.found = geometry_.point(in_, node, frame_, family_);
    return made;
  }

  /// Bumps along an ellipse: corners on it, bends beyond it, some farther than others.
  void add_scallops(const JsonNode& node, std::vector<ListPoint>& to) {
    const auto number = [&](std::string_view key) {
      return geometry_.scalar(in_, in_.need(node, key), family_);
    };
    const glm::dvec2 center = geometry_.pair(in_, in_.need(node, "center"), family_);
    const glm::dvec2 radii = geometry_.pair(in_, in_.need(node, "radii"), family_);
    const double from = number("from"), step = (number("to") - from) / number("count");
    constexpr double kMostBumps = 499;
    if (!(number("count") >= 1 && number("count") <= kMostBumps))
      in_.refuse(node, fmt::format("a scallop has 1 to {} bumps", kMostBumps));
    const int count = int(number("count"));
    const KeyedChance chance(seed_from_word(name_));
    const auto place = [&](double degrees, double reach) {
      ListPoint made;
      made.found.at = frame_.place(center + reach * radii * direction_at(degrees));
      return made;
    };
    for (int i = 0; i <= count; ++i) {
      to.push_back(place(from + step * i, 1.0));
      if (i == count) break;
      to.push_back(place(from + step * (i + 0.5),
                         1.0 + number("bump") * (0.85 + 0.3 * chance.share(std::uint64_t(i)))));
      to.back().bend = true;
    }
  }

  std::vector<ListPoint> list(const JsonNode& array, bool half) {
    std::vector<ListPoint> points;
    in_.expect(array, JsonKind::array);
    points.reserve(std::size_t(array.count) * (half ? 2 : 1));
    in_.for_each(array, [&](const JsonNode& node, int) {
      const JsonNode* scallop = node.kind == JsonKind::object ? in_.find(node, "scallop") : nullptr;
      if (scallop)
        add_scallops(*scallop, points);
      else
        points.push_back(list_point(node));
      if (points.size() > kMostPoints)
        in_.refuse(node, fmt::format("a feature has at most {} points", kMostPoints));
    });
    for (std::size_t i = half ? points.size() : 0; i-- > 0;) {
      if (std::abs(points[i].found.at.x) < kAxis) continue;
      ListPoint image = points[i];
      image.found.at = mirrored(image.found.at);
      points.push_back(std::move(image));
    }
    return points;
  }

  void write_points(std::string_view key, const std::vector<ListPoint>& points) {
    out_.array();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ListPoint& point = points[i];
      if (point.reference.empty()) {
        write_point(point);
        const fmt::format_int number(i);
        know(out_.kept({name_, "/", key, "/", {number.data(), number.size()}}), point.found);
      } else if (point.bend) {
        out_.array(), out_.string(point.reference), out_.string("bend"), out_.close();
      } else {
        out_.string(point.reference);
      }
    }
    out_.close();
  }

  void write_point(const ListPoint& point) {
    const glm::dvec2 at = drawn(point.found.at);
    out_.array(), out_.number(at.x), out_.number(at.y);
    if (point.bend) out_.string("bend");
    out_.close();
  }

  /// Loops of a path, rows of a patch.
  void write_lists(std::string_view key, const JsonNode& array) {
    const bool halved = half();
    in_.expect(array, JsonKind::array);
    out_.array();
    in_.for_each(array, [&](const JsonNode& loop, int i) {
      write_points(fmt::format("{}/{}", key, i), list(loop, halved));
    });
    out_.close();
  }

  /// From now on other parts can be beside this point.
  void know(std::string_view slice, const FoundPoint& found) {
    geometry_.add_point(slice, {found.at, found.depth, true});
    if (found.depth) to_.flat.push_back({slice, *found.depth});
    const int side = sided_ || std::abs(found.at.x) < kAxis ? 0 : found.at.x > 0.0 ? 1 : -1;
    for (const PointRide& ride : geometry_.rides(found))
      to_.add_ride(ride.slice, {slice, ride.weight, side, found.at});
  }

  const Reading& in_;
  const JsonNode& node_;
  std::string_view family_;
  const PartLibrary& library_;
  const PartStyle& style_;
  PartGeometry& geometry_;
  FlatFeatures& to_;
  TreeWriter& out_;
  PartFrame frame_;
  std::string_view name_;
  bool sided_ = false;
  const Hand* hand_ = nullptr;  ///< null: points and widths are as the part has them
};

}  // namespace

void flatten_feature(const Reading& in, const JsonNode& node, std::string_view family,
                     const PartLibrary& library, const PartStyle& style, PartGeometry& geometry,
                     FlatFeatures& to, TreeWriter& out) {
  Flattening(in, node, family, library, style, geometry, to, out).run();
}

}  // namespace mien
