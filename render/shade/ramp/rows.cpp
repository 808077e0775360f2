#include "render/shade/ramp/rows.h"

#include <algorithm>
#include <cmath>

namespace mien {

void RampRows::make(const RampIntegral& ramp, const RampPlane& plane) {
  plane_ = plane, mean_ = ramp.mean();
  const double wide = std::abs(plane.gy), along = std::abs(plane.gx),
               near = RampIntegral::narrow(plane);
  level_ = along <= near;
  const bool smears = wide > near;
  const double half = smears ? 0.5 * wide : 0.0, period = ramp.index().period();
  // Where a piece begins for one end of the smear or the other.
  std::vector<double> begins{period > 0.0 ? 0.0 : -half - 1.0}, some;
  for (const double by : {-half, half}) {
    some.clear();
    for (std::size_t i = 0; i < ramp.index().size(); ++i) {
      const double s = ramp.index().begin(i) + by;
      some.push_back(period > 0.0 ? s - period * std::floor(s / period) : s);
    }
    const auto wrap = std::is_sorted_until(some.begin(), some.end());
    std::rotate(some.begin(), wrap, some.end());
    const auto middle = begins.insert(begins.end(), some.begin(), some.end());
    std::inplace_merge(begins.begin(), middle, begins.end());
  }
  begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
  offset_ = period > 0.0 ? 0.0 : begins.front();
  pieces_.resize(begins.size());
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const double end = i + 1 < begins.size() ? begins[i + 1]
                       : period > 0.0        ? period
                                             : begins[i] + 1,
                 u = 0.5 * (begins[i] - end);
    Piece p = smeared(ramp, begins[i] - u, half);  // what it is inside, continued to its beginning
    auto& c = p.c;
    p = {{c[0] + u * (c[1] + u * (c[2] + u * c[3])), c[1] + u * (2.0 * c[2] + 3.0 * u * c[3]),
          c[2] + 3.0 * u * c[3], c[3]}};
    pieces_[i] = level_ ? Piece{{c[1], 2.0 * c[2], 3.0 * c[3], Mix{0.0}}} : p;
  }
  for (double& begin : begins) begin -= offset_;
  index_.make(std::move(begins), period);
}

/// Around a place that is inside a piece.
RampRows::Piece RampRows::smeared(const RampIntegral& ramp, double middle, double half) const {
  const RampIntegral::Piece a = ramp.from(middle + half);
  if (half == 0.0) return {{a.first, a.value, 0.5 * a.slope, Mix{0.0}}};
  const RampIntegral::Piece b = ramp.from(middle - half);
  const double over = 0.5 / half;
  return {{over * (a.second - b.second), over * (a.first - b.first),
           0.5 * over * (a.value - b.value), over / 6.0 * (a.slope - b.slope)}};
}

void RampRows::means(int x0, int y, int from, int count, ColorRow& to) const {
  const double first = plane_.at(x0 + (level_ ? 0.5 : 0.0), y + 0.5) - offset_;
  means_of_ramp_row(
      index_, pieces_.data(),
      {first, plane_.gx, from, count, level_, 1.0 / (level_ ? 1.0 : plane_.gx), mean_}, to);
}

}  // namespace mien
