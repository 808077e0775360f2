#include "tools/mien/film/film_palette.h"
#include "lib/picture/oklch.h"
#include "lib/picture/srgb.h"
#include "tools/mien/film/median_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::command {
namespace {

constexpr std::size_t kPackedColors = std::size_t(1) << 24;
constexpr int kShares = 64;  // of a mix: as many as the matrix has places

std::uint32_t packed_color(const std::uint8_t* pixel) {
  return std::uint32_t(pixel[0]) << 16 | std::uint32_t(pixel[1]) << 8 | pixel[2];
}

FilmPalette::Rgb rgb_of(std::uint32_t packed) {
  return {std::uint8_t(packed >> 16), std::uint8_t(packed >> 8), std::uint8_t(packed)};
}

glm::vec3 lab_of(std::uint32_t packed) {
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> table{};
    for (int level = 0; level < 256; ++level)
      table[std::size_t(level)] = linear_from_srgb(level / 255.0);
    return table;
  }();
  const FilmPalette::Rgb rgb = rgb_of(packed);
  return glm::vec3(Oklch::from_linear({linear[rgb.r], linear[rgb.g], linear[rgb.b]}).lab());
}

/// Bayer's 8 × 8: every number below 64 once, and any number of the lowest spread evenly.
constexpr std::array<std::uint8_t, 64> kBayer = [] {
  std::array<std::uint8_t, 64> matrix{};
  for (unsigned y = 0; y < 8; ++y)
    for (unsigned x = 0; x < 8; ++x) {
      unsigned value = 0;
      for (unsigned bit = 0; bit < 3; ++bit)
        value |= ((x ^ y) >> bit & 1) << (5 - 2 * bit) | (y >> bit & 1) << (4 - 2 * bit);
      matrix[8 * y + x] = std::uint8_t(value);
    }
  return matrix;
}();

/// A colour as two places of the palette: the first one, and how many of the matrix's places have the second.
struct Mix {
  std::uint32_t first, second, share;
  std::uint32_t packed() const { return 1u << 31 | share << 16 | second << 8 | first; }
};

}  // namespace

void FilmPalette::count(const Image& frame) {
  of_color_.resize(kPackedColors);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = frame.row(y);
    for (int x = 0; x < frame.width; ++x, row += 4)
      if (is_there(row)) ++of_color_[packed_color(row)];
  }
}

void FilmPalette::choose() {
  of_color_.resize(kPackedColors);
  std::vector<CountedColor> all;
  for (std::uint32_t color = 0; color < kPackedColors; ++color)
    if (of_color_[color]) all.push_back({lab_of(color), float(of_color_[color]), color});
  std::fill(of_color_.begin(), of_color_.end(), 0u);
  std::vector<CountedColor> chosen = chosen_colors(all, kMost);
  std::sort(chosen.begin(), chosen.end(),
            [](const CountedColor& a, const CountedColor& b) { return a.packed < b.packed; });
  if (chosen.empty()) chosen.push_back({glm::vec3(0), 1, 0});  // nothing is there
  for (const CountedColor& color : chosen) {
    colors_.push_back(rgb_of(color.packed));
    l_.push_back(color.lab.x), a_.push_back(color.lab.y), b_.push_back(color.lab.z);
  }
}

// The mix of places p and q by the share t that comes nearest to the colour c is judged by |c − p − t (q − p)|² plus what its
// pattern shows: kPattern t (1 − t) |q − p|². So a colour nearer to a place than kPattern of the way to the next one is that place.
std::uint32_t FilmPalette::mix_of(std::uint32_t color) const {
  constexpr float kPattern = 0.25f;
  const glm::vec3 lab = lab_of(color);
  const auto place = [&](std::size_t i) { return glm::vec3(l_[i], a_[i], b_[i]); };
  std::size_t nearest = 0;
  float least = INFINITY;
  for (std::size_t i = 0; i < l_.size(); ++i) {
    const glm::vec3 off = lab - place(i);
    if (const float far = glm::dot(off, off); far < least) least = far, nearest = i;
  }
  Mix best{std::uint32_t(nearest), std::uint32_t(nearest), 0};
  const glm::vec3 off = lab - place(nearest);
  for (std::size_t i = 0; i < l_.size() && least > 0; ++i) {
    const glm::vec3 way = place(i) - place(nearest);
    const float length = glm::dot(way, way), along = glm::dot(off, way);
    if (along <= 0) continue;
    const float share = std::min(along / length, 0.5f);
    const glm::vec3 left = off - share * way;
    const float error = glm::dot(left, left) + kPattern * share * (1 - share) * length;
    if (error >= least) continue;
    least = error;
    best.second = std::uint32_t(i), best.share = std::uint32_t(std::lround(share * kShares));
  }
  return best.packed();
}

std::uint8_t FilmPalette::place_of(const std::uint8_t* pixel, int x, int y) {
  std::uint32_t& mix = of_color_[packed_color(pixel)];
  if (mix == 0) mix = mix_of(packed_color(pixel));
  const std::uint32_t share = mix >> 16 & 0xff;
  return std::uint8_t(kBayer[std::size_t(8 * (y & 7) + (x & 7))] < share ? mix >> 8 : mix);
}

}  // namespace mien::command
