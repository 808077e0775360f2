#include <mien/lib/rig/pose.h>

#include <mien/lib/face/face_model.h>
#include <mien/lib/rig/curve.h>
#include <mien/lib/rig/drive.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// The value of every channel: at rest, then by the clip, then by settings.
std::vector<double> channel_values(const FaceModel& model, const Pose& pose) {
  std::vector<double> values;
  for (const Channel& channel : model.channels) values.push_back(channel.rest);
  const auto put = [&](int control, double value) {
    if (!std::isnan(value))
      for (const int c : model.controls[std::size_t(control)].channels)
        values[std::size_t(c)] = value;
  };
  if (pose.time && std::isfinite(*pose.time) && model.default_clip >= 0)
    for (const ClipTrack& track : model.clips[std::size_t(model.default_clip)].tracks)
      put(track.control, value_at(track.curve, *pose.time));
  for (const Setting& setting : pose.settings)
    if (setting.control && setting.index >= 0 && setting.index < int(model.controls.size()) &&
        !setting.values.empty())
      put(setting.index, setting.values[0]);
  for (std::size_t c = 0; c < values.size(); ++c)
    values[c] = std::clamp(values[c], model.channels[c].lo, model.channels[c].hi);
  return values;
}

void put_numbers(const Setting& setting, FaceVector& vector) {
  if (setting.control || setting.index < 0) return;
  for (std::size_t i = 0; i < setting.values.size(); ++i)
    if (setting.index + i < vector.size()) vector[setting.index + i] = setting.values[i];
}

}  // namespace

Face pose_face(const Face& face, const Pose& pose) {
  const FaceModel& model = *face.model;
  Face posed = face;
  const std::vector<double> values = channel_values(model, pose);
  for (std::size_t c = 0; c < values.size(); ++c)
    if (values[c] != model.channels[c].rest)
      drive(model.channels[c], values[c], model.layout, posed.vector);
  for (const Setting& setting : pose.settings) put_numbers(setting, posed.vector);
  apply_rules(model.layout, face.vector, posed.vector);
  return posed;
}

}  // namespace mien
