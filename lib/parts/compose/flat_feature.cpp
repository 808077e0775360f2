#include "lib/parts/compose/flat_feature.h"
#include "lib/base/nearest_name.h"
#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"
#include "lib/parts/code/keyed_chance.h"
#include "lib/parts/compose/short_number.h"

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
  std::string reference;  ///< "@mouth/spine/0"
  bool bend = false;

  std::string text() const {
    if (!reference.empty())
      return bend ? fmt::format("[{}, \"bend\"]", json_string(reference)) : json_string(reference);
    std::string text = short_pair(found.at);
    if (bend) text.pop_back(), text += ", \"bend\"]";
    return text;
  }
};

class Flattening {
 public:
  Flattening(const Reading& in, const JsonNode& node, std::string_view family,
             const PartLibrary& library, const PartStyle& style, PartGeometry& geometry,
             FlatFeatures& to)
      : in_(in),
        node_(node),
        family_(family),
        library_(library),
        style_(style),
        geometry_(geometry),
        to_(to) {
    if (const JsonNode* frame = in.find(node, "in")) frame_ = geometry.frame(in, *frame);
    name_ = in.name(in.need(node, "name"));
    sided_ = in.find(node, "side") != nullptr;
  }

  void run() {
    if (!to_.names.insert(name_).second)
      in_.refuse(node_, fmt::format("another part has a feature named \"{}\", too", name_));
    std::string text = fmt::format("{{\"name\": {}", json_string(name_));
    bool painted = false;
    in_.for_each(node_, [&](const JsonNode& member, int) {
      const std::string_view key = in_.tree.key(member);
      for (const std::string_view own : {"name", "slot", "role", "in", "turn", "half", "comment"})
        if (key == own) return;
      if (style_.replaces(in_, node_, key)) return;
      painted = painted || key == "paint";
      text += fmt::format(", {}: {}", json_string(key), member_text(key, member));
    });
    text += style_.members(in_, node_, painted) + "}";
    add_depth();
    to_.features.push_back({slot(), std::move(text)});
  }

 private:
  std::size_t slot() const {
    const JsonNode& wanted = in_.need(node_, "slot");
    const Reading& in = library_.topology().in();
    std::vector<std::string_view> names;
    in.for_each(in.need(*library_.topology().node, "slots"),
                [&](const JsonNode& one, int) { names.push_back(in.string(one)); });
    const auto found = std::ranges::find(names, in_.string(wanted));
    if (found == names.end()) in_.refuse(wanted, unknown_name("slot", in_.string(wanted), names));
    return std::size_t(found - names.begin());
  }

  void add_depth() {
    const JsonNode* turn = in_.find(node_, "turn");
    if (!turn) return;
    if (turn->kind == JsonKind::string) return to_.still.push_back(name_);
    if (turn->kind == JsonKind::number) {
      to_.flat.emplace(name_, in_.number(*turn));
      return;
    }
    if (const JsonNode* plate = in_.find(*turn, "plate"))
      to_.plates.emplace(name_, in_.number(*plate));
    else
      to_.raised.emplace(name_, in_.number(in_.need(*turn, "raised")));
  }

  std::string member_text(std::string_view key, const JsonNode& member) {
    if (key == "points" || key == "spine") return list_text(std::string(key), member);
    if (key == "loops" || key == "patch") return lists_text(std::string(key), member);
    if (key == "center" || key == "inner" || key == "upper" || key == "outer" || key == "lower")
      return single_text(std::string(key), member);
    if (key == "radii") {
      if (member.kind == JsonKind::string) return json_string(in_.string(member));
      const glm::dvec2 radii = geometry_.pair(in_, member, family_) * frame_.scale;
      return short_pair(radii);
    }
    constexpr std::array<std::string_view, 5> kLengths{"radius", "half_width", "length", "corner",
                                                       "feather"};
    if (std::ranges::find(kLengths, key) != kLengths.end()) return width_text(member);
    if (key == "paint") return paint_text(member);
    if (key == "contour" || key == "relief" || key == "shadow" || key == "glow")
      return copied(member);
    if (key == "left" || key == "right") return side_text(member);
    return copied(member);
  }

  std::string copied(const JsonNode& node) const { return json_copy(in_, node); }

