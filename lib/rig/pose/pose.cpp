#include <mien/pose.h>

#include <mien/face_model.h>
#include <mien/poser.h>
#include "lib/rig/eye/eye.h"
#include "lib/rig/idle/idle.h"
#include "lib/rig/mouth/mouth.h"
#include "lib/rig/muscle/muscle_poser.h"
#include "lib/rig/muscle/pulls.h"
#include "lib/rig/pose/curve.h"
#include "lib/rig/pose/drive.h"
#include "lib/rig/pose/head_turn.h"
#include "lib/rig/pose/running_motions.h"
#include "lib/rig/pose/unwrap.h"
#include "lib/rig/speech/gestures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace mien {
namespace {

using Values = std::vector<double>;

/// A channel's value for a control that rests there. With a liveliness of 1 a single curve's value is kept bit for bit.
double value_of(const MotionChannel& channel, double rest, double time, double liveliness) {
  double value = rest;
  for (std::size_t i = 0; i < channel.curves.size(); ++i) {
    double own = value_at(channel.curves[i], time);
    if (liveliness != 1) own = rest + liveliness * (own - rest);
    value = i == 0 ? own : value + (own - rest);
  }
  return value;
}

/// Lays motions over what is below them.
class Playing {
 public:
  Playing(const FaceModel& model, const Pose& pose, Values& values)
      : model_(model),
        seed_(pose.seed.value_or(model.seed)),
        liveliness_(std::min(pose.liveliness, kMostLively)),
        gestures_(std::clamp(pose.gestures, 0.0, kMostGestures) *
                  std::clamp(pose.liveliness, 0.0, kMostLively)),
        values_(values) {
    for_each_motion(model, pose, [&](const Motion& motion, double weight, double begin) {
      if (weight > 0 && !motion.spoken.contacts.empty())
        contacts_ = {motion.spoken.contacts, begin - *pose.time};
    });
  }

  void play(const Motion& motion, double time, double weight) {
    if (!motion.idle.empty() && std::isfinite(time)) {
      const IdleNumbers numbers =
          idle_at(seed_, time, liveliness_, {contacts_.spans, contacts_.later + time});
      for (const IdleChannel& channel : motion.idle)
        if (moves(channel, model_))
          lay(channel.control, weight, motion.additive, [&](double rest) {
            return rest + channel.scale * numbers[std::size_t(channel.part)];
          });
    }
    const double liveliness = motion.settled ? 1 : liveliness_;
    for (const MotionChannel& channel : motion.channels)
      if (moves(channel, model_))
        lay(channel.control, weight, motion.additive,
            [&](double rest) { return value_of(channel, rest, time, liveliness); });
    if (gestures_ > 0 && !motion.spoken.accents.empty() && std::isfinite(time))
      gesture(motion.spoken, time, weight);
  }

 private:
  /// On top of what the face does below the speech.
  void gesture(const SpokenGestures& spoken, double time, double weight) {
    const Gestures now = gestures_at(spoken.accents, seed_, time);
    for (const GestureChannel& channel : spoken.channels)
      if (moves(channel, model_))
        lay(channel.control, weight, true, [&](double rest) {
          const double number = channel.part == GesturePart::nod ? now.pitch : now.brows;
          return rest + gestures_ * channel.scale * number;
        });
  }

  template <class ValueFrom>
  void lay(Index<Control> control, double weight, bool additive, ValueFrom&& value_from) {
    const ControlChannels& channels = control.in(model_.controls).channels;
    const double rest = channels[0].in(model_.channels).rest;  // the halves of a control rest alike
    const double value = value_from(rest);
    if (!std::isfinite(value)) return;
    for (const Index<Channel> c : channels) {
      double& now = values_[std::size_t(c.at)];
      if (additive)
        now += weight * (value - rest);
      else
        now = weight == 1 ? value : now + weight * (value - now);
    }
  }

