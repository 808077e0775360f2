#include "lib/parts/compose/flat_rig.h"
#include "lib/base/nearest_name.h"
#include "lib/parts/compose/short_number.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>
#include <vector>

namespace mien {
namespace {

constexpr std::string_view kJaw = "jaw/open";  // the mouth's own, a ratio
constexpr double kFarOrigin = 20;              // farther than this a muscle's origin is a direction

/// "brow" of "brow/spine/0", "upper_edge" of "upper_edge.left/spine/2".
std::string_view feature_of(std::string_view slice) {
  return slice.substr(0, slice.find_first_of("./"));
}

class Muscles {
 public:
  Muscles(const Reading& in, const PartGeometry& geometry, const FlatFeatures& features,
          const JsonNode* more, TreeWriter& out)
      : in_(in), geometry_(geometry), features_(features), more_(more), out_(out) {}

  void write_group(const JsonNode& node) {
    const PartFrame& frame = geometry_.frame(in_, in_.need(node, "in"));
    const glm::dvec2 origin = in_.pair(in_.need(node, "origin"));
    const bool far = std::max(std::abs(origin.x), std::abs(origin.y)) > kFarOrigin;
    const glm::dvec2 way = glm::normalize(origin - frame.from);
    const double stroke =
        roomed(node, in_.number(in_.need(node, "stroke")) * glm::length(way * frame.scale));
    const JsonNode* side = in_.find(node, "side");
    out_.object();
    out_.key("name"), out_.string(in_.string(in_.need(node, "name")));
    if (side) out_.key("side"), out_.string(in_.string(*side));
    out_.key("strength"), out_.number(short_number(in_.number(in_.need(node, "strength"))));
    out_.key("stroke"), out_.number(short_number(stroke));
    out_.key("origin"), out_.pair(short_pair(far ? origin : frame.place(origin)));
    write_attachments(node, frame, 0);
    if (side && has_sides(node))
      for (const auto& [key, which] : {std::pair{"left", 1}, {"right", -1}}) {
        out_.key(key), out_.object();
        write_attachments(node, frame, which);
        out_.close();
      }
    out_.close();
  }

 private:
  /// A muscle stops where there is no more room, upwards or, with "along": "x", outwards:
  /// {"from": POINT, "to": POINT, "less": NUMBER, "times": k, "least": d}.
  double roomed(const JsonNode& node, double stroke) const {
    const JsonNode* room = in_.find(node, "room");
    if (!room) return stroke;
    const int axis = along(*room);
    const auto place = [&](std::string_view key) {
      return geometry_.point(in_, in_.need(*room, key), {}, "").at[axis];
    };
    const double less = geometry_.scalar(in_, in_.need(*room, "less"), "");
    const double free = place("to") - place("from") - less;
    const double most =
        std::max(free * in_.number(in_.need(*room, "times")), in_.number(in_.need(*room, "least")));
    return std::min(stroke, most);
  }

  int along(const JsonNode& room) const {
    const JsonNode* said = in_.find(room, "along");
    if (!said) return 1;
    const std::string_view axis = in_.string(*said);
    if (axis != "x" && axis != "y") in_.refuse(*said, "room goes along \"x\" or \"y\"");
    return axis == "x" ? 0 : 1;
  }

  template <class Each>
  void each_ride(const JsonNode& node, Each&& each) const {
    in_.for_each(in_.need(node, "attach"), [&](const JsonNode& held, int) {
      if (held.kind != JsonKind::number) return;
      features_.for_each_ride(in_.tree.key(held),
                              [&](const Ride& ride) { each(ride, in_.number(held)); });
    });
  }

  bool has_sides(const JsonNode& node) const {
    bool any = false;
    each_ride(node, [&](const Ride& ride, double) { any = any || ride.side != 0; });
    return any;
  }

  /// What a muscle holds: a weight, and a stroke of its own where it has one.
  struct Held {
    std::string_view slice;
    double weight;
    std::optional<double> stroke;
    bool rides = false;
  };

  /// What rides with what a muscle holds is held by the sum of all its ways, and not by itself.
  void add_ride(std::string_view slice, double weight) {
    const auto known = std::find_if(held_.begin(), held_.end(),
                                    [&](const Held& one) { return one.slice == slice; });
    if (known == held_.end())
      held_.push_back({slice, weight, {}, true});
    else if (known->rides)
      known->weight += weight;
    else
      *known = {slice, weight, {}, true};
  }

  /// What is held twice is held as was said last.
  void hold(Held held) {
    const auto known = std::find_if(held_.begin(), held_.end(),
                                    [&](const Held& one) { return one.slice == held.slice; });
    (known == held_.end() ? held_.emplace_back() : *known) = held;
  }

  void hold(const JsonNode& one, const PartFrame& frame) {
    const std::string_view key = in_.tree.key(one);
    const bool of_jaw = key == kJaw;
    if (!of_jaw && !features_.find(feature_of(key))) return;
    if (one.kind == JsonKind::number) return hold({key, in_.number(one), {}});
    const double stroke = in_.number(in_.need(one, "stroke"));
    hold({key, in_.number(in_.need(one, "weight")), of_jaw ? stroke : frame.length(stroke)});
  }

  /// Of the muscle on a side; 0: what both sides have.
  void write_attachments(const JsonNode& node, const PartFrame& frame, int side) {
    held_.clear();
    const auto each = [&](const JsonNode& one, int) { hold(one, frame); };
    in_.for_each(in_.need(node, "attach"), each);
    if (const JsonNode* more =
            more_ ? in_.find(*more_, in_.string(in_.need(node, "name"))) : nullptr)
      in_.for_each(*more, each);
    const bool sided = in_.find(node, "side") != nullptr;
    each_ride(node, [&](const Ride& ride, double weight) {
      if (!sided || ride.side == 0 || ride.side == side) add_ride(ride.slice, weight * ride.weight);
    });
    std::sort(held_.begin(), held_.end(),
              [](const Held& a, const Held& b) { return a.slice < b.slice; });
    write_held();
  }

