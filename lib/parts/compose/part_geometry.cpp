#include "lib/parts/compose/part_geometry.h"
#include "lib/base/nearest_name.h"
#include "lib/math/degrees.h"

#include <algorithm>
#include <array>

namespace mien {
namespace {

struct PointKey {
  enum : std::size_t { adds, at, bend, comment, mirrored, plus, radius, rides, times, turn, xy };
};
constexpr KnownKeys<11> kPointKeys({"adds", "at", "bend", "comment", "mirrored", "plus", "radius",
                                    "rides", "times", "turn", "xy"});

struct ScalarKey {
  enum : std::size_t { of, is, adds, times, least, most };
};
constexpr KnownKeys<6> kScalarKeys({"of", "is", "adds", "times", "least", "most"});

}  // namespace

double PartLift::at(double y) const {
  const double risen = std::clamp((y - from) / (to - from), 0.0, 1.0);
  if (!ends) return by * risen;
  return by * risen * std::clamp((ends->second - y) / (ends->second - ends->first), 0.0, 1.0);
}

glm::dvec2 PartFrame::vector(glm::dvec2 v) const {
  v *= scale;
  return {v.x * cosine - v.y * sine, v.x * sine + v.y * cosine};
}

glm::dvec2 PartFrame::place(glm::dvec2 p) const {
  if (from.x != 0.0 && p.x <= 0.0) {  // a frame of the left side: what lies right is its image
    const glm::dvec2 image = p.x < 0.0 ? place({-p.x, p.y}) : to + vector(p - from);
    return {-image.x * (p.x < 0.0 ? 1.0 : 0.0), image.y};
  }
  double rise = 0.0;
  for (const PartLift& lift : lifts) rise += lift.at(p.y);
  return to + vector(p - from) + glm::dvec2{0.0, rise};
}

PartGeometry::PartGeometry(const PartLibrary& library, const Recipe& recipe) : library_(library) {
  values_of_numbers_.reserve(library.numbers().size());
  for (const LibraryNumber& number : library.numbers()) {
    const auto given = recipe.numbers.find(number.name);
    values_of_numbers_.push_back(given == recipe.numbers.end() ? number.rest : given->second);
  }
  const Reading& in = library.topology().in();
  const JsonNode& root = *library.topology().node;
  in.for_each(in.need(root, "anchors"), [&](const JsonNode& node, int) {
    anchors_.emplace_back(in.tree.key(node), in.string(node));
  });
  std::sort(anchors_.begin(), anchors_.end());
  in.for_each(in.need(root, "frames"), [&](const JsonNode& node, int) {
    PartFrame made;
    made.from = pair(in, in.need(node, "from"), "");
    made.to = pair(in, in.need(node, "to"), "");
    if (const JsonNode* scale = in.find(node, "scale")) made.scale = pair(in, *scale, "");
    if (const JsonNode* tilt = in.find(node, "tilt")) {
      const glm::dvec2 way = direction_at(scalar(in, *tilt, ""));
      made.cosine = way.x, made.sine = way.y;
    }
    if (const JsonNode* lifts = in.find(node, "lifts"))
      in.for_each(*lifts, [&](const JsonNode& lift, int) {
        const JsonNode* clears = in.find(lift, "clears");
        if (clears) clearances_.push_back({in.tree.key(node), made.lifts.size(), clears});
        PartLift rise{.by = clears ? 0.0 : scalar(in, in.need(lift, "by"), "")};
        std::tie(rise.from, rise.to) = in.range(in.need(lift, "between"));
        if (const JsonNode* ends = in.find(lift, "ends")) rise.ends = in.range(*ends);
        made.lifts.push_back(rise);
      });
    frames_.emplace(in.tree.key(node), made);
  });
}

void PartGeometry::clear() {
  const Reading& in = library_.topology().in();
  for (const Clearance& clearance : clearances_) {
    PartPoint* point = told_point(in.string(in.need(*clearance.node, "at")));
    const double below = frame(in, in.need(*clearance.node, "frame")).to.y;
    if (!point) continue;
    const double lacks = below + in.number(in.need(*clearance.node, "by")) - point->at.y;
    PartLift& lift = frames_.find(clearance.frame)->second.lifts[clearance.lift];
    lift.by = 1;
    const double share = lift.at(point->at.y);
    const double most = in.number(in.need(*clearance.node, "most"));
    lift.by = lacks > 0 && share > 0 ? std::min(lacks / share, most) : 0;
    point->at.y += lift.by * share;
  }
}

double PartGeometry::value(std::string_view number) const {
  return value(*library_.find_number(number));
}

double PartGeometry::value(const LibraryNumber& number) const {
  return values_of_numbers_[std::size_t(&number - library_.numbers().data())];
}

const LibraryNumber& PartGeometry::number(const Reading& in, const JsonNode& node,
                                          std::string_view name, std::string_view family) const {
  const LibraryNumber* number = library_.find_number(name, family);
  if (number) return *number;
  std::vector<std::string_view> names;
  for (const LibraryNumber& one : library_.numbers()) names.push_back(one.name);
  in.refuse(node, unknown_name("number", name, names));
}

template <class Each>
void PartGeometry::each_add(const Reading& in, const JsonNode* adds, std::string_view family,
                            Each&& each) const {
  if (!adds) return;
  in.expect(*adds, JsonKind::object);
  in.for_each(*adds, [&](const JsonNode& add, int) {
    const LibraryNumber& by = number(in, add, in.tree.key(add), family);
    each(value(by) - by.rest, add);
  });
}

/// A value that a part tells.
double PartGeometry::told(const Reading& in, const JsonNode& name) const {
  const auto found = values_.find(in.string(name));
  if (found != values_.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, value] : values_) names.push_back(known);
  in.refuse(name, unknown_name("value that a part tells", in.string(name), names));
}

