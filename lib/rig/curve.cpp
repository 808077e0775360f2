#include <mien/lib/rig/curve.h>

#include <algorithm>
#include <cmath>

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
  }
  return u;
}

/// time modulo period, in [0, period), for negative times too. fmod is exact.
double within_period(double time, double period) {
  double t = std::fmod(time, period);
  if (t < 0) t += period;
  return t < period ? t : 0;
}

double value_of(const KeyCurve& curve, double time) {
  const double t = curve.period > 0 ? within_period(time, curve.period) : time;
  const auto next = std::upper_bound(curve.keys.begin(), curve.keys.end(), t,
                                     [](double a, const CurveKey& key) { return a < key.time; });
  if (next == curve.keys.begin()) return next->value;
  const CurveKey& key = *(next - 1);
  if (next == curve.keys.end()) return key.value;
  const double u = (t - key.time) / (next->time - key.time);
  return key.value + eased(key.ease, u) * (next->value - key.value);
}

double value_of(const SineCurve& curve, double time) {
  const double wave = std::sin(curve.frequency * time + curve.phase);
  return curve.offset + curve.amplitude * (curve.absolute ? std::abs(wave) : wave);
}

}  // namespace

double value_at(const Curve& curve, double time) {
  return std::visit([&](const auto& c) { return value_of(c, time); }, curve);
}

}  // namespace mien