  void write_held() {
    out_.key("attach"), out_.object();
    for (const Held& held : held_) {
      out_.key(held.slice);
      if (held.stroke) {
        out_.object();
        out_.key("weight"), out_.number(short_number(held.weight));
        out_.key("stroke"), out_.number(short_number(*held.stroke));
        out_.close();
      } else {
        out_.number(short_number(held.rides ? std::clamp(held.weight, 0.0, 1.0) : held.weight));
      }
    }
    out_.close();
  }

  const Reading& in_;
  const PartGeometry& geometry_;
  const FlatFeatures& features_;
  const JsonNode* more_;
  TreeWriter& out_;
  std::vector<Held> held_;  ///< by the muscle that is written
};

/// By name: as text, faces are compared line by line.
void write_depths(std::vector<Depth> depths, TreeWriter& to) {
  std::sort(depths.begin(), depths.end(),
            [](const Depth& a, const Depth& b) { return a.name < b.name; });
  to.object();
  for (const auto& [name, depth] : depths) to.key(name), to.number(short_number(depth));
  to.close();
}

/// Writes what stands for an object of the rig that has to be put in a frame.
class Placing {
 public:
  Placing(const Reading& in, const RigPlace& place, TreeWriter& to)
      : in_(in), place_(place), to_(to) {}

  bool operator()(const JsonNode& at) const {
    const JsonNode* first = in_.tree.first(at);
    const std::string_view key = first ? in_.tree.key(*first) : std::string_view{};
    if (!key.starts_with('$')) return false;
    const PartGeometry& geometry = place_.geometry;
    const auto frame = [&] { return geometry.frame(in_, in_.need(at, "in")); };
    if (key == "$point")
      to_.pair(short_pair(geometry.point(in_, *first, frame(), "").at));
    else if (key == "$vector")
      to_.pair(short_pair(frame().vector(geometry.pair(in_, *first, ""))));
    else if (key == "$length")
      to_.number(short_number(in_.number(*first) * frame().scale.x));
    else if (key == "$value")
      to_.number(short_number(geometry.scalar(in_, *first, "")));
    else if (key == "$rise")
      to_.number(short_number(least_rise(*first)));
    else if (key == "$still")
      write_still(*first, in_.need(at, "slots"));
    else if (key == "$still_of")
      write_names(*first);
    else
      in_.refuse(*first, unknown_name("way to put it in a frame", key,
                                      {"$point", "$vector", "$length", "$value", "$rise", "$still",
                                       "$still_of"}));
    return true;
  }

 private:
  /// Of [{"from": POINT, "to": POINT, "times": k}, …].
  double least_rise(const JsonNode& ways) const {
    double least = std::numeric_limits<double>::infinity();
    in_.for_each(ways, [&](const JsonNode& way, int) {
      const auto y = [&](std::string_view key) {
        return place_.geometry.point(in_, in_.need(way, key), {}, "").at.y;
      };
      least = std::min(least, (y("to") - y("from")) * in_.number(in_.need(way, "times")));
    });
    return least;
  }

  /// Calls each(name) for what stands still and lies in one of the slots.
  template <class Each>
  void for_each_still(const JsonNode& slots, Each&& each) const {
    std::vector<std::size_t> wanted;
    in_.for_each(slots, [&](const JsonNode& slot, int) {
      wanted.push_back(slot_named(in_, slot, place_.library));
    });
    for (const FlatFeatures::One& one : place_.features.all())
      if (one.still && std::find(wanted.begin(), wanted.end(), one.slot) != wanted.end())
        each(one.name);
  }

  void write_still(const JsonNode& offset, const JsonNode& slots) const {
    to_.object();
    for_each_still(slots, [&](std::string_view name) {
      to_.key(to_.kept({name, "/*"})), to_.pair(in_.pair(offset));
    });
    to_.close();
  }

  void write_names(const JsonNode& slots) const {
    to_.array();
    for_each_still(slots, [&](std::string_view name) { to_.string(name); });
    to_.close();
  }

  const Reading& in_;
  const RigPlace& place_;
  TreeWriter& to_;
};

}  // namespace

void write_rig(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to) {
  to.copy(in.tree, node, Placing(in, place, to));
}

bool write_placed(const Reading& in, const JsonNode& at, const RigPlace& place, TreeWriter& to) {
  return Placing(in, place, to)(at);
}

void write_muscles(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                   const FlatFeatures& features, const JsonNode* more, TreeWriter& to) {
  Muscles muscles(in, geometry, features, more, to);
  to.object();
  for (const char* key : {"stiffness", "damping"})
    to.key(key), to.number(short_number(in.number(in.need(node, key))));
  to.key("groups"), to.array();
  in.for_each(in.need(node, "groups"),
              [&](const JsonNode& group, int) { muscles.write_group(group); });
  to.close(), to.close();
}

void write_turn(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to) {
  const FlatFeatures& features = place.features;
  to.object();
  to.copy_children(in.tree, node, Placing(in, place, to));
  to.key("still"), to.array();
  for (const std::string_view name : features.still()) to.string(name);
  to.close();
  to.key("flat"), write_depths(features.flat, to);
  to.key("raised"), write_depths(features.raised, to);
  if (!features.plates.empty()) to.key("plate"), write_depths(features.plates, to);
  to.close();
}

}  // namespace mien
