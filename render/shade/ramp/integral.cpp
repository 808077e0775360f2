#include "render/shade/ramp/integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace mien {

void RampIntegral::make(const Ramp& ramp) {
  steepest_ = ramp.jumps() ? HUGE_VAL : ramp.steepest();
  make(ramp.at(), ramp.mixes(), ramp.extend());
}

void RampIntegral::make(double from, double to, const Mix& first, const Mix& last) {
  steepest_ = to > from ? largest(glm::abs(last - first)) / (to - from) : HUGE_VAL;
  make(std::array{from, to}, std::array{first, last}, Extend::pad);
}

void RampIntegral::make(std::span<const double> at, std::span<const Mix> mixes, Extend extend) {
  pieces_.clear(), index_.begins.clear();
  constexpr double kShortest = 1e-30;  // shorter ones are one jump
  from_ = 0.25 * at.front();           // quarters cannot overflow
  const double quarter = 0.25 * at.back() - from_;
  const bool has_length = quarter > kShortest;
  length_ = at.back() - at.front(), scale_ = has_length ? 1.0 / quarter : 1.0;
  const auto place = [&](std::size_t i) {
    return has_length ? (0.25 * at[i] - from_) * scale_ : 0.0;
  };
  least_ = most_ = mixes[0];
  for (const Mix& mix : mixes) least_ = glm::min(least_, mix), most_ = glm::max(most_, mix);
  const bool pad = extend == Extend::pad;
  const double period = pad ? 0.0 : extend == Extend::repeat ? 1.0 : 2.0;
  if (pad) add(0.0, mixes.front(), Mix{0.0});
  const auto between = [&](std::size_t i, std::size_t k, double from, double length) {
    if (length > 0.0) add(from, mixes[i], (mixes[k] - mixes[i]) / length);
  };
  const std::size_t last = at.size() - 1;
  for (std::size_t i = 0; i < last; ++i) between(i, i + 1, place(i), place(i + 1) - place(i));
  if (extend == Extend::reflect)
    for (std::size_t i = last; i > 0; --i)
      between(i, i - 1, 2.0 - place(i), place(i) - place(i - 1));
  if (pad || pieces_.empty()) add(place(last), mixes.back(), Mix{0.0});
  index_.make(has_length ? period : 0.0);
  sum_up();
}

void RampIntegral::add(double begin, const Mix& value, const Mix& slope) {
  index_.begins.push_back(begin);
  pieces_.push_back({Mix{0.0}, Mix{0.0}, 0.5 * value, slope / 6.0});
}

/// The integrals at the beginnings of pieces. Over a period both are made to return to 0.
void RampIntegral::sum_up() {
  const double period = index_.period;
  const auto length = [&](std::size_t i) {
    const double end = i + 1 < pieces_.size() ? index_.begins[i + 1] : period;
    return std::max(end - index_.begins[i], 0.0);
  };
  mean_ = pieces_.front().c2 + pieces_.back().c2;
  if (period > 0.0) {
    mean_ = Mix{0.0};
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      mean_ += length(i) / period * (2.0 * pieces_[i].c2 + 3.0 * length(i) * pieces_[i].c3);
  }
  longest_ = period > 0.0 ? 0.0 : HUGE_VAL;  // the ends hold
  for (std::size_t i = 0; i < pieces_.size(); ++i) longest_ = std::max(longest_, length(i));
  for (Piece& p : pieces_) p.c2 -= 0.5 * mean_;
  Mix begin{0.0};
  for (int round = 0; round < 2; ++round) {
    Mix first = begin, second{0.0};
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Piece& p = pieces_[i];
      const double u = length(i);
      p.c0 = second, p.c1 = first;
      second = p.c0 + u * (p.c1 + u * (p.c2 + u * p.c3));
      first = p.c1 + u * (2.0 * p.c2 + 3.0 * u * p.c3);
    }
    if (!(period > 0.0)) return;
    begin = -second / period;
  }
}

RampPlane RampIntegral::scaled(const RampPlane& plane) const {
  const double by = 0.25 * scale_;
  return {(0.25 * plane.t - from_) * scale_, by * plane.gx, by * plane.gy};
}

}  // namespace mien
