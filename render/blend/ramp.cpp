#include "render/blend/ramp.h"
#include "sdf/scene/extended_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mien {

void Ramp::make(const Gradient& gradient, double opacity, Blend blend) {
  at_.clear(), mix_.clear();
  extend_ = gradient.extend, jumps_ = false;
  least_opacity_ = 1, most_opacity_ = 0;
  double place = -std::numeric_limits<double>::infinity();
  std::array<Color, 4> known;  // stripes have few colours, and powers take their time
  for (const Stop& stop : gradient.stops) {
    if (!std::isfinite(stop.at)) continue;  // it is nowhere
    place = std::max(place, stop.at);       // places do not fall
    Color color = stop.color;
    color.a = std::clamp(color.a, 0.0, 1.0) * std::clamp(opacity, 0.0, 1.0);
    at_.push_back(place);
    std::size_t back = 1;
    while (back <= std::min(known.size(), mix_.size()) &&
           known[(mix_.size() - back) % known.size()] != color)
      ++back;
    const bool is_known = back <= std::min(known.size(), mix_.size());
    known[mix_.size() % known.size()] = color;
    mix_.push_back(is_known ? Mix(mix_[mix_.size() - back]) : mix_from_color(color, blend));
  }
  if (at_.empty()) at_ = {0.0}, mix_ = {Mix{0.0}};
  if (!(at_.back() > at_.front())) extend_ = Extend::pad;  // nothing to repeat
  for (std::size_t i = 0; i < at_.size(); ++i) {
    least_opacity_ = std::min(least_opacity_, mix_[i].a);
    most_opacity_ = std::max(most_opacity_, mix_[i].a);
    if (i > 0 && at_[i] == at_[i - 1] && mix_[i] != mix_[i - 1]) jumps_ = true;
  }
  if (extend_ == Extend::repeat && mix_.back() != mix_.front()) jumps_ = true;
}

void Ramp::pad() {
  extend_ = Extend::pad, jumps_ = false;
  for (std::size_t i = 1; i < at_.size(); ++i)
    jumps_ = jumps_ || (at_[i] == at_[i - 1] && mix_[i] != mix_[i - 1]);
}

Mix Ramp::color(double t) const {
  const double s = extended_place(extend_, at_.front(), at_.back(), t);
  if (!(s >= at_.front())) return mix_.front();
  if (s >= at_.back()) return mix_.back();
  const auto after = std::upper_bound(at_.begin(), at_.end(), s);  // neither first nor past the end
  const auto i = std::size_t(after - at_.begin());
  const double u = (s - at_[i - 1]) / (at_[i] - at_[i - 1]);
  return mix_[i - 1] + u * (mix_[i] - mix_[i - 1]);
}

double Ramp::steepest() const {
  double most = 0.0;
  for (std::size_t i = 1; i < at_.size(); ++i) {
    const Mix by = mix_[i] - mix_[i - 1];
    const double length = at_[i] - at_[i - 1];
    if (length > 0.0)
      most = std::max(
          most,
          std::max({std::abs(by.r), std::abs(by.g), std::abs(by.b), std::abs(by.a)}) / length);
  }
  return most;
}

/// The stops of one run of the ramp that begins at `begin`.
void Ramp::add_kinks(double begin, bool backward, double lo, double hi,
                     std::vector<double>& kinks) const {
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const double place =
        backward ? begin + (at_.back() - at_[at_.size() - 1 - i]) : begin + (at_[i] - at_.front());
    if (place > lo && place < hi && (kinks.empty() || kinks.back() != place))
      kinks.push_back(place);
  }
}

bool Ramp::kinks(double lo, double hi, int most, std::vector<double>& to) const {
  to.clear();
  const double first = at_.front(), length = at_.back() - first;
  if (extend_ == Extend::pad) {
    add_kinks(first, false, lo, hi, to);
  } else {
    const double from = std::floor((lo - first) / length),
                 until = std::floor((hi - first) / length);
    if (!(until - from <= double(most))) return false;
    for (double turn = from; turn <= until; turn += 1.0)
      add_kinks(first + turn * length, extend_ == Extend::reflect && std::fmod(turn, 2.0) != 0.0,
                lo, hi, to);
  }
  if (int(to.size()) <= most) return true;
  to.clear();
  for (const double end : {first, first + length})
    if (extend_ == Extend::pad && end > lo && end < hi) to.push_back(end);
  return false;
}

}  // namespace mien
