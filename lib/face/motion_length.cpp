#include <mien/motion_length.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr double kLongestClip =
    3600;  ///< [s] periods that are together again later are never, to anybody who looks

bool is_of_chance(const Curve& curve) {
  const auto* keys = std::get_if<KeyCurve>(&curve);
  return std::holds_alternative<WanderCurve>(curve) ||
         (keys && keys->period > 0 && keys->jitter > 0);
}

/// [s] The last key's time of a curve that runs once; of others 0.
double end_of(const Curve& curve) {
  if (const auto* samples = std::get_if<SampledCurve>(&curve))
    return std::max(samples->table->times.back(), 0.0);
  const auto* keys = std::get_if<KeyCurve>(&curve);
  if (!keys || keys->period > 0) return 0;
  return std::max(keys->keys.back().time + keys->offset, 0.0);
}

/// Whether `period` goes into `time` a whole number of times, but for rounding.
bool divides(double period, double time) {
  constexpr double kRounding = 1e-9;
  const double turns = time / period;
  return std::abs(turns - std::round(turns)) <= kRounding * turns;
}

/// [s] The least time into which both go.
double meeting(double one, double other) {
  const double longer = std::max(one, other), shorter = std::min(one, other);
  for (int turns = 1; turns * longer <= kLongestClip; ++turns)
    if (divides(shorter, turns * longer)) return turns * longer;
  return one == other ? one : kNoEnd;
}

}  // namespace

double period_of(const Curve& curve) {
  if (const auto* keys = std::get_if<KeyCurve>(&curve)) return keys->period;
  if (const auto* wander = std::get_if<WanderCurve>(&curve)) return wander->period;
  const auto* sine = std::get_if<SineCurve>(&curve);
  if (!sine || sine->frequency == 0 || sine->amplitude == 0) return 0;
  return (sine->absolute ? 1 : 2) * M_PI / std::abs(sine->frequency);
}

double motion_length(const Motion& motion) {
  if (!motion.idle.empty()) return kNoEnd;
  double period = 0, end = 0;
  for (const MotionChannel& channel : motion.channels)
    for (const Curve& curve : channel.curves) {
      if (is_of_chance(curve)) return kNoEnd;
      const double its = period_of(curve);
      if (its > 0) period = period > 0 ? meeting(period, its) : its;
      end = std::max(end, end_of(curve));
    }
  if (period == 0 || period == kNoEnd) return std::max(period, end);
  return period * std::max(std::ceil(end / period), 1.0);
}

}  // namespace mien
