#include "face_draft_private.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

/// "brow.left/spine/0" as its author names it: "brow/spine/0".
std::string author_name(const Slice& slice) {
  std::string name(slice.name);
  const std::size_t slash = name.find('/');
  for (const std::string_view side : {".left", ".right"})
    if (slash >= side.size() && slash != std::string::npos &&
        name.compare(slash - side.size(), side.size(), side) == 0)
      return name.erase(slash - side.size(), side.size());
  return name;
}

}  // namespace

int FaceDraft::add_slice(const Reading& in, const JsonNode& node,
                         std::initializer_list<std::string_view> name, SliceKind kind,
                         std::span<const double> values, Written how) {
  if (vector.size() + values.size() > in.limits.numbers)
    in.refuse(node,
              fmt::format("more than {} numbers in the face (limit: numbers)", in.limits.numbers));
  vector.insert(vector.end(), values.begin(), values.end());
  if (places)
    places->push_back(
        {how == Written::nowhere ? -1 : in.tree.index(node), how == Written::mirrored});
  return model.layout.add(name, kind, int(values.size()));
}

std::string_view FaceDraft::joined(std::initializer_list<std::string_view> parts) const {
  name_.clear();
  for (const std::string_view part : parts) name_ += part;
  return name_;
}

int FaceDraft::find_slice(std::string_view name, Side side) const {
  if (side != Side::none) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const int found = model.layout.find(
        joined({name.substr(0, slash), ".", side_name(side), name.substr(slash)}));
    if (found >= 0) return found;
  }
  return model.layout.find(name);
}

int FaceDraft::feature_named(std::string_view name, Side side) const {
  return features.find(side == Side::none ? name : joined({name, ".", side_name(side)}),
                       [&](int feature) { return model.features[std::size_t(feature)].name; });
}

int FaceDraft::find_feature(std::string_view name, Side side) const {
  const int found = side == Side::none ? -1 : feature_named(name, side);
  return found >= 0 ? found : feature_named(name);
}

Index<Control> FaceDraft::find_control(std::string_view name) const {
  return {
      controls.find(name, [&](int control) { return model.controls[std::size_t(control)].name; })};
}

Index<Control> FaceDraft::control_on(const Reading& in, const JsonNode& node, std::string_view name,
                                     Side side) const {
  if (side != Side::none) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    const Index<Control> found =
        find_control(joined({name.substr(0, dot), ".", side_name(side), name.substr(dot)}));
    if (found) return found;
  }
  return control_named(in, node, name);
}

int FaceDraft::slice_named(const Reading& in, const JsonNode& node, std::string_view name,
                           Side side) const {
  const int found = find_slice(name, side);
  if (found >= 0) return found;
  std::vector<std::string> known;
  for (const Slice& slice : model.layout.slices())
    known.push_back(model.layout.find(name) < 0 ? author_name(slice) : std::string(slice.name));
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
    if ((side != Side::none && s != side) || feature_named(feature, s) < 0) continue;
    known = true;
    const std::string_view dot = s == Side::none ? "" : ".";
    const std::string_view own = joined({feature, dot, side_name(s), "/"});
    const auto& slices = model.layout.slices();
    for (std::size_t i = 0; i < slices.size(); ++i)
      if (slices[i].kind == SliceKind::point && slices[i].name.starts_with(own))
        found.push_back({int(i), mirror && is_mirrored(int(i))});
  }
  if (known) return found;
  if (feature_named(feature) >= 0)
    in.refuse(node,
              fmt::format("{} has no sides, but this control is per side", in_quotes(feature)));
  std::vector<std::string_view> names;
  for (const Feature& one : model.features) names.push_back(one.name.substr(0, one.name.find('.')));
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

void FaceDraft::add_feature(Feature feature, bool written_mirrored) {
  features.enter(feature.name, int(model.features.size()));
  mirrored.push_back(written_mirrored);
  model.features.push_back(std::move(feature));
}

void FaceDraft::add_control(const Reading& in, const JsonNode& name_node, Control control) {
  if (find_control(control.name))
    in.refuse(name_node, fmt::format("there is a control {} already", in_quotes(control.name)));
  controls.enter(control.name, int(model.controls.size()));
  if (control.channels.size() == 2)
    for (const int half : {0, 1}) {
      const auto channel = std::size_t(control.channels[std::size_t(half)].at);
      if (channel_sides.size() <= channel) channel_sides.resize(channel + 1, Side::none);
      if (channel_sides[channel] == Side::none)
        channel_sides[channel] = half == 0 ? Side::left : Side::right;
    }
  model.controls.push_back(control);
}

void FaceDraft::add_control(const Reading& in, const JsonNode& name_node, Control control,
                            std::span<const SidedChannel> channels) {
  for (const SidedChannel& c : channels) control.channels.push_back(c.channel);
  add_control(in, name_node, control);
  const std::size_t dot = std::min(control.name.find('.'), control.name.size());
  for (const auto& [side, channel] : channels) {
    if (side == Side::none) continue;
    Control half{model.names.keep(
                     {control.name.substr(0, dot), ".", side_name(side), control.name.substr(dot)}),
                 control.unit,
                 {},
                 control.pose};
    half.channels.push_back(channel);
    add_control(in, name_node, half);
  }
}

Index<Control> FaceDraft::control_named(const Reading& in, const JsonNode& node,
                                        std::string_view name) const {
  if (const Index<Control> found = find_control(name)) return found;
  std::vector<std::string_view> known;
  for (const Control& control : model.controls) known.push_back(control.name);
  in.refuse(node, unknown_name("control", name, known));
}

bool FaceDraft::is_mirrored(int slice) const {
  const std::string_view name = model.layout[slice].name;
  const std::string_view owner = name.substr(0, name.find('/'));
  if (std::find(mirrored_eyes.begin(), mirrored_eyes.end(), owner) != mirrored_eyes.end())
    return true;
  const int found = feature_named(owner);
  return found >= 0 && mirrored[std::size_t(found)];
}

std::span<double> FaceDraft::slice_values(const Reading& in, const JsonNode& node, SliceKind kind,
                                          int least, int most, bool mirror) const {
  in.numbers(node, least, most, numbers_);
  if (kind == SliceKind::length || kind == SliceKind::ratio)
    for (const double value : numbers_)
      if (value < 0)
        in.refuse(node, fmt::format("a {} must not be negative, got {}", kind_name(kind), value));
  if (mirror) mirror_values(kind, numbers_, model.canvas.twice_axis());
  return numbers_;
}

}  // namespace mien
