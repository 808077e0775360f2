// Squares in vectors where colours vary: against the sure way, and lit ones against many samples.

#include <mien/render/blend/ramp.h>
#include <mien/render/render.h>
#include <mien/render/tile/band.h>
#include <mien/render/tile/varied_square.h>
#include <mien/sdf/batch/instruction_sets.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "tests/support/effort.h"
#include "tests/support/random.h"

namespace mien {
namespace {

Relief random_relief(test::Random& random, Area area) {
  Relief relief{.area = area,
                .profile = Profile(random.below(4)),
                .width = random.between(0.05, 0.5),
                .height = random.between(-0.2, 0.4),
                .table = {0, 0.4, 0.9, 0.8, 1},
                .domes = {},
                .specular = random.below(2) ? 0.5 : 0.0};
  if (random.below(3) == 0)
    relief.domes.push_back({random.point(-0.5, 0.5), {0.4, 0.3}, random.direction(), 0.1});
  return relief;
}

/// A few lit areas, some with gradients, some translucent.
Scene lit_scene(std::uint64_t seed) {
  test::Random random(seed);
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.3, 0.4, 0.5, 1});
  for (int i = 0; i < 4; ++i) {
    const auto point = [&] { return random.point(-0.8, 0.8); };
    Area area =
        random.below(2)
            ? build.shape(Ellipse{point(), {random.between(0.1, 0.6), 0.4}, random.direction()})
            : build.shape(TaperedStroke{{point(), point(), point()},
                                        {0.1, random.between(0.1, 0.3), 0.05}});
    if (random.below(3) == 0) area = build.either(area, build.shape(Disc{point(), 0.3}));
    Paint paint{
        .color = {random.unit(), random.unit(), random.unit(), random.below(3) ? 1.0 : 0.6}};
    if (random.below(3) == 0)
      paint.gradient = shared(
          Gradient{RadialGradient{point(), {0.7, 0.5}},
                   {{0, {1, 0.9, 0.5, 1}}, {0.6, {0.7, 0.2, 0.1, 1}}, {1, {0.1, 0.1, 0.4, 0.5}}}});
    paint.relief = shared(random_relief(random, area));
    build.layer("layer", area, paint);
  }
  return std::move(build).finish();
}

using Pixels = std::vector<std::uint32_t>;

Pixels by_bands(const Tape& tape, int side, const PixelRect& rect) {
  Pixels pixels(std::size_t(rect.width) * std::size_t(rect.height));
  const Target target{reinterpret_cast<std::byte*>(pixels.data()), std::size_t(rect.width) * 4,
                      Depth::u8, rect};
  const Plan plan(tape, Depth::u8);
  BandPainter painter;
  RenderStats stats;
  for (int y = rect.y / kBandTile * kBandTile; y < rect.y + rect.height; y += kBandTile)
    painter.draw(plan, side, side, y, target, stats);
  EXPECT_EQ(stats.fill_pixels + stats.one_edge_pixels + stats.divided_pixels + stats.varied_pixels,
            (long long)rect.width * rect.height);
  return pixels;
}

Pixels by_squares(const Tape& tape, int side) {
  Pixels pixels(std::size_t(side) * std::size_t(side));
  const Target target{reinterpret_cast<std::byte*>(pixels.data()),
                      std::size_t(side) * 4,
                      Depth::u8,
                      {0, 0, side, side}};
  RenderStats stats;
  for (int y = 0; y < side; y += 64)
    for (int x = 0; x < side; x += 64) draw_square(tape, side, side, x, y, 64, target, stats);
  return pixels;
}

int apart(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (int shift = 0; shift < 32; shift += 8)
    most = std::max(most, std::abs(int(a >> shift & 255u) - int(b >> shift & 255u)));
  return most;
}

/// What light makes of a pixel is certified by neither. They divide creases and steep outlines differently:
/// of 288 000 pixels 8 were more than a level apart, by up to 12 levels, of which the sure way was off by 14 in one,
/// the vectors by 2 or 3 in six.
TEST(VariedSquare, IsTheSureWayWithinALevelAlmostEverywhere) {  // G3
  for (int seed = 1; seed <= test::times(12); ++seed) {
    const Blend blend = seed % 2 ? Blend::linear : Blend::srgb;
    const Scene scene = lit_scene(std::uint64_t(seed));
    const int side = 96 + seed;
    const Tape tape =
        tape_from_scene(scene, {.width = side, .height = side, .blend = blend, .dither = false});
    const Pixels here = by_bands(tape, side, {0, 0, side, side}), sure = by_squares(tape, side);
    int over = 0, most = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      over += apart(here[i], sure[i]) > 1;
      most = std::max(most, apart(here[i], sure[i]));
    }
    EXPECT_LE(over, 4) << seed;
    EXPECT_LE(most, 16) << seed;
  }
}