  const FaceModel& model_;
  std::uint64_t seed_;
  double liveliness_, gestures_;
  BlinkHolds contacts_;  ///< of the topmost speech; later than now by `later`
  Values& values_;
};

void play_motions(const FaceModel& model, const Pose& pose, Values& values) {
  Playing playing(model, pose, values);
  for_each_motion(model, pose, [&](const Motion& motion, double weight, double begin) {
    if (&motion == default_clip_of(model, pose) && pose.basis) return;
    playing.play(motion, *pose.time - begin, weight);
  });
}

void look(const Face& rest, glm::dvec3 target, Values& values) {
  for (const Eye& eye : rest.model->eyes) {
    const glm::dvec2 gaze = look_at(*rest.model, eye, rest.vector, target);
    if (eye.gaze_x) values[std::size_t(eye.gaze_x.at)] = gaze.x;
    if (eye.gaze_y) values[std::size_t(eye.gaze_y.at)] = gaze.y;
  }
}

/// Applies the settings of controls; with `poses`, of the weights of poses too.
void override_channels(const FaceModel& model, const Pose& pose, bool poses, Values& values) {
  for (const Setting& setting : pose.settings) {
    if (!setting.control || setting.index < 0 || setting.index >= int(model.controls.size()) ||
        setting.values.empty() || std::isnan(setting.values[0]))
      continue;
    for (const Index<Channel> c : model.controls[std::size_t(setting.index)].channels)
      if (poses || !c.in(model.channels).pose) values[std::size_t(c.at)] = setting.values[0];
  }
}

void clamp(const FaceModel& model, bool poses, Values& values) {
  for (std::size_t c = 0; c < values.size(); ++c)
    if (const Channel& channel = model.channels[c]; channel.pose == poses)
      values[c] = std::clamp(values[c], channel.lo, channel.hi);
}

/// Lets poses move the controls they are coupled with.
void couple_channels(const FaceModel& model, Values& values) {
  for (std::size_t c = 0; c < values.size(); ++c)
    for (const Coupling& n : model.channels[c].couplings)
      values[std::size_t(n.channel.at)] += (values[c] - model.channels[c].rest) * n.by;
}

/// The mood gives way to what else is in the face: by twice as much as all other expressions together, so that these are
/// read at half their strength, too.
void fade_mood(const FaceModel& model, Values& values) {
  if (model.mood_shift.empty()) return;
  const auto at = [&](Index<Channel> c) -> double& { return values[std::size_t(c.at)]; };
  const auto is_mood = [&](Index<Channel> c) {
    return c.in(model.channels).rest != 0 && at(c) == c.in(model.channels).rest;
  };
  double others = 0;
  for (const Expression& one : model.expressions)
    if (!is_mood(one.left) && !is_mood(one.right))
      others += std::clamp(std::max(at(one.left), at(one.right)), 0.0, 1.0);
  if (others == 0) return;
  for (const Expression& one : model.expressions)
    for (const Index<Channel> c : {one.left, one.right})
      if (is_mood(c)) at(c) *= std::max(1 - 2 * others, 0.0);
}

/// The value of every channel: at rest, then by the motions, the gaze, settings, expressions, and poses'
/// couplings; settings of controls beat what expressions and poses do to them.
void set_channels(const Face& rest, const Pose& pose, Values& values) {
  const FaceModel& model = *rest.model;
  values.clear();
  for (const Channel& channel : model.channels) values.push_back(channel.rest);
  play_motions(model, pose, values);
  if (pose.look_at) look(rest, *pose.look_at, values);
  override_channels(model, pose, true, values);
  settle_expressions(model, values);
  fade_mood(model, values);
  move_channels(model, values);
  clamp(model, true, values);
  couple_channels(model, values);
  override_channels(model, pose, false, values);
  clamp(model, false, values);
}

/// The numbers without the mood.
FaceVector less_mood(const FaceModel& model, FaceVector vector) {
  const FaceVector& shift = model.mood_shift;
  for (std::size_t i = 0; i < std::min(shift.size(), vector.size()); ++i) vector[i] -= shift[i];
  return vector;
}

bool at_rest(const FaceModel& model, const Values& values) {
  for (std::size_t c = 0; c < values.size(); ++c)
    if (values[c] != model.channels[c].rest) return false;
  return true;
}

void take_basis(const FaceBasis& basis, const Pose& pose, FaceVector& vector) {
  if (!pose.basis_weights.empty() || !pose.time)
    decode_pca(basis.basis, pose.basis_weights, vector);
  else
    decode_pca(basis.basis, weights_at(basis, *pose.time), vector);
}

void put_numbers(const Setting& setting, FaceVector& vector) {
  if (setting.control || setting.index < 0) return;
  for (std::size_t i = 0; i < setting.values.size(); ++i)
    if (std::size_t(setting.index) + i < vector.size())
      vector[std::size_t(setting.index) + i] = setting.values[i];
}

/// Settings of an eyeball apply before the eyes' laws, which read it: a bulge held at 0 must not push. So do those of the
/// jaw that muscles open.
void hold_bodies(const FaceModel& model, const Pose& pose, FaceVector& vector) {
  for (const Setting& setting : pose.settings) {
    if (setting.control) continue;
    if (model.mouth && setting.index == model.layout[model.mouth->open].begin)
      put_numbers(setting, vector);
    for (const Eye& eye : model.eyes)
      for (const int slice : {eye.center, eye.radius, eye.cornea, eye.bulge}) {
        if (slice < 0) continue;
        const Slice& s = model.layout[slice];
        if (setting.index >= s.begin && setting.index < s.begin + s.size)
          put_numbers(setting, vector);
      }
  }
}

}  // namespace