double PartGeometry::scalar(const Reading& in, const JsonNode& node,
                            std::string_view family) const {
  if (node.kind != JsonKind::object) return in.number(node);
  const auto has = in.tree.members(node, kScalarKeys);
  double sum = has[ScalarKey::of]
                   ? told(in, *has[ScalarKey::of])
                   : in.number(has[ScalarKey::is] ? *has[ScalarKey::is] : in.need(node, "is"));
  each_add(in, has[ScalarKey::adds], family,
           [&](double by, const JsonNode& add) { sum += by * in.number(add); });
  if (const JsonNode* times = has[ScalarKey::times])
    sum *= value(number(in, *times, in.string(*times), family));
  if (has[ScalarKey::least]) sum = std::max(sum, in.number(*has[ScalarKey::least]));
  if (has[ScalarKey::most]) sum = std::min(sum, in.number(*has[ScalarKey::most]));
  return sum;
}

glm::dvec2 PartGeometry::pair(const Reading& in, const JsonNode& node,
                              std::string_view family) const {
  if (node.kind == JsonKind::array) return in.pair(node);
  return pair(in, node, in.tree.members(node, kPointKeys), family);
}

glm::dvec2 PartGeometry::pair(const Reading& in, const JsonNode& node, const PointMembers& has,
                              std::string_view family) const {
  const JsonNode* radius = has[PointKey::radius];
  const JsonNode* own = has[radius ? PointKey::times : PointKey::xy];
  glm::dvec2 sum = in.pair(own ? *own : in.need(node, radius ? "times" : "xy"));
  each_add(in, has[PointKey::adds], family,
           [&](double by, const JsonNode& add) { sum += by * in.pair(add); });
  if (radius) sum *= told(in, *radius);
  return sum;
}

PartPoint* PartGeometry::told_point(std::string_view name) {
  const auto name_of = [&](int known) { return points_[std::size_t(known)].name; };
  const int known = point_of_.find(name, name_of);
  return known >= 0 ? &points_[std::size_t(known)].point : nullptr;
}

void PartGeometry::add_point(std::string_view name, PartPoint point) {
  if (PartPoint* known = told_point(name)) {
    *known = point;
    return;
  }
  point_of_.enter(name, int(points_.size()));
  points_.push_back({name, point});
}

