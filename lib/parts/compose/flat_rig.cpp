#include "lib/parts/compose/flat_rig.h"
#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"
#include "lib/parts/compose/short_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kFarOrigin = 20;  // farther than this a muscle's origin is a direction

/// "brow" of "brow/spine/0", "upper_edge" of "upper_edge.left/spine/2".
std::string_view feature_of(std::string_view slice) {
  return slice.substr(0, slice.find_first_of("./"));
}

class Muscles {
 public:
  Muscles(const Reading& in, const PartGeometry& geometry, const FlatFeatures& features)
      : in_(in), geometry_(geometry), features_(features) {}

  std::string group(const JsonNode& node) const {
    const PartFrame& frame = geometry_.frame(in_, in_.need(node, "in"));
    const std::vector<double> two = in_.numbers(in_.need(node, "origin"), 2, 2);
    const glm::dvec2 origin{two[0], two[1]};
    const bool far = std::max(std::abs(origin.x), std::abs(origin.y)) > kFarOrigin;
    const glm::dvec2 way = glm::normalize(origin - frame.from);
    const double stroke =
        roomed(node, in_.number(in_.need(node, "stroke")) * glm::length(way * frame.scale));
    const JsonNode* side = in_.find(node, "side");
    std::string text =
        fmt::format("{{\"name\": {}", json_string(in_.string(in_.need(node, "name"))));
    if (side) text += fmt::format(", \"side\": {}", json_string(in_.string(*side)));
    text +=
        fmt::format(", \"strength\": {}, \"stroke\": {}, \"origin\": {}, \"attach\": {}",
                    short_number(in_.number(in_.need(node, "strength"))), short_number(stroke),
                    short_pair(far ? origin : frame.place(origin)), attachments(node, frame, 0));
    if (side && has_sides(node))
      text += fmt::format(", \"left\": {{\"attach\": {}}}, \"right\": {{\"attach\": {}}}",
                          attachments(node, frame, 1), attachments(node, frame, -1));
    return text + "}";
  }

 private:
  /// A muscle stops where there is no more room: {"from": POINT, "to": POINT, "less": d, "times": k, "least": d}.
  double roomed(const JsonNode& node, double stroke) const {
    const JsonNode* room = in_.find(node, "room");
    if (!room) return stroke;
    const auto height = [&](std::string_view key) {
      return geometry_.point(in_, in_.need(*room, key), {}, "").at.y;
    };
    const double free = height("to") - height("from") - in_.number(in_.need(*room, "less"));
    const double most =
        std::max(free * in_.number(in_.need(*room, "times")), in_.number(in_.need(*room, "least")));
    return std::min(stroke, most);
  }

  template <class Each>
  void each_ride(const JsonNode& node, Each&& each) const {
    in_.for_each(in_.need(node, "attach"), [&](const JsonNode& held, int) {
      const auto found = features_.rides.find(in_.tree.key(held));
      if (found == features_.rides.end() || held.kind != JsonKind::number) return;
      for (const Ride& ride : found->second) each(ride, in_.number(held));
    });
  }

  bool has_sides(const JsonNode& node) const {
    bool any = false;
    each_ride(node, [&](const Ride& ride, double) { any = any || ride.side != 0; });
    return any;
  }

  /// Of the muscle on a side; 0: what both sides have.
  std::string attachments(const JsonNode& node, const PartFrame& frame, int side) const {
    std::map<std::string, std::string> held;
    in_.for_each(in_.need(node, "attach"), [&](const JsonNode& one, int) {
      const std::string_view key = in_.tree.key(one);
      if (!features_.names.contains(feature_of(key))) return;
      if (one.kind == JsonKind::number)
        held[std::string(key)] = short_number(in_.number(one));
      else
        held[std::string(key)] = fmt::format(
            "{{\"weight\": {}, \"stroke\": {}}}", short_number(in_.number(in_.need(one, "weight"))),
            short_number(frame.length(in_.number(in_.need(one, "stroke")))));
    });
    std::map<std::string, double> rides;
    const bool sided = in_.find(node, "side") != nullptr;
    each_ride(node, [&](const Ride& ride, double weight) {
      if (sided && ride.side != 0 && ride.side != side) return;
      rides[ride.slice] += weight * ride.weight;
    });
    for (const auto& [slice, weight] : rides)
      held[slice] = short_number(std::clamp(weight, 0.0, 1.0));
    std::string text;
    for (const auto& [slice, value] : held)
      text += fmt::format("{}{}: {}", text.empty() ? "{" : ", ", json_string(slice), value);
    return text.empty() ? "{}" : text + "}";
  }

  const Reading& in_;
  const PartGeometry& geometry_;
  const FlatFeatures& features_;
};

std::string depths_text(const std::map<std::string, double>& depths) {
  std::string text;
  for (const auto& [name, depth] : depths)
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : ", ", json_string(name), short_number(depth));
  return "{" + text + "}";
}

}  // namespace

std::string rig_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry) {
  return json_copy(in, node, [&](const JsonNode& at) -> std::optional<std::string> {
    if (at.kind != JsonKind::object) return {};
    const auto frame = [&] { return geometry.frame(in, in.need(at, "in")); };
    if (const JsonNode* point = in.find(at, "$point"))
      return short_pair(geometry.point(in, *point, frame(), "").at);
    if (const JsonNode* vector = in.find(at, "$vector"))
      return short_pair(frame().vector(geometry.pair(in, *vector, "")));
    if (const JsonNode* length = in.find(at, "$length"))
      return short_number(in.number(*length) * frame().scale.x);
    if (const JsonNode* value = in.find(at, "$value"))
      return short_number(geometry.scalar(in, *value, ""));
    return {};
  });
}

std::string muscles_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                         const FlatFeatures& features) {
  const Muscles muscles(in, geometry, features);
  std::string text = fmt::format("{{\"stiffness\": {}, \"damping\": {}, \"groups\": [",
                                 short_number(in.number(in.need(node, "stiffness"))),
                                 short_number(in.number(in.need(node, "damping"))));
  in.for_each(in.need(node, "groups"), [&](const JsonNode& group, int i) {
    text += (i ? ",\n    " : "\n    ") + muscles.group(group);
  });
  return text + "]}";
}

std::string turn_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                      const FlatFeatures& features) {
  std::string text = rig_text(in, node, geometry);
  text.pop_back();
  std::string still;
  for (const std::string& name : features.still)
    still += (still.empty() ? "" : ", ") + json_string(name);
  text += fmt::format(", \"still\": [{}], \"flat\": {}, \"raised\": {}", still,
                      depths_text(features.flat), depths_text(features.raised));
  if (!features.plates.empty()) text += ", \"plate\": " + depths_text(features.plates);
  return text + "}";
}

}  // namespace mien
