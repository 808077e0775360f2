#include <mien/debug_picture.h>
#include "lib/base/memory_ran_out.h"
#include "render/blend/transfer.h"
#include "render/rows/drawing.h"
#include "render/watched.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

using Rgb = std::array<int, 3>;

void put(Image& image, int x, int y, const Rgb& rgb) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::byte* pixel = image.bytes.data() + image.stride() * std::size_t(y) + 4 * std::size_t(x);
  for (int i = 0; i < 3; ++i) pixel[i] = std::byte(std::clamp(rgb[std::size_t(i)], 0, 255));
  pixel[3] = std::byte{255};
}

/// Colours that tell neighbours apart: hues a golden turn from each other.
Rgb color_of(int index) {
  constexpr double kGolden = 0.61803398874989485;
  const double hue = 6.0 * std::fmod(kGolden * (index + 1), 1.0);
  const auto channel = [&](double at) {
    const double away = std::abs(std::remainder(hue - at, 6.0));
    return 70 + int(150.0 * std::clamp(2.0 - away, 0.0, 1.0));
  };
  return {channel(0.0), channel(2.0), channel(4.0)};
}

/// Every region has a look of its own.
class EachItsOwn final : public LookRule {
 public:
  int state_words() const override { return 0; }
  int first_look(std::uint64_t*) override { return 0; }
  int look(const std::uint64_t*, int, const std::uint64_t*, int, std::uint64_t*) override {
    return ++last_;
  }

 private:
  int last_ = 0;
};

/// The look at the middle of each pixel of each row: a fragment changes it from its column on. Columns are those of
/// the image. `looks`, if given, are the rule, and those that vary get dots. The whole picture is one arrangement:
/// parts number their looks each for itself.
void draw_looks(const Drawing& drawing, LookRule& rule, int height, const PixelRect& rect,
                Image& image, const Looks* looks) {
  Regions regions;
  regions.begin(int(drawing.outlines().rules.size()), rule);
  Sweep sweep;
  sweep.run(drawing.outlines(), 0.0, height, regions);
  const int first_look = regions.look(0);
  struct Change {
    double x;
    int left, right;
  };
  std::vector<Change> changes;
  for (int y = 0; y < rect.height; ++y) {
    const double middle = rect.y + y + 0.5;
    worked(2 * std::int64_t(sweep.fragments().size()) + 5 * rect.width);
    changes.clear();
    for (const Fragment& f : sweep.fragments())
      if (f.top <= middle && middle < f.bottom)
        changes.push_back({x_at(sweep.piece(f.piece), middle), f.left, f.right});
    std::sort(changes.begin(), changes.end(),
              [](const Change& a, const Change& b) { return a.x < b.x; });
    // Those at one place follow each other as their looks do.
    constexpr double kOnePlace = 1e-3;  // [px]
    int now = first_look;
    for (std::size_t i = 0; i < changes.size(); now = changes[i++].right)
      for (std::size_t k = i; k < changes.size() && changes[k].x < changes[i].x + kOnePlace; ++k)
        if (changes[k].left == now) {
          std::swap(changes[i], changes[k]);
          break;
        }
    std::size_t next = 0;
    int look = first_look;
    for (int x = 0; x < rect.width; ++x) {
      for (; next < changes.size() && changes[next].x < rect.x + x + 0.5; ++next)
        look = changes[next].right;
      const bool dot =
          looks && !looks->constant(look) && (rect.x + x) % 4 == 0 && (rect.y + y) % 4 == 0;
      put(image, x, y, dot ? Rgb{255, 255, 255} : color_of(look));
    }
  }
}

void draw_piece(const OutlinePiece& piece, double top, double bottom, int width,
                const PixelRect& rect, const Rgb& rgb, Image& image) {
  const double from = std::max(top, double(rect.y)),
               to = std::min(bottom, double(rect.y + rect.height));
  worked(10);
  if (!(from < to)) return;
  worked(10 * std::int64_t(to - from));
  cells_of(piece, from, to, width, [&](const CellStretch& c) {
    if (c.column >= 0) put(image, c.column - rect.x, c.row - rect.y, rgb);
  });
}

void draw_outlines(const Drawing& drawing, int width, const PixelRect& rect, Image& image) {
  const auto& pieces = drawing.outlines().pieces;
  for (const OutlineChain& c : drawing.outlines().chains)
    for (int i = c.first; i <= c.last; ++i) {
      const OutlinePiece& p = pieces[std::size_t(i)];
      draw_piece(p, p.y0, p.y1, width, rect, color_of(c.outline), image);
    }
  const auto vertex = [&](double x, double y) {
    put(image, int(std::floor(x)) - rect.x, int(std::floor(y)) - rect.y, {255, 255, 255});
  };
  for (const OutlinePiece& p : pieces) vertex(p.x0, p.y0), vertex(p.x1, p.y1);
}

