// The controls of a face file, and what they drive.

#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

class ControlReader {
 public:
  ControlReader(Reading& in, const JsonNode& node, FaceDraft& face)
      : in_(in), node_(node), face_(face) {}

  void read() {
    in_.expect_object(node_, {"name", "unit", "range", "rest", "per_side", "mirror", "offset",
                              "scale", "key_shapes"});
    const JsonNode& name_node = in_.need(node_, "name");
    const std::string_view name =
        face_.model.names.keep(in_.checked_name(name_node, in_.string(name_node)));
    if (const JsonNode* mirror = in_.find(node_, "mirror")) mirror_ = in_.boolean(*mirror);
    read_range();
    const JsonNode* per_side = in_.find(node_, "per_side");
    const JsonNode* unit = in_.find(node_, "unit");
    const Control control{
        name, unit ? face_.model.names.keep(one_line(in_.string(*unit), 60)) : "ratio", {}};
    if (per_side && in_.boolean(*per_side)) {
      const SidedChannel left{Side::left, add_channel(Side::left)};
      const SidedChannel right{Side::right, add_channel(Side::right)};
      face_.add_control(in_, name_node, control, std::array{left, right});
    } else {
      face_.add_control(in_, name_node, control,
                        std::array{SidedChannel{Side::none, add_channel(Side::none)}});
    }
  }

 private:
  void read_range() {
    const auto [lo, hi] = in_.range(in_.need(node_, "range"));
    lo_ = lo, hi_ = hi;
    const JsonNode& rest = in_.need(node_, "rest");
    rest_ = in_.number(rest);
    if (!(rest_ >= lo && rest_ <= hi))
      in_.refuse(rest, fmt::format("must lie between {} and {}, got {}", lo, hi, rest_));
  }

  Index<Channel> add_channel(Side side) {
    Channel channel{.rest = rest_, .lo = lo_, .hi = hi_};
    if (const JsonNode* offset = in_.find(node_, "offset")) add_offsets(*offset, side, channel);
    if (const JsonNode* scale = in_.find(node_, "scale")) add_scales(*scale, side, channel);
    if (const JsonNode* table = in_.find(node_, "key_shapes"))
      if (KeyShapes shapes = key_shapes(*table, side); !shapes.tracks.empty())
        channel.drives.push_back(std::move(shapes));
    return face_.add_channel(std::move(channel));
  }

  void add_offsets(const JsonNode& node, Side side, Channel& channel) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      for (Offset& offset : face_.offsets(in_, child, side, mirror_))
        channel.drives.push_back(std::move(offset));
    });
  }

  void add_scales(const JsonNode& node, Side side, Channel& channel) const {
    in_.expect(node, JsonKind::array);
    if (rest_ != 1)
      in_.refuse(node, fmt::format("a control that scales must rest at 1, not at {}", rest_));
    in_.for_each(node, [&](const JsonNode& child, int) {
      for (const DriveTarget target : face_.targets(in_, child, in_.string(child), side, mirror_))
        channel.drives.push_back(Scale{target.slice});
    });
  }

  KeyShapes key_shapes(const JsonNode& node, Side side) {
    in_.expect_object(node, {"at", "slices"});
    const JsonNode& slices = in_.need(node, "slices");
    in_.expect(slices, JsonKind::object);
    if (slices.count == 0) in_.refuse(slices, "expected at least one slice");
    KeyShapes table;
    table.at = key_places(node, slices);
    in_.for_each(slices, [&](const JsonNode& child, int) {
      in_.expect(child, JsonKind::array);
      if (std::size_t(child.count) != table.at.size())
        in_.refuse(child, fmt::format("expected {} keys, got {}", table.at.size(), child.count));
      for (const DriveTarget target : face_.targets(in_, child, in_.tree.key(child), side, mirror_))
        table.tracks.push_back(key_track(child, target, side));
    });
    warn_of_jump(node, table);
    return table;
  }

  /// Where the keys are: as in "at", or evenly over the range.
  std::vector<double> key_places(const JsonNode& node, const JsonNode& slices) const {
    std::vector<double> at;
    if (const JsonNode* places = in_.find(node, "at")) {
      in_.expect(*places, JsonKind::array);
      if (places->count < 2)
        in_.refuse(*places, fmt::format("expected at least 2 keys, got {}", places->count));
      in_.for_each(*places, [&](const JsonNode& child, int) {
        const double place = in_.number(child);
        if (!at.empty() && !(place > at.back())) in_.refuse(child, "the places of keys must rise");
        at.push_back(place);
      });
      return at;
    }
    const JsonNode& first = *in_.tree.first(slices);
    in_.expect(first, JsonKind::array);
    if (first.count < 2)
      in_.refuse(first, fmt::format("expected at least 2 keys, got {}", first.count));
    for (int i = 0; i < first.count; ++i)
      at.push_back(i == first.count - 1 ? hi_ : lo_ + (hi_ - lo_) * i / (first.count - 1));
    return at;
  }

  KeyTrack key_track(const JsonNode& node, DriveTarget target, Side side) const {
    const Slice& slice = face_.model.layout[target.slice];
    KeyTrack track{target.slice, {}};
    in_.for_each(node, [&](const JsonNode& child, int) {
      KeyValue value;
      if (child.kind != JsonKind::string) {
        const std::span numbers =
            face_.slice_values(in_, child, slice.kind, slice.size, slice.size, target.mirrored);
        value.numbers.assign(numbers.begin(), numbers.end());
      } else if (in_.string(child) == "rest") {
        value.from = target.slice;
      } else {
        value.from = face_.reference(in_, child, side_of(slice, side), slice.kind, slice.size);
      }
      track.values.push_back(std::move(value));
    });
    return track;
  }

  /// The side of a slice that a control for both sides drives.
  Side side_of(const Slice& slice, Side side) const {
    if (side != Side::none) return side;
    const int feature = face_.find_feature(slice.name.substr(0, slice.name.find('/')), Side::none);
    return feature < 0 ? Side::none : face_.model.features[std::size_t(feature)].side;
  }

  /// If a table differs from the features at rest, the face jumps as soon as the control is moved.
  void warn_of_jump(const JsonNode& node, const KeyShapes& table) {
    const auto key = std::find(table.at.begin(), table.at.end(), rest_);
    if (key == table.at.end()) return;
    for (const KeyTrack& track : table.tracks) {
      const KeyValue& value = track.values[std::size_t(key - table.at.begin())];
      const auto now = face_.vector.begin() + face_.model.layout[track.slice].begin;
      if (value.from < 0 && !std::equal(value.numbers.begin(), value.numbers.end(), now))
        in_.warn(node, fmt::format("the key at rest differs from {} itself",
                                   in_quotes(face_.model.layout[track.slice].name)));
    }
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
  bool mirror_ = true;
  double lo_ = 0, hi_ = 1, rest_ = 0;
};

}  // namespace

void read_controls(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::array);
  in.for_each(node, [&](const JsonNode& child, int) { ControlReader(in, child, face).read(); });
}

}  // namespace mien
