#include <mien/render/blend/ramp.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {
namespace {

double largest(const Mix& d) {
  return std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b), std::abs(d.a)});
}

}  // namespace

Ramp::Ramp(const Gradient& gradient, double opacity, Blend blend) : extend_(gradient.extend) {
  double place = -std::numeric_limits<double>::infinity();
  for (const Stop& stop : gradient.stops) {
    place = std::max(place, stop.at);  // places do not fall
    Color color = stop.color;
    color.a = std::clamp(color.a, 0.0, 1.0) * std::clamp(opacity, 0.0, 1.0);
    at_.push_back(place);
    mix_.push_back(mix_from_color(color, blend));
  }
  if (at_.empty()) at_ = {0.0}, mix_ = {Mix{0.0}};
  if (!(at_.back() > at_.front())) extend_ = Extend::pad;  // nothing to repeat
  for (std::size_t i = 0; i < at_.size(); ++i) {
    least_opacity_ = std::min(least_opacity_, mix_[i].a);
    most_opacity_ = std::max(most_opacity_, mix_[i].a);
    if (i == 0) continue;
    const double change = largest(mix_[i] - mix_[i - 1]), length = at_[i] - at_[i - 1];
    if (length > 0.0)
      steepest_ = std::max(steepest_, change / length);
    else
      highest_jump_ = std::max(highest_jump_, change);
  }
  if (extend_ == Extend::repeat)
    highest_jump_ = std::max(highest_jump_, largest(mix_.back() - mix_.front()));
}

/// t brought between the first and the last stop.
double Ramp::inner(double t) const {
  const double first = at_.front(), length = at_.back() - first;
  if (extend_ == Extend::pad) return t;
  const double turns = (t - first) / length, whole = std::floor(turns);
  const double part = (turns - whole) * length;
  const bool back = extend_ == Extend::reflect && std::fmod(whole, 2.0) != 0.0;
  return first + (back ? length - part : part);
}

Mix Ramp::color(double t) const {
  const double s = inner(t);
  if (!(s >= at_.front())) return mix_.front();
  if (s >= at_.back()) return mix_.back();
  const auto after = std::upper_bound(at_.begin(), at_.end(), s);  // neither first nor past the end
  const auto i = std::size_t(after - at_.begin());
  const double u = (s - at_[i - 1]) / (at_[i] - at_[i - 1]);
  return mix_[i - 1] + u * (mix_[i] - mix_[i - 1]);
}

bool Ramp::same_everywhere(double lo, double hi) const {
  if (extend_ == Extend::pad) {
    if (hi <= at_.front() || lo >= at_.back()) return true;
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (at_[i] > lo && at_[i - 1] < hi && mix_[i] != mix_[i - 1]) return false;
    // Between the ends all that is met is level; a lone end's colour joins its neighbour's.
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (at_[i] == at_[i - 1] && at_[i] >= lo && at_[i] <= hi && mix_[i] != mix_[i - 1])
        return false;
    return true;
  }
  return steepest_ == 0.0 && highest_jump_ == 0.0;
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
    const double from = std::floor((lo - first) / length), until = std::floor((hi - first) / length);
    if (!(until - from <= double(most))) return false;
    for (double turn = from; turn <= until; turn += 1.0)
      add_kinks(first + turn * length, extend_ == Extend::reflect && std::fmod(turn, 2.0) != 0.0,
                lo, hi, to);
  }
  if (int(to.size()) <= most) return true;
  to.clear();
  return false;
}

Ramp::Range Ramp::range(double lo, double hi, std::vector<double>& kinks) const {
  kinks.clear();
  if (same_everywhere(lo, hi)) return {};
  Range range{.constant = false, .slope = steepest_, .jump = highest_jump_};
  if (extend_ == Extend::pad) {
    range.slope = range.jump = 0.0;
    for (std::size_t i = 1; i < at_.size(); ++i) {
      if (!(at_[i] >= lo && at_[i - 1] <= hi)) continue;
      const double change = largest(mix_[i] - mix_[i - 1]), length = at_[i] - at_[i - 1];
      if (length > 0.0)
        range.slope = std::max(range.slope, change / length);
      else
        range.jump = std::max(range.jump, change);
    }
    add_kinks(at_.front(), false, lo, hi, kinks);
  } else {
    const double first = at_.front(), length = at_.back() - first;
    const double from = std::floor((lo - first) / length), to = std::floor((hi - first) / length);
    if (!(to - from <= double(kMostKinks))) range.many = true;
    for (double turn = from; !range.many && turn <= to; turn += 1.0)
      add_kinks(first + turn * length, extend_ == Extend::reflect && std::fmod(turn, 2.0) != 0.0,
                lo, hi, kinks);
  }
  if (kinks.size() > kMostKinks) range.many = true;
  if (range.many) kinks.clear();
  if (kinks.empty() && !range.many) range.jump = 0.0;
  return range;
}

}  // namespace mien