/// The light's law at a point, by differences of the scene's own distance.
glm::dvec4 lit_at(const Scene& scene, const Paint& paint, glm::dvec2 p, Blend blend) {
  const Relief& r = *paint.relief;
  glm::dvec2 rise{0.0};
  const auto inside_at = [&](glm::dvec2 q) { return -scene.distance(r.area, q); };
  const auto profile = [&](double inside) {
    const double x = std::clamp(inside / r.width, 0.0, 1.0);
    switch (r.profile) {
      case Profile::flat:
        return 0.0;
      case Profile::bevel:
        return x;
      case Profile::round:
        return std::sqrt(1 - (1 - x) * (1 - x));
      default: {
        const auto i = std::min(std::size_t(x * 4), std::size_t(3));
        return r.table[i] + (x * 4 - double(i)) * (r.table[i + 1] - r.table[i]);
      }
    }
  };
  constexpr double kStep = 1e-6;
  const double in = inside_at(p);
  const double steep = r.height * (profile(in + kStep) - profile(in - kStep)) / (2 * kStep);
  for (int i : {0, 1}) {
    glm::dvec2 step{0.0};
    step[i] = kStep;
    rise[i] = steep * (inside_at(p + step) - inside_at(p - step)) / (2 * kStep);
  }
  for (const Dome& dome : r.domes) {
    const auto height = [&](glm::dvec2 q) {
      const glm::dvec2 u = q - dome.center;
      const double a = glm::dot(u, dome.axis) / dome.radii.x;
      const double b = (dome.axis.x * u.y - dome.axis.y * u.x) / dome.radii.y;
      const double left = std::max(0.0, 1 - a * a - b * b);
      return dome.height * left * left;
    };
    for (int i : {0, 1}) {
      glm::dvec2 step{0.0};
      step[i] = kStep;
      rise[i] += (height(p + step) - height(p - step)) / (2 * kStep);
    }
  }
  Mix color = mix_from_color(paint.color, blend);
  if (paint.gradient) {
    const auto& radial = std::get<RadialGradient>(paint.gradient->along);
    color = Ramp(*paint.gradient, 1, blend).color(glm::length((p - radial.center) / radial.radii));
  }
  return Lamp(scene.light(), r.specular, r.shininess).lit(color, rise, blend);
}

/// 72 × 72 places in a pixel: right to a third of a level or so where edges cross it.
glm::dvec4 truth(const Scene& scene, int side, int x, int y, Blend blend) {
  constexpr int kPlaces = 72;
  glm::dvec4 sum{0.0};
  const auto map = pixel_from_face(scene.canvas(), {.width = side, .height = side});
  const auto back = inverse(map);
  for (int j = 0; j < kPlaces; ++j)
    for (int i = 0; i < kPlaces; ++i) {
      const glm::dvec2 p = back(
          glm::dvec2{x + (i + 0.5) / kPlaces - 0.5 * side, y + (j + 0.5) / kPlaces - 0.5 * side});
      Mix mix{0.0};
      for (std::size_t l = scene.layers().size(); l-- > 0 && mix.a < 1;)
        if (scene.distance(scene.layers()[l].area, p) <= 0)
          mix = over(mix, lit_at(scene, scene.layers()[l].paint, p, blend));
      sum += over(mix, mix_from_color(scene.background(), blend));
    }
  return sum / double(kPlaces * kPlaces);
}

TEST(VariedSquare, IsWhatManySamplesSee) {  // G3
  int compared = 0;
  for (int seed = 1; seed <= test::times(9); ++seed) {
    test::Random random(std::uint64_t(seed) * 7);
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.3, 0.4, 0.5, 1});
    for (int i = 0; i < 2; ++i) {
      const Area area =
          i ? build.shape(Ellipse{random.point(-0.4, 0.4), {0.5, 0.35}, random.direction()})
            : build.shape(TaperedStroke{{{-0.8, -0.6}, random.point(-0.5, 0.5), {0.7, 0.6}},
                                        {0.2, 0.35, 0.1}});
      build.layer(
          "layer", area,
          {.color = {0.8, 0.5, 0.3, i ? 0.7 : 1.0}, .relief = shared(random_relief(random, area))});
    }
    const Scene scene = std::move(build).finish();
    const Blend blend = seed % 2 ? Blend::linear : Blend::srgb;
    const int side = 60 + 20 * (seed % 5);
    const View view{.width = side, .height = side, .blend = blend, .dither = false};
    const Image image = render(scene, view);
    for (int k = 0; k < 12; ++k, ++compared) {
      const int x = random.below(side), y = random.below(side);
      std::uint8_t levels[4];
      store(truth(scene, side, x, y, blend), blend, Depth::u8, levels);
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(int(image.row(y)[4 * x + c]), int(levels[c]), 1)
            << "seed " << seed << " side " << side << " pixel " << x << ' ' << y << " channel "
            << c;
    }
  }
  EXPECT_GE(compared, test::times(9) * 12);
}

TEST(VariedSquare, InAPieceOfThePictureHasTheSameBytes) {
  const Scene scene = lit_scene(5);
  const Tape tape = tape_from_scene(scene, {.width = 150, .height = 150});
  const Pixels whole = by_bands(tape, 150, {0, 0, 150, 150});
  for (const PixelRect& rect :
       {PixelRect{17, 9, 100, 77}, PixelRect{64, 63, 5, 9}, PixelRect{80, 70, 1, 1}}) {
    const Pixels part = by_bands(tape, 150, rect);
    for (int y = 0; y < rect.height; ++y)
      EXPECT_EQ(0, std::memcmp(&part[std::size_t(y * rect.width)],
                               &whole[std::size_t((y + rect.y) * 150 + rect.x)],
                               std::size_t(rect.width) * 4));
  }
}

TEST(VariedSquare, HasTheSameBytesOnInstructionSetsThatFuse) {
  const Scene scene = lit_scene(6);
  const Tape tape = tape_from_scene(scene, {.width = 130, .height = 130});
  Pixels first;
  for (const auto& set : batch::instruction_sets()) {
    batch::use_instruction_set(set.id);
    const Pixels pixels = by_bands(tape, 130, {0, 0, 130, 130});
    if (first.empty()) first = pixels;
    int most = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      most = std::max(most, apart(pixels[i], first[i]));
    EXPECT_LE(most, set.fused ? 0 : 1) << set.name;
  }
  batch::use_instruction_set(0);
}

}  // namespace
}  // namespace mien
