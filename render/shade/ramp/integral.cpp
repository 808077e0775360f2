#include "render/shade/ramp/integral.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace mien {

void RampIntegral::make(const Ramp& ramp) {
  const auto& at = ramp.at();
  const auto& mixes = ramp.mixes();
  pieces_.clear();
  constexpr double kShortest = 1e-30;  // shorter ones are one jump
  from_ = 0.25 * at.front();           // quarters cannot overflow
  const double quarter = 0.25 * at.back() - from_;
  const bool has_length = quarter > kShortest;
  length_ = at.back() - at.front(), scale_ = has_length ? 1.0 / quarter : 1.0;
  const auto place = [&](std::size_t i) {
    return has_length ? (0.25 * at[i] - from_) * scale_ : 0.0;
  };
  least_ = most_ = mixes[0];
  steepest_ = ramp.jumps() ? HUGE_VAL : ramp.steepest();
  for (const Mix& mix : mixes) least_ = glm::min(least_, mix), most_ = glm::max(most_, mix);
  const bool pad = ramp.extend() == Extend::pad;
  const double period = pad ? 0.0 : ramp.extend() == Extend::repeat ? 1.0 : 2.0;
  std::vector<double> begins;
  if (pad) add(begins, 0.0, mixes.front(), Mix{0.0});
  const auto between = [&](std::size_t i, std::size_t k, double from, double length) {
    if (length > 0.0) add(begins, from, mixes[i], (mixes[k] - mixes[i]) / length);
  };
  const std::size_t last = at.size() - 1;
  for (std::size_t i = 0; i < last; ++i) between(i, i + 1, place(i), place(i + 1) - place(i));
  if (ramp.extend() == Extend::reflect)
    for (std::size_t i = last; i > 0; --i)
      between(i, i - 1, 2.0 - place(i), place(i) - place(i - 1));
  if (pad || pieces_.empty()) add(begins, place(last), mixes.back(), Mix{0.0});
  index_.make(std::move(begins), has_length ? period : 0.0);
  sum_up();
}

void RampIntegral::add(std::vector<double>& begins, double begin, const Mix& value,
                       const Mix& slope) {
  begins.push_back(begin);
  pieces_.push_back({Mix{0.0}, Mix{0.0}, 0.5 * value, slope / 6.0});
}

/// The integrals at the beginnings of pieces. Over a period both are made to return to 0.
void RampIntegral::sum_up() {
  const double period = index_.period();
  const auto length = [&](std::size_t i) {
    const double end = i + 1 < pieces_.size() ? index_.begin(i + 1) : period;
    return std::max(end - index_.begin(i), 0.0);
  };
  mean_ = 0.5 * (pieces_.front().value(0.0) + pieces_.back().value(0.0));
  if (period > 0.0) {
    mean_ = Mix{0.0};
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      mean_ += length(i) / period * pieces_[i].value(0.5 * length(i));
  }
  for (Piece& p : pieces_) p.c2 -= 0.5 * mean_;
  Mix begin{0.0};
  for (int round = 0; round < 2; ++round) {
    Mix first = begin, second{0.0};
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Piece& p = pieces_[i];
      p.c0 = second, p.c1 = first;
      second = p.second(length(i)), first = p.first(length(i));
    }
    if (!(period > 0.0)) return;
    begin = -second / period;
  }
}

/// The mean of the first integral from s to t.
Mix RampIntegral::mean_first(double s, double t, double near) const {
  if (std::abs(t - s) > near) return 1.0 / (t - s) * (second(t) - second(s));
  return (first(s) + 4.0 * first(0.5 * (s + t)) + first(t)) / 6.0;
}

RampPlane RampIntegral::scaled(const RampPlane& plane) const {
  const double by = 0.25 * scale_;
  return {(0.25 * plane.t - from_) * scale_, by * plane.gx, by * plane.gy};
}

Mix RampIntegral::right_of(const RampPlane& plane, double xa, double ya, double xb, double yb,
                           double right) const {
  const double high = yb - ya;
  const double near = narrow(plane);
  if (std::abs(plane.gx) > near)
    return high / plane.gx *
           (mean_first(plane.at(right, ya), plane.at(right, yb), near) -
            mean_first(plane.at(xa, ya), plane.at(xb, yb), near));
  // Level lines run along rows: each row has the place of its middle.
  const double wa = right - xa, wb = right - xb;
  const double s = plane.at(0.5 * (right + xa), ya), t = plane.at(0.5 * (right + xb), yb),
               by = t - s;
  if (std::abs(by) > near)
    return high / by * (wb * first(t) - wa * first(s) - (wb - wa) / by * (second(t) - second(s)));
  if (std::abs(by) > kNarrow * near) return 0.5 * high * (wa + wb) / by * (first(t) - first(s));
  return 0.5 * high * (wa + wb) * value(0.5 * (s + t));
}

bool RampIntegral::straight(double s, double reach, Mix& color) const {
  double low = s - reach, high = s + reach;
  if (index_.find(low) != index_.find(high) || !(high - low > reach)) return false;
  color = mean_ + value(s);
  return true;
}

Mix RampIntegral::box_mean(const RampPlane& plane, double width) const {
  const double h = 0.5 * width;
  return mean_ + 1.0 / (width * width) * right_of(plane, -h, -h, -h, h, h);
}

void RampIntegral::row_means(const RampPlane& plane, int x, int y, std::span<Mix> to) const {
  const double near = narrow(plane);
  const auto box = [&](int i) {
    return box_mean({plane.at(x + i + 0.5, y + 0.5), plane.gx, plane.gy}, 1.0);
  };
  const auto left_of = [&](int i) {
    return mean_first(plane.at(x + i, y), plane.at(x + i, y + 1), near);
  };
  if (plane.gx == 0.0) return std::fill(to.begin(), to.end(), box(0));
  const bool level = std::abs(plane.gx) <= near;
  Mix left = left_of(0);
  for (int i = 0; i < int(to.size()); ++i) {
    const Mix right = left_of(i + 1);
    to[std::size_t(i)] = level ? box(i) : mean_ + (right - left) / plane.gx;
    left = right;
  }
}

}  // namespace mien
