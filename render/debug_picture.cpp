#include <mien/render/blend/transfer.h>
#include <mien/render/debug_picture.h>
#include <mien/render/tile/pixel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

namespace mien {
namespace {

using Rgb = std::array<int, 3>;

void put(Image& image, int x, int y, const Rgb& rgb) {
  std::byte* pixel = image.bytes.data() + image.stride() * std::size_t(y) + 4 * std::size_t(x);
  for (int i = 0; i < 3; ++i) pixel[i] = std::byte(std::clamp(rgb[std::size_t(i)], 0, 255));
  pixel[3] = std::byte{255};
}

/// Everything of one thread, and where pixels are.
struct Sight {
  Sight(const Tape& tape_, const View& view)
      : tape(tape_),
        rect(drawn_rect(view)),
        half{0.5 * view.width, 0.5 * view.height},
        scopes(tape_),
        pixels(tape_, scopes, stats),
        sampler(tape_) {}

  glm::dvec2 at(double x, double y) const { return glm::dvec2{rect.x + x, rect.y + y} - half; }

  const Tape& tape;
  const PixelRect rect;
  const glm::dvec2 half;
  RenderStats stats;
  ScopeStack scopes;
  PixelResolver pixels;
  PaintSampler sampler;
};

// tiles

Rgb cost_of(const RenderStats& took) {
  if (took.varied_pixels > 0) return {150, 90, 200};
  if (took.one_edge_pixels > 0) return {60, 170, 90};
  if (took.fill_pixels > 0) return {150, 190, 230};
  if (took.cells == 0) return {230, 210, 70};
  return {std::min(255, 200 + int(took.cells)), std::max(20, 150 - int(took.cells)), 40};
}

void tiles_square(Sight& sight, Image& image, const Scope& outer, int x, int y, int side) {
  if (x >= image.width || y >= image.height) return;
  const glm::dvec2 center = sight.at(x + 0.5 * side, y + 0.5 * side);
  const auto mark = sight.scopes.mark();
  const Scope scope = sight.scopes.narrowed(outer, center, 0.5 * side * 1.4142135623730952);
  if (scope.outline_count == 0 && !scope.varied) {
    const int light = 7 - int(std::lround(std::log2(double(side))));  // 0: 128 px … 7: one pixel
    for (int j = y; j < std::min(y + side, image.height); ++j)
      for (int i = x; i < std::min(x + side, image.width); ++i) {
        const bool border = i == x || j == y;
        const int v = 40 + 18 * light - (border && side > 1 ? 25 : 0);
        put(image, i, j, {v / 2, v, std::min(255, v + 80)});
      }
  } else if (side == 1) {
    sight.stats = {};
    sight.pixels.pixel(outer, center);
    put(image, x, y, cost_of(sight.stats));
  } else {
    const int h = side / 2;
    for (const int dy : {0, h})
      for (const int dx : {0, h}) tiles_square(sight, image, scope, x + dx, y + dy, h);
  }
  sight.scopes.reset(mark);
}

// distance

Rgb isoline_color(double d) {
  if (std::abs(d) < 0.75) return {255, 255, 255};
  const double fade = std::exp(-std::abs(d) / 120.0);
  const double step = std::abs(std::remainder(d, 10.0));
  const double line = step < 0.6 ? 0.55 : 1.0;
  const Rgb base = d < 0.0 ? Rgb{60, 120, 210} : Rgb{235, 150, 60};
  Rgb out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = int(line * (base[i] * (0.35 + 0.65 * fade) + 30.0 * (1.0 - fade)));
  return out;
}

double nearest_distance(const std::vector<AreaDistance>& layers, glm::dvec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (const AreaDistance& layer : layers) {
    const double d = layer.at(p);
    if (std::abs(d) < std::abs(best)) best = d;
  }
  return best;
}

// coverage

/// A tape with one layer of another, white on black.
Tape alone(const Tape& tape, int layer) {
  Tape one = tape;
  TapeLayer only = tape.layers[std::size_t(layer)];
  only.mix = Mix{1.0};
  only.paint = only.group = -1;
  one.layers = {only};
  one.background = Mix{0.0, 0.0, 0.0, 1.0};
  return one;
}

/// Whether an outline of the layer comes into the pixel and the layer can be seen there: found by
/// its own coverage.
double coverage_of(Sight& layer, glm::dvec2 center) {
  return layer.pixels.pixel(layer.scopes.everything(), center).r;
}

// normals

Rgb normal_at(Sight& sight, const Scope& scope, glm::dvec2 center) {
  const auto mark = sight.scopes.mark();
  const Scope here = sight.scopes.narrowed(scope, center, 1e-6);
  glm::dvec2 slope{0.0};
  for (const ScopeStack::Layer& layer : sight.scopes.layers(here)) {
    if (layer.paint >= 0 && sight.tape.paints[std::size_t(layer.paint)].relief) {
      const LocalPaint local = sight.sampler.local(layer.paint, center, 1.0);
      slope = local.slope({0.0, 0.0});
    }
    break;
  }
  sight.scopes.reset(mark);
  const double length = std::sqrt(1.0 + slope.x * slope.x + slope.y * slope.y);
  const auto channel = [&](double v) { return level(0.5 + 0.5 * v / length, 255); };
  return {channel(-slope.x), channel(-slope.y), channel(1.0)};
}

}  // namespace

Image debug_picture(const Scene& scene, const View& view, DebugPicture which,
                    const Threads& threads) {
  const PixelRect rect = drawn_rect(view);
  Image image{.width = rect.width, .height = rect.height};
  image.bytes.resize(image.stride() * std::size_t(rect.height));
  const Tape tape = tape_from_scene(scene, view);
  const auto map = pixel_from_face(scene.canvas(), view);
  std::vector<AreaDistance> distances;
  if (which == DebugPicture::distance)
    for (const Layer& layer : scene.layers()) distances.emplace_back(scene, layer.area, map);
  std::vector<Tape> alones;
  if (which == DebugPicture::coverage)
    for (int i = 0; i < int(tape.layers.size()); ++i) alones.push_back(alone(tape, i));
  constexpr int kSide = 128;
  parallel_for((rect.height + kSide - 1) / kSide, threads, [&](int row) {
    Sight sight(tape, view);
    const Scope all = sight.scopes.everything();
    const int top = row * kSide, bottom = std::min(top + kSide, rect.height);
    if (which == DebugPicture::tiles) {
      for (int x = 0; x < rect.width; x += kSide) tiles_square(sight, image, all, x, top, kSide);
      return;
    }
    std::vector<std::unique_ptr<Sight>> layers;
    for (const Tape& one : alones) layers.push_back(std::make_unique<Sight>(one, view));
    for (int y = top; y < bottom; ++y)
      for (int x = 0; x < rect.width; ++x) {
        const glm::dvec2 center = sight.at(x + 0.5, y + 0.5);
        if (which == DebugPicture::distance) {
          put(image, x, y, isoline_color(nearest_distance(distances, center)));
        } else if (which == DebugPicture::normals) {
          put(image, x, y, normal_at(sight, all, center));
        } else {
          Rgb rgb{18, 26, 48};
          for (const auto& layer : layers) {  // top to bottom
            const double covered = coverage_of(*layer, center);
            if (covered <= 0.0) continue;
            if (covered < 1.0)
              rgb = {level(covered, 255), level(covered, 255), level(covered, 255)};
            break;
          }
          put(image, x, y, rgb);
        }
      }
  });
  return image;
}

}  // namespace mien