void draw_fragments(const Drawing& drawing, int width, const PixelRect& rect, Image& image) {
  for (const OutlinePiece& p : drawing.outlines().pieces)
    draw_piece(p, p.y0, p.y1, width, rect, {35, 45, 70}, image);
  for (const PicturePart& part : drawing.parts())
    for (const Fragment& f : part.sweep.fragments()) {
      const Mix jump = part.looks.mix(f.right) - part.looks.mix(f.left);
      const bool varies = !part.looks.constant(f.left) || !part.looks.constant(f.right);
      const double size = std::max({std::abs(jump.r), std::abs(jump.g), std::abs(jump.b)});
      const int light = 90 + int(165.0 * std::clamp(size, 0.0, 1.0));
      draw_piece(part.sweep.piece(f.piece), f.top, f.bottom, width, rect,
                 varies ? Rgb{190, 120, 240} : Rgb{light, light, light / 2}, image);
    }
}

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

/// Of the topmost layer there.
Rgb normal_at(const PaintTable& paints, const std::vector<AreaDistance>& layers, glm::dvec2 p) {
  glm::dvec2 slope{0.0};
  for (std::size_t i = layers.size(); i-- > 0;) {
    if (!(layers[i].at(p) <= 0.0)) continue;
    const int varied = paints.layers[i].varied;
    if (varied < 0 || paints.varied[std::size_t(varied)].lit < 0) break;
    const VariedPaint& paint = paints.varied[std::size_t(varied)];
    const LitSurface& surface = paints.lit[std::size_t(paint.lit)].surface();
    const Outward outward = surface.outward(p);
    slope = surface.slope(surface.zone_inside(outward.d), p, outward);
    break;
  }
  const double length = std::sqrt(1.0 + slope.x * slope.x + slope.y * slope.y);
  const auto channel = [&](double v) { return level(0.5 + 0.5 * v / length, 255); };
  return {channel(-slope.x), channel(-slope.y), channel(1.0)};
}

void draw_places(const Scene& scene, const View& view, const Drawing& drawing, DebugPicture which,
                 const Threads& threads, Image& image) {
  const PixelRect rect = drawn_rect(view);
  const auto map = grid_from_face(scene.canvas(), view);
  std::vector<AreaDistance> layers;
  for (const Layer& layer : scene.layers())
    layers.emplace_back(scene, layer.area, Map<PixelSpace, FaceSpace>{map.linear, map.shift});
  parallel_for(rect.height, threads, [&](int y) {
    for (int x = 0; x < rect.width; ++x) {
      worked(400 * std::int64_t(layers.size()));
      const glm::dvec2 p{rect.x + x + 0.5, rect.y + y + 0.5};
      put(image, x, y,
          which == DebugPicture::distance ? isoline_color(nearest_distance(layers, p))
                                          : normal_at(drawing.paints(), layers, p));
    }
  });
}

Image picture_of(const Scene& scene, const View& view, DebugPicture which, const Threads& threads) {
  const PixelRect rect = drawn_rect(view);
  Image image{.width = rect.width, .height = rect.height};
  image.bytes.resize(image.stride() * std::size_t(rect.height));
  for (int y = 0; y < rect.height; ++y)
    for (int x = 0; x < rect.width; ++x) put(image, x, y, {12, 16, 28});
  Drawing drawing;
  drawing.make_whole(scene, view, Depth::u8);
  switch (which) {
    case DebugPicture::outlines:
      draw_outlines(drawing, view.width, rect, image);
      break;
    case DebugPicture::fragments:
      draw_fragments(drawing, view.width, rect, image);
      break;
    case DebugPicture::looks: {
      Looks looks;
      looks.begin(drawing.paints());
      draw_looks(drawing, looks, view.height, rect, image, &looks);
      break;
    }
    case DebugPicture::regions: {
      EachItsOwn rule;
      draw_looks(drawing, rule, view.height, rect, image, nullptr);
      break;
    }
    case DebugPicture::distance:
    case DebugPicture::normals:
      draw_places(scene, view, drawing, which, threads, image);
      break;
  }
  return image;
}

}  // namespace

Expected<Image> debug_picture(const Scene& scene, const View& view, DebugPicture which,
                              const RenderOptions& how) try {
  return watched(
      how.progress, how.limits, view.width * std::int64_t(view.height),
      [&] { return picture_of(scene, view, which, how.threads); }, [] { return 0.0; });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
