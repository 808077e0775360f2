#include "lib/rig/pose/curve.h"

#include "lib/math/chance.h"
#include "lib/math/degrees.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mien {
namespace {

double eased(Ease ease, double u) {
  switch (ease) {
    case Ease::linear:
      return u;
    case Ease::step:
      return 0;
    case Ease::smooth:
      return u * u * (3 - 2 * u);
    case Ease::in:
      return u * u;
    case Ease::out:
      return u * (2 - u);
    case Ease::overshoot: {
      const double v = u - 1;
      return 1 + v * v * (2.70158 * v + 1.70158);
    }
  }
  return u;
}

/// A moment in a period: which one it is, and how far in, in [0, period).
struct PeriodMoment {
  double count, time;
};

/// Works for negative times too. fmod is exact.
PeriodMoment within_period(double time, double period) {
  double t = std::fmod(time, period);
  if (t < 0) t += period;
  if (!(t < period)) t = 0;
  return {std::round((time - t) / period), t};
}

// Streams of chance(): what a random number of a seed is for. A wander's own streams come after.
constexpr std::uint32_t kWhen = 0, kWhether = 1, kFirstOwn = 2;

double value_of(const KeyCurve& curve, double time) {
  double t = time - curve.offset;
  if (curve.period > 0) {
    const PeriodMoment moment = within_period(t, curve.period);
    t = moment.time;
    if (curve.jitter > 0) t -= curve.jitter * chance(curve.seed, kWhen, moment.count);
  }
  const auto next = std::upper_bound(curve.keys.begin(), curve.keys.end(), t,
                                     [](double a, const CurveKey& key) { return a < key.time; });
  if (next == curve.keys.begin()) return next->value;
  const CurveKey& key = *(next - 1);
  if (next == curve.keys.end()) return key.value;
  const double u = (t - key.time) / (next->time - key.time);
  return key.value + eased(key.ease, u) * (next->value - key.value);
}

double value_of(const SineCurve& curve, double time) {
  // The C library's sine has other last bits on other machines.
  const double angle = curve.frequency * time + curve.phase;
  const double wave = direction_at(angle * (180 / std::numbers::pi)).y;
  return curve.offset + curve.amplitude * (curve.absolute ? std::abs(wave) : wave);
}

/// Where a wander rests after the move of that period.
double resting_place(const WanderCurve& curve, double count) {
  if (chance(curve.seed, kWhether, count) < curve.home) return curve.center;
  return curve.center +
         curve.amplitude * (2 * chance(curve.seed, kFirstOwn + curve.stream, count) - 1);
}

double value_of(const WanderCurve& curve, double time) {
  const PeriodMoment moment = within_period(time - curve.offset, curve.period);
  const double begin = curve.jitter * chance(curve.seed, kWhen, moment.count);
  const double from = resting_place(curve, moment.count - 1);
  if (moment.time <= begin) return from;
  const double to = resting_place(curve, moment.count);
  if (moment.time >= begin + curve.move) return to;
  return from + eased(curve.ease, (moment.time - begin) / curve.move) * (to - from);
}

/// The last row that is not later than `time`, which lies between the first and the last. Rows mostly come at equal steps,
/// so it is near the one that they would give.
std::size_t row_at(const std::vector<double>& times, double time) {
  const std::size_t last = times.size() - 1;
  const double share = (time - times[0]) / (times[last] - times[0]);
  std::size_t lo = std::min(std::size_t(share * double(last)), last), step = 1;
  std::size_t hi = lo;
  for (; lo > 0 && times[lo] > time; step *= 2) hi = lo, lo -= std::min(step, lo);
  for (step = 1, hi = std::max(hi, lo); hi < last && times[hi] <= time; step *= 2)
    lo = hi, hi += std::min(step, last - hi);
  const auto begin = times.begin();
  const auto after = std::upper_bound(begin + std::ptrdiff_t(lo), begin + std::ptrdiff_t(hi), time);
  return std::size_t(after - begin) - 1;
}

double value_of(const SampledCurve& curve, double time) {
  const SampleTable& table = *curve.table;
  const std::vector<double>& times = table.times;
  if (!(time > times.front())) return double(table.at(0, curve.column));
  if (time >= times.back()) return double(table.at(times.size() - 1, curve.column));
  const std::size_t row = row_at(times, time);
  const double a = double(table.at(row, curve.column)), b = double(table.at(row + 1, curve.column));
  return a == b ? a : a + (time - times[row]) / (times[row + 1] - times[row]) * (b - a);
}

}  // namespace

double value_at(const Curve& curve, double time) {
  return std::visit([&](const auto& c) { return value_of(c, time); }, curve);
}

}  // namespace mien
