#include <mien/bound_motion.h>

#include <mien/face_model.h>
#include "lib/rig/pose/curve.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace mien {
namespace {

bool is_zero(const Curve& curve) {
  if (const auto* samples = std::get_if<SampledCurve>(&curve)) {
    const SampleTable& table = *samples->table;
    for (std::size_t row = 0; row < table.times.size(); ++row)
      if (table.at(row, samples->column) != 0) return false;
    return true;
  }
  const auto* keys = std::get_if<KeyCurve>(&curve);
  return keys && std::all_of(keys->keys.begin(), keys->keys.end(),
                             [](const CurveKey& key) { return key.value == 0; });
}

bool stays_at_zero(const MotionChannel& channel) {
  return std::all_of(channel.curves.begin(), channel.curves.end(), is_zero);
}

/// Whether the face shows what a control does. The strength of an expression moves nothing by itself.
bool shows(const FaceModel& model, const Control& control) {
  for (const Index<Channel> c : control.channels) {
    const Channel& channel = c.in(model.channels);
    if (!channel.drives.empty() || !channel.couplings.empty()) return true;
    const auto is_its = [&](const Expression& one) { return one.left == c || one.right == c; };
    const auto found = std::find_if(model.expressions.begin(), model.expressions.end(), is_its);
    if (found == model.expressions.end()) return true;  // of an eye, a muscle, the head
    if (!found->pulls.empty() || !found->moves.empty()) return true;
  }
  return false;
}

/// Shapes that mean rest: a face that shows nothing by them shows them.
bool means_rest(std::string_view name) {
  return name == "viseme.sil" || name == "vrm.neutral";
}

/// By which controls of faces of parts a speaker nods and lifts the brows.
std::vector<GestureChannel> gesture_channels(
    const FaceModel& model, const std::unordered_map<std::string_view, int>& known) {
  constexpr std::pair<std::string_view, GesturePart> kBy[] = {
      {"pitch", GesturePart::nod},
      {"brow_lift.left", GesturePart::brows},
      {"brow_lift.right", GesturePart::brows}};
  std::vector<GestureChannel> channels;
  for (const auto& [name, part] : kBy) {
    const auto found = known.find(name);
    if (found == known.end()) continue;
    const Control& control = model.controls[std::size_t(found->second)];
    const double whole = control.channels[0].in(model.channels).hi;
    channels.push_back({part, {found->second}, part == GesturePart::nod ? 1 : whole});
  }
  return channels;
}

}  // namespace

BoundMotion bind_motion(Motion motion, const Face& face) {
  const FaceModel& model = *face.model;
  std::unordered_map<std::string_view, int> known;
  for (std::size_t c = 0; c < model.controls.size(); ++c)
    known.emplace(model.controls[c].name, int(c));
  BoundMotion bound;
  std::vector<MotionChannel> channels;
  for (MotionChannel& channel : motion.channels) {
    const auto found = known.find(channel.name);
    const bool there = found != known.end();
    const bool shown = there && shows(model, model.controls[std::size_t(found->second)]);
    if (!shown && !means_rest(channel.name) && !stays_at_zero(channel))
      bound.unfollowed.push_back(channel.name);
    if (!there) continue;
    channel.control = {found->second};
    channels.push_back(std::move(channel));
  }
  motion.channels = std::move(channels);
  motion.idle.clear();  // life is of the face whose clip it is
  motion.spoken.channels = gesture_channels(model, known);
  bound.motion = std::make_shared<const Motion>(std::move(motion));
  return bound;
}

std::vector<Setting> settings_at(const Motion& bound, double time) {
  std::vector<Setting> settings;
  for (const MotionChannel& channel : bound.channels)
    if (channel.control)
      settings.push_back({true, channel.control.at, {value_at(channel.curves[0], time)}});
  return settings;
}

}  // namespace mien
