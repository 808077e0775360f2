#include <mien/steady_frames.h>

#include <mien/face_model.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mien {
namespace {

constexpr double kSpeedCutoff = 1;  ///< [Hz]
constexpr double kLongestGap = 1;   ///< [s]

/// The share of a new number.
double share_of_new(double cutoff, double gap) {
  const double turn = 2 * std::numbers::pi * cutoff * gap;
  return turn / (turn + 1);
}

/// How far a control goes; 1 of one that does not go.
double range_of(const FaceModel& model, const Control& control) {
  const Channel& channel = control.channels[0].in(model.channels);
  return channel.hi > channel.lo ? channel.hi - channel.lo : 1;
}

}  // namespace

SteadyFrames::SteadyFrames(const Steadiness& steadiness) : steadiness_(steadiness) {
  constexpr double kMost = 1e6;
  const auto within = [](double number, double least) {
    return number >= least && number <= kMost;
  };
  if (!within(steadiness.cutoff, 1e-6)) steadiness_.cutoff = Steadiness{}.cutoff;
  if (!within(steadiness.beta, 0)) steadiness_.beta = Steadiness{}.beta;
}

double SteadyFrames::step(Number& number, double seen, double range, double gap) const {
  const double speed = (seen - number.seen) / gap / range;
  number.speed += share_of_new(kSpeedCutoff, gap) * (speed - number.speed);
  const double cutoff = steadiness_.cutoff + steadiness_.beta * std::abs(number.speed);
  number.value += share_of_new(cutoff, gap) * (seen - number.value);
  number.seen = seen;
  return number.value;
}

std::vector<Setting> SteadyFrames::steadied(const Face& face, std::vector<Setting> settings,
                                            double time) {
  const double gap = time - time_;
  if (!(gap > 0 && gap <= kLongestGap)) numbers_.clear();
  time_ = time;
  std::unordered_map<int, Number> now;
  for (Setting& setting : settings) {
    if (!setting.control || setting.values.size() != 1 || setting.index < 0 ||
        setting.index >= int(face.model->controls.size()))
      continue;
    double& value = setting.values[0];
    const auto before = numbers_.find(setting.index);
    Number number = before == numbers_.end() ? Number{value, value, 0} : before->second;
    const Control& control = face.model->controls[std::size_t(setting.index)];
    if (before != numbers_.end()) value = step(number, value, range_of(*face.model, control), gap);
    now[setting.index] = number;
  }
  numbers_ = std::move(now);
  return settings;
}

}  // namespace mien
