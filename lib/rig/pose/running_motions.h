#pragma once
// Which motions run in a pose.

#include <mien/face_model.h>
#include <mien/pose.h>

#include <cmath>

namespace mien {

/// Whether a channel moves a control of the model.
template <class AnyChannel>
bool moves(const AnyChannel& channel, const FaceModel& model) {
  return channel.control && channel.control.at < int(model.controls.size());
}

/// The clip that runs because no other motion was asked for; null: none.
inline const Motion* default_clip_of(const FaceModel& model, const Pose& pose) {
  return pose.motions.empty() && model.default_clip ? &model.default_clip.in(model.clips) : nullptr;
}

/// The motion of a layer; null: of another model.
inline const Motion* motion_of(const FaceModel& model, const MotionLayer& layer) {
  if (!layer.clip) return layer.motion.get();
  return layer.clip.at < int(model.clips.size()) ? &layer.clip.in(model.clips) : nullptr;
}

/// Calls each(motion, weight, begin) for those that run, bottom to top. Without liveliness only settled ones do.
template <class Each>
void for_each_motion(const FaceModel& model, const Pose& pose, Each&& each) {
  if (!pose.time || !std::isfinite(*pose.time)) return;
  const auto run = [&](const Motion* motion, double weight, double begin) {
    if (motion && (motion->settled || pose.liveliness > 0)) each(*motion, weight, begin);
  };
  run(default_clip_of(model, pose), 1, 0);
  for (const MotionLayer& layer : pose.motions)
    if (std::isfinite(layer.weight) && std::isfinite(layer.begin))
      run(motion_of(model, layer), layer.weight, layer.begin);
}

}  // namespace mien
