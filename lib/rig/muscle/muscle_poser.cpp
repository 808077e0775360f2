#include "lib/rig/muscle/muscle_poser.h"

#include <mien/face_model.h>
#include "lib/rig/muscle/pulls.h"
#include "lib/rig/pose/running_motions.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

bool is_control(const FaceModel& model, const Setting& setting) {
  return setting.control && setting.index >= 0 && setting.index < int(model.controls.size()) &&
         !setting.values.empty() && !std::isnan(setting.values[0]);
}

/// Calls each(motion, channel, control) for what motions move.
template <class Each>
void for_each_moved(const FaceModel& model, const Pose& pose, Each&& each) {
  for_each_motion(model, pose, [&](const Motion& motion, double, double) {
    for (const MotionChannel& channel : motion.channels)
      if (moves(channel, model)) each(motion, channel.control.in(model.controls));
  });
}

bool same_settings(const std::vector<Setting>& a, const std::vector<Setting>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Setting& x, const Setting& y) {
    return x.control == y.control && x.index == y.index && x.values == y.values;
  });
}

/// Whether two poses differ in time only.
bool same_course(const Pose& a, const Pose& b) {
  return same_settings(a.settings, b.settings) && a.look_at == b.look_at && a.seed == b.seed &&
         a.liveliness == b.liveliness && a.gestures == b.gestures &&
         std::equal(a.motions.begin(), a.motions.end(), b.motions.begin(), b.motions.end(),
                    [](const MotionLayer& x, const MotionLayer& y) {
                      return x.clip == y.clip && x.motion == y.motion && x.weight == y.weight &&
                             x.begin == y.begin;
                    });
}

bool same_face(const Face& a, const Face& b) {
  return a.model == b.model && a.vector == b.vector;
}

}  // namespace

void held_channels(const FaceModel& model, const Pose& pose, std::vector<char>& held) {
  held.assign(model.channels.size(), 0);
  const auto hold = [&](const Control& control) {
    for (const Index<Channel> c : control.channels) held[std::size_t(c.at)] = 1;
  };
  for_each_moved(model, pose, [&](const Motion&, const Control& control) { hold(control); });
  for (const Setting& setting : pose.settings)
    if (is_control(model, setting)) hold(model.controls[std::size_t(setting.index)]);
}

bool muscles_in_motion(const FaceModel& model, const Pose& pose) {
  const auto feeds_muscles = [&](Index<Channel> channel) {
    return std::any_of(model.muscles.muscles.begin(), model.muscles.muscles.end(),
                       [&](const Muscle& muscle) { return muscle.channel == channel; }) ||
           std::any_of(model.expressions.begin(), model.expressions.end(),
                       [&](const Expression& expression) {
                         return !expression.pulls.empty() &&
                                (expression.left == channel || expression.right == channel);
                       });
  };
  bool found = false, settled = false;
  for_each_moved(model, pose, [&](const Motion& motion, const Control& control) {
    for (const Index<Channel> c : control.channels)
      if (feeds_muscles(c)) (motion.settled ? settled : found) = true;
  });
  return found && !settled;
}

void lay_on(const FaceModel& model, const FaceVector& rest, const MuscleShape& shape,
            FaceVector& vector) {
  const MuscleSystem& system = model.muscles;
  for (std::size_t i = 0; i < system.points.size(); ++i)
    for (const int slice : {system.points[i].slice, system.points[i].twin}) {
      if (slice < 0) continue;
      const auto begin = std::size_t(model.layout[slice].begin);
      vector[begin] += shape.points[i].x - rest[begin];
      vector[begin + 1] += shape.points[i].y - rest[begin + 1];
    }
  for (std::size_t i = 0; i < system.numbers.size(); ++i) {
    const MuscleNumber& number = system.numbers[i];
    const Slice& slice = model.layout[number.slice];
    if (number.component >= 0)
      vector[std::size_t(slice.begin + number.component)] += shape.numbers[i];
    else
      for (int n = slice.begin; n < slice.begin + slice.size; ++n)
        vector[std::size_t(n)] *= 1 + shape.numbers[i];
  }
}

/// The pulls of a pose as a function of time, and the motion under them.
struct MusclePoser::Course {
  Face rest;
  Pose pose;
  ChannelsAt channels_at;
  std::vector<char> held;
  std::vector<double> values;
  MuscleMotion motion;

  Course(const Face& face, const Pose& course, const ChannelsAt& channels)
      : rest(face),
        pose(course),
        channels_at(channels),
        motion(*rest.model, rest.vector, [this](double time, std::vector<double>& pulls) {
          pose.time = time;
          channels_at(rest, pose, values);
          muscle_pulls(*rest.model, values, held, pulls);
        }) {
    held_channels(*rest.model, pose, held);
  }
  Course(const Course&) = delete;
};

void MusclePoser::begin_motion(const Face& rest, const Pose& pose, const ChannelsAt& channels_at) {
  if (!course_ || !same_face(course_->rest, rest) || !same_course(course_->pose, pose))
    course_ = std::make_shared<Course>(rest, pose, channels_at);
}

void MusclePoser::act(const Face& rest, const Pose& pose, std::span<const double> values,
                      const ChannelsAt& channels_at, FaceVector& vector) {
  const FaceModel& model = *rest.model;
  if (model.muscles.muscles.empty()) return;
  held_channels(model, pose, held_);
  muscle_pulls(model, values, held_, pulls_);
  if (muscles_in_motion(model, pose)) {
    begin_motion(rest, pose, channels_at);
    course_->motion.at(*pose.time, moving_);
    return lay_on(model, rest.vector, moving_, vector);
  }
  if (std::all_of(pulls_.begin(), pulls_.end(), [](double pull) { return pull == 0; })) return;
  if (pulls_ != still_pulls_ || !rest_.model || !same_face(rest_, rest)) {
    muscle_still(model, rest.vector, pulls_, shape_, scratch_);
    still_pulls_ = pulls_;
    rest_ = rest;
  }
  lay_on(model, rest.vector, shape_, vector);
}

}  // namespace mien
