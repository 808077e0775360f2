#include "render/shade/ramp/softness.h"

#include <algorithm>
#include <cmath>

namespace mien {

void RampSoftness::make(const PaintField& field, const RampIntegral& integral, double left,
                        const Ramp* ramp) {
  field_ = field, period_ = integral.period();
  at_.clear(), sums_.clear();
  constexpr double kSoftest = 1e-6;
  const double range = std::max(integral.range(), 1e-12);
  const double soft =
      std::max(std::min(1.0, integral.steepest() * field_.per_pixel / range), kSoftest);
  allowed_ = left / soft;
  if (!ramp) return;
  const std::vector<double>& places = ramp->at();
  // Of one run; from one run to the next the slope changes from the last to the first.
  const double steepest = soft * range / field_.per_pixel;
  double sum = 0.0;
  Mix slope{0.0};
  const auto turn = [&](double at, const Mix& to) {
    sum += ramp->jumps() ? HUGE_VAL : largest(glm::abs(to - slope)) / steepest;
    at_.push_back(at), sums_.push_back(sum), slope = to;
  };
  for (std::size_t i = 1; i < places.size(); ++i)
    if (const double length = places[i] - places[i - 1]; length > 0.0)
      turn(places[i - 1], (ramp->mixes()[i] - ramp->mixes()[i - 1]) / length);
  turn(places.back(), Mix{0.0});
}

double RampSoftness::turns(double distance, double reach) const {
  const double t = field_.at({}, distance), around = reach * field_.per_pixel;
  if (period_ > 0.0) return 2.0 * sums_.back() * (1.0 + std::ceil(2.0 * around / period_));
  const auto up_to = [&](double place) {
    const auto k = std::upper_bound(at_.begin(), at_.end(), place) - at_.begin();
    return k > 0 ? sums_[std::size_t(k - 1)] : 0.0;
  };
  const double sum = up_to(t + around);
  return sum < HUGE_VAL ? sum - up_to(t - around) : sum;
}

}  // namespace mien
