#include <mien/render/tile/picture.h>
#include <mien/render/tile/pixel.h>
#include <mien/render/tile/scope.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace mien {
namespace {

/// Draws squares of one tile, from the whole down to single pixels.
class TileWalk {
 public:
  TileWalk(const Tape& tape, int width, int height, const Target& target, RenderStats& stats)
      : tape_(tape),
        half_size_{0.5 * width, 0.5 * height},
        target_(target),
        stats_(stats),
        scopes_(tape),
        pixels_(tape, scopes_, stats, fineness(target.depth, tape.blend)) {}

  void whole(int x, int y, int side) { square(scopes_.everything(), x, y, side); }
  void whole(std::span<const int> layers, int x, int y, int side) {
    square(scopes_.of_layers(layers), x, y, side);
  }

 private:
  void square(const Scope& outer, int x, int y, int side) {
    const PixelRect part = visible(x, y, side);
    if (part.width <= 0 || part.height <= 0) return;
    const glm::dvec2 center = glm::dvec2{x + 0.5 * side, y + 0.5 * side} - half_size_;
    if (side == 1) return pixel(outer, center, x, y);
    const auto mark = scopes_.mark();
    const Scope scope = scopes_.narrowed(outer, center, 0.5 * side * kSqrt2);
    if (scope.outline_count == 0 && !scope.varied) {
      fill(part, scopes_.color(scope));
    } else if (scope.outline_count == 0 && side <= kVaried) {
      for (int j = part.y; j < part.y + part.height; ++j)
        for (int i = part.x; i < part.x + part.width; ++i) {
          const glm::dvec2 c = glm::dvec2{i + 0.5, j + 0.5} - half_size_;
          if (const auto mix = pixels_.gradient(scope, c))
            put(*mix, true, i, j);
          else
            pixel(scope, c, i, j);
        }
    } else {
      const int half = side / 2;
      for (const int dy : {0, half})
        for (const int dx : {0, half}) square(scope, x + dx, y + dy, half);
    }
    scopes_.reset(mark);
  }

  void pixel(const Scope& scope, glm::dvec2 center, int x, int y) {
    const Mix mix = pixels_.pixel(scope, center);
    put(mix, pixels_.was_varied(), x, y);
  }

  void put(const Mix& mix, bool varied, int x, int y) {
    if (tape_.dither && varied)
      store_dithered(mix, tape_.blend, target_.depth, x, y, at(x, y));
    else
      store(mix, tape_.blend, target_.depth, at(x, y));
  }

  void fill(const PixelRect& part, const Mix& mix) {
    stats_.fill_pixels += (long long)part.width * part.height;
    std::array<std::byte, 16> pixel;
    store(mix, tape_.blend, target_.depth, pixel.data());
    const std::size_t size = 4 * bytes_per_channel(target_.depth);
    std::byte* const first = at(part.x, part.y);
    for (int i = 0; i < part.width; ++i)
      std::memcpy(first + size * std::size_t(i), pixel.data(), size);
    for (int j = 1; j < part.height; ++j)
      std::memcpy(first + target_.stride * std::size_t(j), first, size * std::size_t(part.width));
  }

  PixelRect visible(int x, int y, int side) const {
    const PixelRect& r = target_.rect;
    const int x0 = std::max(x, r.x), y0 = std::max(y, r.y);
    return {x0, y0, std::min(x + side, r.x + r.width) - x0,
            std::min(y + side, r.y + r.height) - y0};
  }

  std::byte* at(int x, int y) const {
    return target_.data + target_.stride * std::size_t(y - target_.rect.y) +
           4 * bytes_per_channel(target_.depth) * std::size_t(x - target_.rect.x);
  }

  static constexpr int kVaried = 8;  ///< squares of no outline are not divided below this side
  static constexpr double kSqrt2 = 1.4142135623730952;  // rounded up
  const Tape& tape_;
  const glm::dvec2 half_size_;
  const Target& target_;
  RenderStats& stats_;
  ScopeStack scopes_;
  PixelResolver pixels_;
};

}  // namespace

void draw_square(const Tape& tape, int width, int height, int x, int y, int side,
                 const Target& target, RenderStats& stats) {
  TileWalk(tape, width, height, target, stats).whole(x, y, side);
}

void draw_square(const Tape& tape, std::span<const int> layers, int width, int height, int x, int y,
                 int side, const Target& target, RenderStats& stats) {
  TileWalk(tape, width, height, target, stats).whole(layers, x, y, side);
}

}  // namespace mien
