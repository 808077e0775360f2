#include "lib/parts/compose/flat_mouth.h"
#include "lib/parts/compose/short_number.h"

#include <array>
#include <map>
#include <set>
#include <string>

namespace mien {
namespace {

constexpr std::array<std::string_view, 2> kMouthSides{"left", "right"};

/// "moustache.left/spine/0" of "moustache/spine/0".
std::string sided_slice(std::string_view slice, std::string_view side) {
  const std::size_t slash = slice.find('/');
  std::string name(slice.substr(0, slash));
  return name.append(".").append(side).append(slice.substr(slash));
}

class MouthRiders {
 public:
  MouthRiders(const Reading& in, const JsonNode& node, const RigPlace& place)
      : in_(in), features_(place.features) {
    for (const FlatFeatures::One& one : features_.features) slots_[one.name] = one.slot;
    in.for_each(in.need(node, "stiff"), [&](const JsonNode& slot, int) {
      stiff_.insert(slot_named(in, slot, place.library));
    });
    in.for_each(in.need(node, "stiff_above"), [&](const JsonNode& one, int) {
      above_[slot_of(one, place)] = place.geometry.point(in, one, {}, "").at.y;
    });
    const JsonNode& twins = in.need(node, "twins");
    in.for_each(in.need(node, "anchors"),
                [&](const JsonNode& anchor, int) { add_anchor(in.string(anchor), nullptr); });
    in.for_each(twins, [&](const JsonNode& twin, int) { add_anchor(in.tree.key(twin), &twin); });
  }

  void write(TreeWriter& to) const {
    to.key("ride"), to.object();
    for (const auto& [slice, with] : riders_) {
      to.kept_key(slice), to.object();
      for (const auto& [anchor, share] : with.shares)
        to.kept_key(anchor), to.number(short_number(share));
      to.close();
    }
    to.close();
    to.key("stiff"), to.array();
    for (const auto& [slice, with] : riders_)
      if (with.stiff) to.kept_string(slice);
    to.close();
  }

 private:
  struct Rider {
    std::map<std::string, double> shares;
    bool stiff = false;
  };

  std::size_t slot_of(const JsonNode& named, const RigPlace& place) const {
    const Reading& own = place.library.topology().in();
    const JsonNode& slots = own.need(*place.library.topology().node, "slots");
    std::size_t at = 0;
    for (const JsonNode* one = own.tree.first(slots); one; one = own.tree.next(*one), ++at)
      if (own.string(*one) == in_.tree.key(named)) return at;
    in_.refuse(named, "no slot of that name");
  }

  /// `twin`: of a point of an outline; null: it is on both sides.
  void add_anchor(std::string_view anchor, const JsonNode* twin) {
    const auto found = features_.rides.find(anchor);
    if (found == features_.rides.end()) return;
    const std::array<std::string, 2> sides{
        twin ? std::string(anchor) : sided_slice(anchor, kMouthSides[0]),
        twin ? std::string(in_.string(*twin)) : sided_slice(anchor, kMouthSides[1])};
    for (const Ride& ride : found->second) {
      const std::string feature = ride.slice.substr(0, ride.slice.find('/'));
      const bool stiff = is_stiff(feature, ride.at.y);
      const auto add = [&](const std::string& slice, const std::string& with, double share) {
        Rider& rider = riders_[slice];
        rider.shares[with] += share, rider.stiff = rider.stiff || stiff;
      };
      if (features_.sided.contains(feature)) {
        for (const std::size_t s : {0u, 1u})
          add(sided_slice(ride.slice, kMouthSides[s]), sides[s], ride.weight);
      } else if (ride.side != 0) {
        add(ride.slice, sides[ride.side > 0 ? 0 : 1], ride.weight);
      } else {
        for (const std::string& side : sides) add(ride.slice, side, 0.5 * ride.weight);
      }
    }
  }

  bool is_stiff(const std::string& feature, double y) const {
    const auto slot = slots_.find(feature);
    if (slot == slots_.end()) return false;
    const auto above = above_.find(slot->second);
    return stiff_.contains(slot->second) || (above != above_.end() && y > above->second);
  }

  const Reading& in_;
  const FlatFeatures& features_;
  std::map<std::string, std::size_t> slots_;
  std::set<std::size_t> stiff_;
  std::map<std::size_t, double> above_;
  std::map<std::string, Rider> riders_;
};

}  // namespace

void write_mouth(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to) {
  to.object();
  in.for_each(node, [&](const JsonNode& member, int) {
    const std::string_view key = in.tree.key(member);
    if (key == "riders") return MouthRiders(in, member, place).write(to);
    to.key(key), write_rig(in, member, place, to);
  });
  to.close();
}

}  // namespace mien