  std::string width_text(const JsonNode& member) const {
    const auto one = [&](const JsonNode& node) {
      const double width = std::max(frame_.length(geometry_.scalar(in_, node, family_)), 0.0);
      return short_number(width);
    };
    if (member.kind != JsonKind::array) return one(member);
    std::string text;
    in_.for_each(member,
                 [&](const JsonNode& node, int i) { text += (i ? ", " : "[") + one(node); });
    return text + "]";
  }

  /// A colour's name, or a gradient whose places are the frame's.
  std::string paint_text(const JsonNode& member) {
    if (member.kind != JsonKind::object) return copied(member);
    std::string text;
    in_.for_each(member, [&](const JsonNode& node, int i) {
      const std::string_view key = in_.tree.key(node);
      std::string value;
      if ((key == "center" || key == "radii") && node.kind != JsonKind::string)
        value = key == "radii" ? short_pair(geometry_.pair(in_, node, family_) * frame_.scale)
                               : short_pair(geometry_.point(in_, node, frame_, family_).at);
      else
        value = copied(node);
      text += fmt::format("{}{}: {}", i ? ", " : "{", json_string(key), value);
    });
    return text + "}";
  }

  /// What differs on one side: points are moved in the written side's frame, then mirrored.
  std::string side_text(const JsonNode& member) {
    std::string text;
    in_.for_each(member, [&](const JsonNode& node, int i) {
      text += fmt::format("{}{}: ", i ? ", " : "{", json_string(in_.tree.key(node)));
      if (node.kind != JsonKind::array) {
        text += short_pair(mirrored(geometry_.point(in_, node, frame_, family_).at));
        return;
      }
      in_.for_each(node, [&](const JsonNode& point, int k) {
        text += k ? ", " : "[";
        text += short_pair(mirrored(geometry_.point(in_, point, frame_, family_).at));
      });
      text += "]";
    });
    return text + "}";
  }

  static glm::dvec2 mirrored(glm::dvec2 p) { return {-p.x, p.y}; }

  std::string single_text(const std::string& key, const JsonNode& member) {
    if (member.kind == JsonKind::string && !in_.string(member).empty() &&
        in_.string(member)[0] == '@')
      return json_string(in_.string(member));
    const FoundPoint found = geometry_.point(in_, member, frame_, family_);
    know(fmt::format("{}/{}", name_, key), found);
    return short_pair(found.at);
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
      const double a = degrees * 0.017453292519943295;
      ListPoint made;
      made.found.at = frame_.place(center + reach * radii * glm::dvec2{std::cos(a), std::sin(a)});
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

  std::string list_text(const std::string& key, const JsonNode& array) {
    const JsonNode* half = in_.find(node_, "half");
    const std::vector<ListPoint> points = list(array, half && in_.boolean(*half));
    return points_text(key, points);
  }

  std::string points_text(const std::string& key, const std::vector<ListPoint>& points) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) {
      text += (i ? ", " : "[") + points[i].text();
      if (points[i].reference.empty())
        know(fmt::format("{}/{}/{}", name_, key, i), points[i].found);
    }
    return text + "]";
  }

  /// Loops of a path, rows of a patch.
  std::string lists_text(const std::string& key, const JsonNode& array) {
    const JsonNode* half = in_.find(node_, "half");
    std::string text;
    in_.expect(array, JsonKind::array);
    in_.for_each(array, [&](const JsonNode& loop, int i) {
      text += (i ? ", " : "[") +
              points_text(fmt::format("{}/{}", key, i), list(loop, half && in_.boolean(*half)));
    });
    return text + "]";
  }

  /// From now on other parts can be beside this point.
  void know(const std::string& slice, const FoundPoint& found) {
    geometry_.add_point(slice, {found.at, found.depth, slice});
    if (found.depth) to_.flat[slice] = *found.depth;
    const int side = sided_ || std::abs(found.at.x) < kAxis ? 0 : found.at.x > 0.0 ? 1 : -1;
    for (const auto& [other, weight] : found.rides)
      to_.rides[other].push_back({slice, weight, side});
  }

  const Reading& in_;
  const JsonNode& node_;
  std::string_view family_;
  const PartLibrary& library_;
  const PartStyle& style_;
  PartGeometry& geometry_;
  FlatFeatures& to_;
  PartFrame frame_;
  std::string name_;
  bool sided_ = false;
};

}  // namespace

void flatten_feature(const Reading& in, const JsonNode& node, std::string_view family,
                     const PartLibrary& library, const PartStyle& style, PartGeometry& geometry,
                     FlatFeatures& to) {
  Flattening(in, node, family, library, style, geometry, to).run();
}

}  // namespace mien
