#include <mien/render/blend/transfer.h>
#include <mien/render/error_map.h>
#include <mien/render/tile/pixel.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// What an error of e in a channel's mix may make of its level.
double levels_of(double v, double e, Blend blend) {
  if (blend == Blend::srgb) return 255.0 * e;
  const auto encoded = [](double x) { return srgb_from_linear(std::clamp(x, 0.0, 1.0)); };
  const double here = encoded(v);
  return 255.0 * std::max(encoded(v + e) - here, here - encoded(v - e));
}

float worst_of(const Mix& mix, double e, Blend blend) {
  double worst = 255.0 * e;  // of the opacity
  for (int i = 0; i < 3; ++i) {
    const double v = mix.a > 0.0 ? mix[i] / mix.a : 0.0;
    worst = std::max(worst, levels_of(v, mix.a > e ? e / (mix.a - e) : 1.0, blend));
  }
  return float(worst);
}

/// A row of squares of kSide pixels, each a scope of its own.
class MapRow {
 public:
  static constexpr int kSide = 32;
  MapRow(const Tape& tape, const View& view, Depth depth, ErrorMap& map)
      : tape_(tape),
        view_(view),
        rect_(drawn_rect(view)),
        map_(map),
        scopes_(tape),
        pixels_(tape, scopes_, stats_, fineness(depth, tape.blend)) {}

  void draw(int row) {
    const int top = row * kSide, bottom = std::min(top + kSide, map_.height);
    for (int left = 0; left < map_.width; left += kSide) {
      const int right = std::min(left + kSide, map_.width);
      const auto mark = scopes_.mark();
      const glm::dvec2 center = at(left + 0.5 * kSide, top + 0.5 * kSide);
      const Scope scope =
          scopes_.narrowed(scopes_.everything(), center, 0.5 * kSide * 1.4142135623730952);
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
          const Mix mix = pixels_.pixel(scope, at(x + 0.5, y + 0.5));
          map_.levels[std::size_t(y) * std::size_t(map_.width) + std::size_t(x)] =
              worst_of(mix, pixels_.error(), tape_.blend);
        }
      scopes_.reset(mark);
    }
  }

 private:
  glm::dvec2 at(double x, double y) const {
    return {rect_.x + x - 0.5 * view_.width, rect_.y + y - 0.5 * view_.height};
  }

  const Tape& tape_;
  const View& view_;
  const PixelRect rect_;
  ErrorMap& map_;
  RenderStats stats_;
  ScopeStack scopes_;
  PixelResolver pixels_;
};

}  // namespace

ErrorMap error_map(const Scene& scene, const View& view, Depth depth, const Threads& threads) {
  const PixelRect rect = drawn_rect(view);
  ErrorMap map{.width = rect.width, .height = rect.height, .levels = {}};
  map.levels.resize(std::size_t(rect.width) * std::size_t(rect.height));
  const Tape tape = tape_from_scene(scene, view);
  parallel_for((map.height + MapRow::kSide - 1) / MapRow::kSide, threads,
               [&](int row) { MapRow(tape, view, depth, map).draw(row); });
  for (const float level : map.levels) map.worst = std::max(map.worst, level);
  return map;
}

Image ErrorMap::image() const {
  Image image{.width = width, .height = height};
  image.bytes.resize(image.stride() * std::size_t(height));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto grey = std::byte(worst > 0 ? level(double(levels[i] / worst), 255) : 0);
    std::fill_n(image.bytes.begin() + std::ptrdiff_t(4 * i), 3, grey);
    image.bytes[4 * i + 3] = std::byte{255};
  }
  return image;
}

}  // namespace mien