const PartGeometry::NamedPoint* PartGeometry::find_point(std::string_view name) const {
  const auto anchor =
      std::lower_bound(anchors_.begin(), anchors_.end(), name,
                       [](const auto& one, std::string_view wanted) { return one.first < wanted; });
  if (anchor != anchors_.end() && anchor->first == name) name = anchor->second;
  const int found =
      point_of_.find(name, [&](int known) { return points_[std::size_t(known)].name; });
  return found < 0 ? nullptr : &points_[std::size_t(found)];
}

FoundPoint PartGeometry::beside(const Reading& in, const JsonNode& at,
                                std::optional<double> share) const {
  const std::string_view name = share ? in.tree.key(at) : in.string(at);
  const NamedPoint* known = find_point(name);
  if (!known) {
    std::vector<std::string_view> names;
    for (const auto& [anchor, slice] : anchors_) names.push_back(anchor);
    for (const NamedPoint& one : points_) names.push_back(one.name);
    std::sort(names.begin(), names.end());
    in.refuse(at, unknown_name("point", name, names));
  }
  FoundPoint found{known->point.at, known->point.depth, {rides_.size(), 0}};
  if (known->point.is_slice)
    rides_.push_back({known->name, share.value_or(1.0)}), found.rides.count = 1;
  return found;
}

FoundPoint PartGeometry::point(const Reading& in, const JsonNode& node, const PartFrame& frame,
                               std::string_view family) const {
  FoundPoint found;
  if (node.kind != JsonKind::object) {
    found.at = frame.place(pair(in, node, family));
    return found;
  }
  const JsonNode* unknown = nullptr;
  const PointMembers has = in.tree.members(node, kPointKeys, &unknown);
  if (has[PointKey::at])
    found = beside(in, *has[PointKey::at], has, frame, family);
  else
    found.at = frame.place(pair(in, node, has, family));
  if (unknown)  // a misspelt key would be left out without a word
    in.refuse(*unknown, unknown_name("key of a point", in.tree.key(*unknown),
                                     {kPointKeys.names.begin(), kPointKeys.names.end()}));
  if (has[PointKey::turn]) found.depth = in.number(*has[PointKey::turn]);
  if (const JsonNode* rides = has[PointKey::rides]) {
    in.expect(*rides, JsonKind::object);
    found.rides = {rides_.size(), 0};
    in.for_each(*rides, [&](const JsonNode& one, int) {
      found.rides.count += beside(in, one, in.number(one)).rides.count;
    });
  }
  return found;
}

FoundPoint PartGeometry::beside(const Reading& in, const JsonNode& at, const PointMembers& has,
                                const PartFrame& frame, std::string_view family) const {
  FoundPoint found;
  if (at.kind == JsonKind::object) {
    found.rides.first = rides_.size();
    in.for_each(at, [&](const JsonNode& one, int) {
      const double share = in.number(one);
      const FoundPoint other = beside(in, one, share);
      found.at += share * other.at;
      if (other.depth) found.depth = found.depth.value_or(0.0) + share * *other.depth;
      found.rides.count += other.rides.count;
    });
  } else {
    found = beside(in, at, {});
  }
  // Of the other side; what is added is not: a glint is on the lamp's side in both eyes.
  if (has[PointKey::mirrored] && in.boolean(*has[PointKey::mirrored])) found.at.x = -found.at.x;
  if (has[PointKey::plus]) found.at += frame.vector(pair(in, *has[PointKey::plus], family));
  each_add(in, has[PointKey::adds], family,
           [&](double by, const JsonNode& add) { found.at += by * frame.vector(in.pair(add)); });
  return found;
}

const PartFrame& PartGeometry::frame(const Reading& in, const JsonNode& node) const {
  const auto found = frames_.find(in.string(node));
  if (found != frames_.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [name, frame] : frames_) names.push_back(name);
  in.refuse(node, unknown_name("frame", in.string(node), names));
}

}  // namespace mien