struct Poser::Scratch {
  Face rest, neutral, posed;
  std::vector<double> values, drive;
  FaceVector before;                ///< the mouth's laws
  std::vector<DrawnPushes> pushes;  ///< the eyes' laws
  MusclePoser muscles;
  std::optional<UnwrapChart> chart;  ///< made when first needed

  explicit Scratch(Face face)
      : rest(std::move(face)),
        neutral{rest.model, less_mood(*rest.model, rest.vector)},
        posed(rest) {
    values.reserve(rest.model->channels.size());
  }

  void drive_channels(bool poses) {
    const FaceModel& model = *rest.model;
    for (std::size_t c = 0; c < values.size(); ++c)
      if (const Channel& channel = model.channels[c];
          channel.pose == poses && values[c] != channel.rest)
        mien::drive(channel, values[c], model.layout, posed.vector, drive);
  }
};

Poser::Poser(Face face) : scratch_(std::make_unique<Scratch>(std::move(face))) {}
Poser::Poser(Poser&&) noexcept = default;
Poser& Poser::operator=(Poser&&) noexcept = default;
Poser::~Poser() = default;

std::span<const double> Poser::pulls() const {
  return scratch_->muscles.pulls();
}

const Face& Poser::pose(const Pose& pose) {
  auto& [rest, neutral, posed, values, drive, before, pushes, muscles, chart] = *scratch_;
  const FaceModel& model = *rest.model;
  posed.vector = rest.vector;
  const bool by_basis = pose.basis && pose.basis->basis.columns == rest.vector.size();
  if (by_basis) take_basis(*pose.basis, pose, posed.vector);
  set_channels(rest, pose, values);
  const bool still = at_rest(model, values);
  const bool moody = !model.mood_shift.empty();
  if (!(moody && still)) {
    if (moody) posed.vector = less_mood(model, std::move(posed.vector));
    const FaceVector begin = by_basis ? posed.vector : FaceVector{};
    scratch_->drive_channels(true);
    muscles.act(neutral, pose, values, set_channels, posed.vector);
    scratch_->drive_channels(false);
    hold_bodies(model, pose, posed.vector);
    // A basis gives vectors that the laws of eyes and mouth have acted on already. They act only on what is moved on top.
    if (!by_basis || !still) {
      const FaceVector& drawn = by_basis ? begin : neutral.vector;
      pose_mouth(model, drawn, values, before, posed.vector);
      pose_eyes(model, drawn, values, posed.vector, pushes);
    }
    turn_head(model, values, posed.vector);
    close_lips(model, values, posed.vector);
  }
  if (pose.unwrap > 0) {
    if (!chart) chart.emplace(rest);
    chart->act(pose.unwrap_mode, pose.unwrap, posed.vector);
  }
  for (const Setting& setting : pose.settings) put_numbers(setting, posed.vector);
  apply_rules(model.layout, rest.vector, posed.vector);
  return posed;
}

Face without_mood(const Face& face) {
  if (face.model->mood_shift.empty()) return face;
  auto model = std::make_shared<FaceModel>(*face.model);
  model->mood_shift.clear();
  for (const Expression& expression : model->expressions)
    for (const Index<Channel> c : {expression.left, expression.right})
      model->channels[std::size_t(c.at)].rest = 0;
  return {std::move(model), less_mood(*face.model, face.vector)};
}

Face pose_face(const Face& face, const Pose& pose) {
  return Poser(face).pose(pose);
}

}  // namespace mien
