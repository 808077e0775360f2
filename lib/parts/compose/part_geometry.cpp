#include "lib/parts/compose/part_geometry.h"
#include "lib/base/nearest_name.h"
#include "lib/math/degrees.h"

#include <algorithm>
#include <array>

namespace mien {
namespace {

/// A misspelt key would be left out without a word.
void expect_point_keys(const Reading& in, const JsonNode& point) {
  static constexpr std::array<std::string_view, 11> kKeys{"adds",     "at",   "bend",   "comment",
                                                          "mirrored", "plus", "radius", "rides",
                                                          "times",    "turn", "xy"};
  in.for_each(point, [&](const JsonNode& one, int) {
    const std::string_view key = in.tree.key(one);
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
      in.refuse(one, unknown_name("key of a point", key, {kKeys.begin(), kKeys.end()}));
  });
}

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
    anchors_.emplace(in.tree.key(node), in.string(node));
  });
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
        PartLift rise{.by = scalar(in, in.need(lift, "by"), "")};
        std::tie(rise.from, rise.to) = in.range(in.need(lift, "between"));
        if (const JsonNode* ends = in.find(lift, "ends")) rise.ends = in.range(*ends);
        made.lifts.push_back(rise);
      });
    frames_.emplace(in.tree.key(node), made);
  });
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
void PartGeometry::each_add(const Reading& in, const JsonNode& node, std::string_view family,
                            Each&& each) const {
  const JsonNode* adds = in.find(node, "adds");
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
  double sum = 0.0;
  if (const JsonNode* of = in.find(node, "of")) {
    sum = told(in, *of);
  } else {
    sum = in.number(in.need(node, "is"));
  }
  each_add(in, node, family, [&](double by, const JsonNode& add) { sum += by * in.number(add); });
  if (const JsonNode* times = in.find(node, "times"))
    sum *= value(number(in, *times, in.string(*times), family));
  if (const JsonNode* least = in.find(node, "least")) sum = std::max(sum, in.number(*least));
  if (const JsonNode* most = in.find(node, "most")) sum = std::min(sum, in.number(*most));
  return sum;
}

glm::dvec2 PartGeometry::pair(const Reading& in, const JsonNode& node,
                              std::string_view family) const {
  if (const JsonNode* radius = node.kind == JsonKind::object ? in.find(node, "radius") : nullptr) {
    glm::dvec2 times = in.pair(in.need(node, "times"));
    each_add(in, node, family, [&](double by, const JsonNode& add) { times += by * in.pair(add); });
    return told(in, *radius) * times;
  }
  const bool plain = node.kind == JsonKind::array;
  glm::dvec2 sum = in.pair(plain ? node : in.need(node, "xy"));
  if (plain) return sum;
  each_add(in, node, family, [&](double by, const JsonNode& add) { sum += by * in.pair(add); });
  return sum;
}

FoundPoint PartGeometry::beside(const Reading& in, const JsonNode& at,
                                std::optional<double> share) const {
  const std::string_view name = share ? in.tree.key(at) : in.string(at);
  const auto other = anchors_.find(name);
  const auto point = points_.find(other == anchors_.end() ? name : other->second);
  if (point == points_.end()) {
    std::vector<std::string_view> names;
    for (const auto& [known, slice] : anchors_) names.push_back(known);
    for (const auto& [known, place] : points_) names.push_back(known);
    std::sort(names.begin(), names.end());
    in.refuse(at, unknown_name("point", name, names));
  }
  FoundPoint found{point->second.at, point->second.depth, {}};
  if (point->second.is_slice) found.rides.emplace_back(point->first, share.value_or(1.0));
  return found;
}

FoundPoint PartGeometry::point(const Reading& in, const JsonNode& node, const PartFrame& frame,
                               std::string_view family) const {
  FoundPoint found;
  const JsonNode* at = node.kind == JsonKind::object ? in.find(node, "at") : nullptr;
  if (!at) {
    found.at = frame.place(pair(in, node, family));
  } else {
    if (at->kind == JsonKind::object) {
      in.for_each(*at, [&](const JsonNode& one, int) {
        const double share = in.number(one);
        const FoundPoint other = beside(in, one, share);
        found.at += share * other.at;
        if (other.depth) found.depth = found.depth.value_or(0.0) + share * *other.depth;
        found.rides.insert(found.rides.end(), other.rides.begin(), other.rides.end());
      });
    } else {
      found = beside(in, *at, {});
    }
    // Of the other side; what is added is not: a glint is on the lamp's side in both eyes.
    if (const JsonNode* other = in.find(node, "mirrored"); other && in.boolean(*other))
      found.at.x = -found.at.x;
    if (const JsonNode* plus = in.find(node, "plus"))
      found.at += frame.vector(pair(in, *plus, family));
    each_add(in, node, family,
             [&](double by, const JsonNode& add) { found.at += by * frame.vector(in.pair(add)); });
  }
  if (node.kind != JsonKind::object) return found;
  expect_point_keys(in, node);
  if (const JsonNode* depth = in.find(node, "turn")) found.depth = in.number(*depth);
  if (const JsonNode* rides = in.find(node, "rides")) {
    found.rides.clear();
    in.expect(*rides, JsonKind::object);
    in.for_each(*rides, [&](const JsonNode& one, int) {
      const FoundPoint other = beside(in, one, in.number(one));
      found.rides.insert(found.rides.end(), other.rides.begin(), other.rides.end());
    });
  }
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
