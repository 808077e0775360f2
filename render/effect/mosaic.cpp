#include "render/effect/bevel.h"
#include "row_effect_private.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

using Sum = std::array<double, 4>;

/// How a slope's light changes a tile: towards white, or darker [share].
constexpr double kAbove = 0.36, kLeft = 0.18, kRight = -0.24, kBelow = -0.44;

double shaded(const Sum& color, std::size_t c, double light) {
  if (c == 3) return color[3];
  return light > 0 ? color[c] + light * (color[3] - color[c]) : color[c] * (1 + light);
}

/// Tiles from their pixels, then pixels from their tiles. Borders of tiles and pixels coincide only by chance: a
/// pixel gives to each tile, and takes from each, by the area they share.
class Mosaic final : public RowEffect {
 public:
  Mosaic(const MosaicEffect& effect, int width, int height)
      : effect_(effect),
        width_(width),
        height_(height),
        side_(double(width) / effect.tiles),
        row_(4 * std::size_t(width)),
        mixed_(4 * std::size_t(width)) {}

  bool next(const NextRow& in, float* row) override {
    while (!ready(written_)) {
      if (!in(row_.data())) return false;
      read(row_.data());
    }
    write(row);
    return true;
  }

 private:
  void read(const float* row) {
    const double top = read_, bottom = ++read_;
    const int last = tile_at(bottom, true);
    while (first_ + int(sums_.size()) <= last)
      sums_.emplace_back(std::size_t(effect_.tiles), Sum{});
    for (int j = tile_at(top, false); j <= last; ++j) {
      const double share = std::min(bottom, end_of(j)) - std::max(top, j * side_);
      if (share > 0) add(row, j, share);
    }
  }

  /// The tile that contains a place; `end`: the tile that a stretch ending there is in.
  int tile_at(double place, bool end) const {
    int tile = int(place / side_);
    while (tile > 0 && tile * side_ > place) --tile;
    while ((tile + 1) * side_ <= place) ++tile;
    if (end && tile > 0 && tile * side_ >= place) --tile;
    return tile;
  }
  double end_of(int tile) const { return std::min((tile + 1) * side_, double(height_)); }

  void add(const float* row, int tile_row, double share) {
    std::vector<Sum>& sums = sums_[std::size_t(tile_row - first_)];
    const double middle = std::min((tile_row + 0.5) * side_, height_ - 0.5);
    if (effect_.center) {
      if (int(middle) != read_ - 1) return;
      for (int i = 0; i < effect_.tiles; ++i) {
        const auto x = std::size_t(std::min(int((i + 0.5) * side_), width_ - 1));
        for (std::size_t c = 0; c < 4; ++c) sums[std::size_t(i)][c] = double(row[4 * x + c]);
      }
      return;
    }
    const double height = end_of(tile_row) - tile_row * side_;
    for (int i = 0; i < effect_.tiles; ++i) {
      const double begin = i * side_, end = i + 1 == effect_.tiles ? width_ : (i + 1) * side_;
      const double scale = share / (height * (end - begin));
      Sum& sum = sums[std::size_t(i)];
      for (int x = int(begin); x < width_ && x < end; ++x) {
        const double part = scale * (std::min(x + 1.0, end) - std::max(double(x), begin));
        for (std::size_t c = 0; c < 4; ++c) sum[c] += part * double(row[4 * std::size_t(x) + c]);
      }
    }
  }

  /// Whether all tiles under a row of pixels are known.
  bool ready(int y) const { return end_of(tile_at(y + 1.0, true)) <= read_; }

  void write(float* row) {
    const double top = written_, bottom = ++written_;
    const int first = tile_at(top, false), last = tile_at(bottom, true);
    std::fill(mixed_.begin(), mixed_.end(), 0.0);
    for (int j = first; j <= last; ++j) {
      const double v0 = std::max(top - j * side_, 0.0), v1 = std::min(bottom - j * side_, side_);
      if (v1 <= v0) continue;
      const std::vector<Sum>& colors = sums_[std::size_t(j - first_)];
      int i = 0;
      for (int x = 0; x < width_; ++x)
        for (;; ++i) {
          const double u0 = std::max(x - i * side_, 0.0), u1 = std::min(x + 1 - i * side_, side_);
          if (u1 > u0) put(&mixed_[4 * std::size_t(x)], colors[std::size_t(i)], u0, u1, v0, v1);
          if (i + 1 == effect_.tiles || (i + 1) * side_ >= x + 1) break;
        }
    }
    std::copy(mixed_.begin(), mixed_.end(), row);
    while (first_ < tile_at(written_, false) && !sums_.empty()) sums_.pop_front(), ++first_;
  }

  void put(double* pixel, const Sum& color, double u0, double u1, double v0, double v1) const {
    const BevelAreas a = bevel_areas(u0, u1, v0, v1, side_, 0.5 * effect_.border * side_);
    for (std::size_t c = 0; c < 4; ++c)
      pixel[c] += a.flat * color[c] + a.above * shaded(color, c, kAbove) +
                  a.left * shaded(color, c, kLeft) + a.right * shaded(color, c, kRight) +
                  a.below * shaded(color, c, kBelow);
  }

  const MosaicEffect effect_;
  const int width_, height_;
  const double side_;                  // of a tile [px]
  int read_ = 0, written_ = 0;         // rows
  int first_ = 0;                      // the tile row that sums_ begins with
  std::deque<std::vector<Sum>> sums_;  // tile rows not yet written out
  std::vector<float> row_;             // read last
  std::vector<double> mixed_;          // the row being written
};

}  // namespace

std::unique_ptr<RowEffect> row_effect(const MosaicEffect& mosaic, int width, int height) {
  return std::make_unique<Mosaic>(mosaic, width, height);
}

}  // namespace mien
