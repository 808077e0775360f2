#include "lib/parts/compose/flat_mouth.h"
#include "lib/parts/compose/short_number.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace mien {
namespace {

constexpr std::array<std::string_view, 2> kMouthSides{"left", "right"};

class MouthRiders {
 public:
  MouthRiders(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to)
      : in_(in), features_(place.features), to_(to) {
    in.for_each(in.need(node, "stiff"), [&](const JsonNode& slot, int) {
      stiff_.push_back(slot_named(in, slot, place.library));
    });
    in.for_each(in.need(node, "stiff_above"), [&](const JsonNode& one, int) {
      above_.emplace_back(slot_of(one, place), place.geometry.point(in, one, {}, "").at.y);
    });
    const JsonNode& twins = in.need(node, "twins");
    in.for_each(in.need(node, "anchors"),
                [&](const JsonNode& anchor, int) { add_anchor(in.string(anchor), nullptr); });
    in.for_each(twins, [&](const JsonNode& twin, int) { add_anchor(in.tree.key(twin), &twin); });
    std::sort(ways_.begin(), ways_.end(), [](const Way& a, const Way& b) {
      return std::tie(a.slice, a.with) < std::tie(b.slice, b.with);
    });
  }

  void write() const {
    to_.key("ride"), to_.object();
    for_each_rider([&](std::span<const Way> ways) {
      to_.key(ways[0].slice), to_.object();
      for (const Way& way : ways) to_.key(way.with), to_.number(short_number(way.share));
      to_.close();
    });
    to_.close();
    to_.key("stiff"), to_.array();
    for_each_rider([&](std::span<const Way> ways) {
      if (std::any_of(ways.begin(), ways.end(), [](const Way& way) { return way.stiff; }))
        to_.string(ways[0].slice);
    });
    to_.close();
  }

 private:
  /// How a slice goes with another one.
  struct Way {
    std::string_view slice, with;
    double share;
    bool stiff;
  };

  /// Calls each(ways) for each slice that rides.
  template <class Each>
  void for_each_rider(Each&& each) const {
    for (auto first = ways_.begin(); first != ways_.end();) {
      const auto last = std::find_if(first, ways_.end(),
                                     [&](const Way& way) { return way.slice != first->slice; });
      each(std::span<const Way>(&*first, std::size_t(last - first)));
      first = last;
    }
  }

  std::size_t slot_of(const JsonNode& named, const RigPlace& place) const {
    const Reading& own = place.library.topology().in();
    const JsonNode& slots = own.need(*place.library.topology().node, "slots");
    std::size_t at = 0;
    for (const JsonNode* one = own.tree.first(slots); one; one = own.tree.next(*one), ++at)
      if (own.string(*one) == in_.tree.key(named)) return at;
    in_.refuse(named, "no slot of that name");
  }

  /// "moustache.left/spine/0" of "moustache/spine/0".
  std::string_view sided_slice(std::string_view slice, std::string_view side) const {
    const std::size_t slash = slice.find('/');
    return to_.kept({slice.substr(0, slash), ".", side, slice.substr(slash)});
  }

  void add(std::string_view slice, std::string_view with, double share, bool stiff) {
    const auto known = std::find_if(ways_.begin(), ways_.end(), [&](const Way& way) {
      return way.slice == slice && way.with == with;
    });
    if (known == ways_.end())
      ways_.push_back({slice, with, share, stiff});
    else
      known->share += share, known->stiff = known->stiff || stiff;
  }

  /// `twin`: of a point of an outline; null: it is on both sides.
  void add_anchor(std::string_view anchor, const JsonNode* twin) {
    std::array<std::string_view, 2> sides;
    features_.for_each_ride(anchor, [&](const Ride& ride) {
      if (sides[0].empty())
        sides = twin ? std::array{anchor, in_.string(*twin)}
                     : std::array{sided_slice(anchor, kMouthSides[0]),
                                  sided_slice(anchor, kMouthSides[1])};
      const FlatFeatures::One* feature = features_.find(ride.slice.substr(0, ride.slice.find('/')));
      const bool stiff = feature && is_stiff(*feature, ride.at.y);
      if (feature && feature->sided()) {
        for (const std::size_t s : {0u, 1u})
          add(sided_slice(ride.slice, kMouthSides[s]), sides[s], ride.weight, stiff);
      } else if (ride.side != 0) {
        add(ride.slice, sides[ride.side > 0 ? 0 : 1], ride.weight, stiff);
      } else {
        for (const std::string_view side : sides) add(ride.slice, side, 0.5 * ride.weight, stiff);
      }
    });
  }

  bool is_stiff(const FlatFeatures::One& feature, double y) const {
    const auto above = std::find_if(above_.begin(), above_.end(),
                                    [&](const auto& one) { return one.first == feature.slot; });
    return std::find(stiff_.begin(), stiff_.end(), feature.slot) != stiff_.end() ||
           (above != above_.end() && y > above->second);
  }

  const Reading& in_;
  const FlatFeatures& features_;
  TreeWriter& to_;
  std::vector<std::size_t> stiff_;                     ///< slots
  std::vector<std::pair<std::size_t, double>> above_;  ///< slots, and from where on in them
  std::vector<Way> ways_;                              ///< by slice and what it goes with
};

}  // namespace

void write_mouth(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to) {
  to.object();
  in.for_each(node, [&](const JsonNode& member, int) {
    const std::string_view key = in.tree.key(member);
    if (key == "riders") return MouthRiders(in, member, place, to).write();
    to.key(key), write_rig(in, member, place, to);
  });
  to.close();
}

}  // namespace mien
