#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

namespace mien {
namespace {

/// "brow.left/spine/0" as its author names it: "brow/spine/0".
std::string author_name(const Slice& slice) {
  std::string name = slice.name;
  const std::size_t slash = name.find('/');
  for (const std::string_view side : {".left", ".right"})
    if (slash >= side.size() && slash != std::string::npos &&
        name.compare(slash - side.size(), side.size(), side) == 0)
      return name.erase(slash - side.size(), side.size());
  return name;
}

}  // namespace

int FaceDraft::add_slice(const Reading& in, const JsonNode& node, std::string name, SliceKind kind,
                         std::span<const double> values, Written how) {
  if (vector.size() + values.size() > in.limits.numbers)
    in.refuse(node,
              fmt::format("more than {} numbers in the face (limit: numbers)", in.limits.numbers));
  vector.insert(vector.end(), values.begin(), values.end());
  if (places)
    places->push_back(
        {how == Written::nowhere ? -1 : in.tree.index(node), how == Written::mirrored});
  return model.layout.add(std::move(name), kind, int(values.size()));
}

int FaceDraft::find_slice(std::string_view name, Side side) const {
  if (side != Side::none) {
    const std::size_t slash = name.find('/');
    std::string sided = feature_of_side(name.substr(0, slash), side);
    if (slash != std::string_view::npos) sided += name.substr(slash);
    if (const int found = model.layout.find(sided); found >= 0) return found;
  }
  return model.layout.find(name);
}

int FaceDraft::find_feature(std::string_view name, Side side) const {
  auto found = feature_by_name.find(feature_of_side(name, side));
  if (found == feature_by_name.end()) found = feature_by_name.find(std::string{name});
  return found == feature_by_name.end() ? -1 : found->second;
}

int FaceDraft::slice_named(const Reading& in, const JsonNode& node, std::string_view name,
                           Side side) const {
  const int found = find_slice(name, side);
  if (found >= 0) return found;
  std::vector<std::string> known;
  for (const Slice& slice : model.layout.slices())
    known.push_back(model.layout.find(name) < 0 ? author_name(slice) : slice.name);
  in.refuse(node, unknown_name("number", name, {known.begin(), known.end()}));
}

int FaceDraft::reference(const Reading& in, const JsonNode& node, Side side, SliceKind kind,
                         int size) const {
  const std::string_view text = in.string(node);
  if (!text.starts_with('@'))
    in.refuse(node, fmt::format("expected numbers or a reference like \"@opening/upper\", got {}",
                                in_quotes(text)));
  const int found = slice_named(in, node, text.substr(1), side);
  const Slice& slice = model.layout[found];
  if (slice.kind != kind || slice.size != size)
    in.refuse(node, fmt::format("{} is a {} of {}, but a {} of {} is needed here", in_quotes(text),
                                kind_name(slice.kind), slice.size, kind_name(kind), size));
  return found;
}

std::vector<DriveTarget> FaceDraft::points_of(const Reading& in, const JsonNode& node,
                                              std::string_view feature, Side side,
                                              bool mirror) const {
  std::vector<DriveTarget> found;
  bool known = false;
  for (const Side s : {Side::none, Side::left, Side::right}) {
    const std::string name = feature_of_side(feature, s);
    if ((side != Side::none && s != side) || !feature_by_name.contains(name)) continue;
    known = true;
    const std::string own = name + "/";
    const auto& slices = model.layout.slices();
    for (std::size_t i = 0; i < slices.size(); ++i)
      if (slices[i].kind == SliceKind::point && slices[i].name.starts_with(own))
        found.push_back({int(i), mirror && is_mirrored(int(i))});
  }
  if (known) return found;
  if (feature_by_name.contains(std::string(feature)))
    in.refuse(node,
              fmt::format("{} has no sides, but this control is per side", in_quotes(feature)));
  std::vector<std::string_view> names;
  for (const Feature& one : model.features)
    names.push_back(std::string_view{one.name}.substr(0, one.name.find('.')));
  in.refuse(node, unknown_name("feature", feature, names));
}

std::vector<DriveTarget> FaceDraft::targets(const Reading& in, const JsonNode& node,
                                            std::string_view name, Side side, bool mirror) const {
  if (name.ends_with("/*"))
    return points_of(in, node, name.substr(0, name.size() - 2), side, mirror);
  const int itself = model.layout.find(name);
  std::vector<DriveTarget> found;
  const auto look = [&](Side s) {
    const int slice = find_slice(name, s);
    if (slice >= 0 && slice != itself) found.push_back({slice, mirror && is_mirrored(slice)});
  };
  if (side != Side::none) {
    look(side);
    if (!found.empty() || find_slice(name, other(side)) != itself) return found;
    if (itself >= 0)
      in.refuse(node,
                fmt::format("{} has no sides, but this control is per side", in_quotes(name)));
  } else {
    if (itself >= 0) return {{itself, false}};
    look(Side::left), look(Side::right);
    if (!found.empty()) return found;
  }
  slice_named(in, node, name, side);  // refuses
  return found;
}

std::vector<Offset> FaceDraft::offsets(const Reading& in, const JsonNode& node, Side side,
                                       bool mirror) const {
  std::vector<Offset> found;
  for (const DriveTarget target : targets(in, node, in.tree.key(node), side, mirror)) {
    const Slice& slice = model.layout[target.slice];
    std::vector<double> by = in.numbers(node, slice.size, slice.size);
    if (target.mirrored) mirror_differences(slice.kind, by, model.canvas.twice_axis());
    found.push_back({target.slice, std::move(by)});
  }
  return found;
}

Index<Channel> FaceDraft::add_channel(Channel channel) {
  model.channels.push_back(std::move(channel));
  return last_of(model.channels);
}

void FaceDraft::add_control(const Reading& in, const JsonNode& name_node, Control control) {
  if (!control_by_name.emplace(control.name, Index<Control>{int(model.controls.size())}).second)
    in.refuse(name_node, fmt::format("there is a control {} already", in_quotes(control.name)));
  if (control.channels.size() == 2)
    for (const int half : {0, 1}) {
      const auto channel = std::size_t(control.channels[std::size_t(half)].at);
      if (channel_sides.size() <= channel) channel_sides.resize(channel + 1, Side::none);
      if (channel_sides[channel] == Side::none)
        channel_sides[channel] = half == 0 ? Side::left : Side::right;
    }
  model.controls.push_back(std::move(control));
}

void FaceDraft::add_control(const Reading& in, const JsonNode& name_node, Control control,
                            std::span<const SidedChannel> channels) {
  for (const SidedChannel& c : channels) control.channels.push_back(c.channel);
  add_control(in, name_node, control);
  for (const auto& [side, channel] : channels)
    if (side != Side::none)
      add_control(in, name_node,
                  {control_of_side(control.name, side), control.unit, {channel}, control.pose});
}

Index<Control> FaceDraft::control_named(const Reading& in, const JsonNode& node,
                                        std::string_view name) const {
  const auto found = control_by_name.find(std::string{name});
  if (found != control_by_name.end()) return found->second;
  std::vector<std::string_view> known;
  for (const Control& control : model.controls) known.push_back(control.name);
  in.refuse(node, unknown_name("control", name, known));
}

bool FaceDraft::is_mirrored(int slice) const {
  const std::string_view name = model.layout[slice].name;
  const std::string owner{name.substr(0, name.find('/'))};
  if (mirrored_eyes.contains(owner)) return true;
  const auto found = feature_by_name.find(owner);
  return found != feature_by_name.end() && mirrored[std::size_t(found->second)];
}

std::vector<double> read_slice_values(const Reading& in, const JsonNode& node, SliceKind kind,
                                      int least, int most, const FaceCanvas& canvas,
                                      bool mirrored) {
  std::vector<double> values = in.numbers(node, least, most);
  if (kind == SliceKind::length || kind == SliceKind::ratio)
    for (const double value : values)
      if (value < 0)
        in.refuse(node, fmt::format("a {} must not be negative, got {}", kind_name(kind), value));
  if (mirrored) mirror_values(kind, values, canvas.twice_axis());
  return values;
}

}  // namespace mien
