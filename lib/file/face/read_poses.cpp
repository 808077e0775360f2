// The named poses of a face file: shapes that a face takes by a weight.

#include "face_draft_private.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

class PoseReader {
 public:
  PoseReader(Reading& in, const JsonNode& node, FaceDraft& face)
      : in_(in), node_(node), face_(face) {}

  void read() {
    in_.expect_object(node_, {"per_side", "mirror", "range", "slices", "by", "controls"}, "pose");
    const std::string_view name =
        face_.model.names.keep(in_.checked_name(node_, in_.tree.key(node_)));
    if (const JsonNode* mirror = in_.find(node_, "mirror")) mirror_ = in_.boolean(*mirror);
    if (const JsonNode* range = in_.find(node_, "range")) read_range(*range);
    const JsonNode* per_side = in_.find(node_, "per_side");
    std::vector<SidedChannel> channels;
    const bool sided = per_side && in_.boolean(*per_side);
    for (const Side side : sided ? std::vector{Side::left, Side::right} : std::vector{Side::none})
      channels.push_back({side, add_channel(side)});
    face_.add_control(in_, node_, {name, "weight", {}, true}, channels);
  }

 private:
  void read_range(const JsonNode& node) {
    std::tie(lo_, hi_) = in_.range(node);
    if (!(lo_ <= 0 && hi_ >= 0))
      in_.refuse(node,
                 fmt::format("the range of a pose must hold 0, where the face rests, got {} to {}",
                             lo_, hi_));
  }

  Index<Channel> add_channel(Side side) {
    Channel channel{.rest = 0, .lo = lo_, .hi = hi_, .pose = true};
    if (const JsonNode* slices = in_.find(node_, "slices")) add_shapes(*slices, side, channel);
    if (const JsonNode* by = in_.find(node_, "by")) add_offsets(*by, side, channel);
    if (const JsonNode* controls = in_.find(node_, "controls"))
      add_couplings(*controls, side, channel);
    return face_.add_channel(std::move(channel));
  }

  void add_shapes(const JsonNode& node, Side side, Channel& channel) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      if (in_.tree.key(child) == "comment") return;
      for (const DriveTarget target :
           face_.targets(in_, child, in_.tree.key(child), side, mirror_)) {
        const Slice& slice = face_.model.layout[target.slice];
        const auto rest = face_.vector.begin() + slice.begin;
        const std::span to =
            face_.slice_values(in_, child, slice.kind, slice.size, slice.size, target.mirrored);
        channel.drives.push_back(
            Toward{target.slice, {rest, rest + slice.size}, {to.begin(), to.end()}});
      }
    });
  }

  void add_offsets(const JsonNode& node, Side side, Channel& channel) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      if (in_.tree.key(child) == "comment") return;
      for (Offset& offset : face_.offsets(in_, child, side, mirror_))
        channel.drives.push_back(std::move(offset));
    });
  }

  void add_couplings(const JsonNode& node, Side side, Channel& channel) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view name = in_.tree.key(child);
      if (name == "comment") return;
      const double value = in_.number(child);
      const Index<Control> index = face_.control_on(in_, child, name, side);
      const Control& control = index.in(face_.model.controls);
      if (control.pose) in_.refuse(child, "a pose moves slices and controls, not other poses");
      for (const Index<Channel> c : control.channels)
        channel.couplings.push_back({c, value - c.in(face_.model.channels).rest});
    });
  }

  Reading& in_;
  const JsonNode& node_;
  FaceDraft& face_;
  bool mirror_ = true;
  double lo_ = 0, hi_ = 1;
};

}  // namespace

void read_poses(Reading& in, const JsonNode& node, FaceDraft& face) {
  in.expect(node, JsonKind::object);
  in.for_each(node, [&](const JsonNode& child, int) {
    if (in.tree.key(child) != "comment") PoseReader(in, child, face).read();
  });
}

}  // namespace mien
