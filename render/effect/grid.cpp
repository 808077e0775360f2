#include "row_effect_private.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// Lines cover the square of a pixel by cx across and cy down; together by cx + cy − cx cy, exactly.
class Grid final : public RowEffect {
 public:
  Grid(const GridEffect& effect, int width) : effect_(effect), cell_(double(width) / effect.cells) {
    for (int x = 0; x < width; ++x) across_.push_back(covered(x));
  }

  bool next(const NextRow& in, float* row) override {
    if (!in(row)) return false;
    const double down = covered(y_++);
    const Color& c = effect_.color;
    const double line[4] = {c.r * c.a, c.g * c.a, c.b * c.a, c.a};
    for (std::size_t x = 0; x < across_.size(); ++x) {
      const double share = across_[x] + down - across_[x] * down;
      for (std::size_t i = 0; i < 4; ++i)
        if (share != 0)
          row[4 * x + i] = float(share * line[i] + (1 - share * c.a) * double(row[4 * x + i]));
    }
    return true;
  }

 private:
  /// How much of the pixel [at, at + 1] lies under lines.
  double covered(int at) const {
    const double half = 0.5 * effect_.width;
    double sum = 0;
    const int first = std::max(int(std::floor((at - half) / cell_)), 0);
    for (int i = first; i * cell_ - half < at + 1; ++i)
      sum += std::max(std::min(at + 1.0, i * cell_ + half) - std::max(double(at), i * cell_ - half),
                      0.0);
    return std::min(sum, 1.0);
  }

  const GridEffect effect_;
  const double cell_;  // [px]
  int y_ = 0;
  std::vector<double> across_;
};

}  // namespace

std::unique_ptr<RowEffect> row_effect(const GridEffect& grid, int width, int) {
  return std::make_unique<Grid>(grid, width);
}

}  // namespace mien
