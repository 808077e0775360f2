#include "lib/rig/pose/curve.h"

#include "lib/math/degrees.h"
#include "lib/rig/pose/chance.h"

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
struct Moment {
  double count, time;
};

/// Works for negative times too. fmod is exact.
Moment within_period(double time, double period) {
  double t = std::fmod(time, period);
  if (t < 0) t += period;
  if (!(t < period)) t = 0;
  return {std::round((time - t) / period), t};
}

// Streams of chance(): what a random number of a seed is for. A wander's own streams come after.
constexpr std::uint32_t kWhen = 0, kWhether = 1, kFirstOwn = 2;

/// The random numbers of a curve's seed.
class Draws {
 public:
  Draws(const CurveSeed& seed, const Temper& temper)
      : first_(seed.personal ? mixed_bits(temper.seed ^ mixed_bits(seed.number))
                             : std::uint64_t(seed.number) << 32),
        personal_(seed.personal) {}

  double operator()(std::uint32_t stream, double count) const {
    return chance(first_ + stream, count);
  }
  /// The share of a turn by which the curve's time is shifted.
  double shift() const { return personal_ ? chance(~first_, 0) : 0; }

 private:
  std::uint64_t first_;
  bool personal_;
};

double value_of(const KeyCurve& curve, double time, const Temper& temper) {
  double t = time - curve.offset;
  if (curve.period > 0) {
    const Draws draw(curve.seed, temper);
    const Moment moment = within_period(t + draw.shift() * curve.period, curve.period);
    t = moment.time;
    if (curve.share && !(draw(kWhether, moment.count) < *curve.share * temper.liveliness))
      return curve.keys[0].value;
    if (curve.jitter > 0) t -= curve.jitter * draw(kWhen, moment.count);
  }
  const auto next = std::upper_bound(curve.keys.begin(), curve.keys.end(), t,
                                     [](double a, const CurveKey& key) { return a < key.time; });
  if (next == curve.keys.begin()) return next->value;
  const CurveKey& key = *(next - 1);
  if (next == curve.keys.end()) return key.value;
  const double u = (t - key.time) / (next->time - key.time);
  return key.value + eased(key.ease, u) * (next->value - key.value);
}

double value_of(const SineCurve& curve, double time, const Temper& temper) {
  const double shift = 2 * std::numbers::pi * Draws(curve.seed, temper).shift();
  // The C library's sine has other last bits on other machines.
  const double angle = curve.frequency * time + (curve.phase + shift);
  const double wave = direction_at(angle * (180 / std::numbers::pi)).y;
  return curve.offset + curve.amplitude * (curve.absolute ? std::abs(wave) : wave);
}

/// Where a wander rests after the move of that period.
double resting_place(const WanderCurve& curve, const Draws& draw, double count) {
  if (draw(kWhether, count) < curve.home) return curve.center;
  return curve.center + curve.amplitude * (2 * draw(kFirstOwn + curve.stream, count) - 1);
}

double value_of(const WanderCurve& curve, double time, const Temper& temper) {
  const Draws draw(curve.seed, temper);
  const Moment moment =
      within_period(time - curve.offset + draw.shift() * curve.period, curve.period);
  const double begin = curve.jitter * draw(kWhen, moment.count);
  const double from = resting_place(curve, draw, moment.count - 1);
  if (moment.time <= begin) return from;
  const double to = resting_place(curve, draw, moment.count);
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

double value_of(const SampledCurve& curve, double time, const Temper&) {
  const SampleTable& table = *curve.table;
  const std::vector<double>& times = table.times;
  if (!(time > times.front())) return double(table.at(0, curve.column));
  if (time >= times.back()) return double(table.at(times.size() - 1, curve.column));
  const std::size_t row = row_at(times, time);
  const double a = double(table.at(row, curve.column)), b = double(table.at(row + 1, curve.column));
  return a == b ? a : a + (time - times[row]) / (times[row + 1] - times[row]) * (b - a);
}

}  // namespace

double value_at(const Curve& curve, double time, const Temper& temper) {
  return std::visit([&](const auto& c) { return value_of(c, time, temper); }, curve);
}

bool is_played_by_chance(const Curve& curve) {
  const auto* keys = std::get_if<KeyCurve>(&curve);
  return keys && keys->period > 0 && keys->share;
}

}  // namespace mien
