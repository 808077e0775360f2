// SVG files say what mien draws: read back by a reader that knows nothing of mien, and drawn by samples.

#include <mien/composed_face.h>
#include <mien/poser.h>
#include <mien/scene_effects.h>
#include <mien/scene_from_face.h>
#include <mien/svg.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/support/faces/faces.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/pictures/svg_raster.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random_scene.h"
#include "tests/support/scenes/huge_scene.h"

namespace mien {
namespace {

/// [levels of 255] By which a channel of a pixel may differ, premultiplied: colours are in eight bits in the SVG file
/// and in the picture (1), paths and samples each leave about one, and gradients are mixed by other means.
constexpr double kFewLevels = 3;

/// The scene with another paint for each layer.
template <class Repaint>
Scene repainted(const Scene& scene, const Repaint& repaint) {
  SceneBuilder build(scene.canvas(), scene.background());
  for (const Node& n : scene.nodes()) switch (n.op) {
      case Op::shape:
        build.shape(scene.shapes()[std::size_t(n.a)]);
        break;
      case Op::unite:
        build.unite({n.a}, {n.b});
        break;
      case Op::intersect:
        build.intersect({n.a}, {n.b});
        break;
      case Op::subtract:
        build.subtract({n.a}, {n.b});
        break;
      case Op::complement:
        build.complement({n.a});
        break;
      case Op::offset:
        build.offset({n.a}, n.amount);
        break;
      case Op::shell:
        build.shell({n.a}, n.amount);
        break;
    }
  std::vector<int> open;
  const auto go_to = [&](int group) {
    std::vector<int> chain;
    for (int g = group; g >= 0; g = scene.groups()[std::size_t(g)].parent)
      chain.insert(chain.begin(), g);
    while (!open.empty() && (open.size() > chain.size() || open.back() != chain[open.size() - 1]))
      build.close_group(), open.pop_back();
    while (open.size() < chain.size()) {
      open.push_back(chain[open.size()]);
      const Group& g = scene.groups()[std::size_t(open.back())];
      build.open_group(g.name, g.opacity, {}, g.mix);
    }
  };
  for (const Layer& layer : scene.layers()) {
    go_to(layer.group);
    build.layer(layer.name, layer.area, repaint(layer.paint));
  }
  go_to(-1);
  return std::move(build).finish();
}

Scene without_relief(const Scene& scene) {
  return repainted(scene, [](Paint paint) {
    paint.relief = {};
    return paint;
  });
}

/// The most that a channel differs by between what the file shows and what mien draws.
double worst_level(const Svg& svg, const Scene& scene, int side) {
  const Image image =
      test::rendered(scene, {.width = side, .height = side, .blend = Blend::srgb, .dither = false});
  const test::SvgRaster raster = test::svg_raster(test::read_svg_tree(svg.text));
  EXPECT_EQ(raster.width, side);
  EXPECT_EQ(raster.height, side);
  double worst = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const test::SvgPixel& shown = raster.at(x, y);
      const std::uint8_t* drawn = image.row(y) + 4 * x;
      for (std::size_t c = 0; c < 4; ++c) {
        const double there = c == 3 ? shown[3] : shown[c] * shown[3],
                     here = (c == 3 ? 1.0 : drawn[c] / 255.0) * drawn[3];
        worst = std::max(worst, std::abs(255 * there - here));
      }
    }
  return worst;
}

void expect_alike(const Scene& scene, int side, const std::string& what) {
  const auto svg = svg_text(scene, {.width = double(side), .height = double(side)});
  ASSERT_TRUE(svg) << sentence(svg.error());
  EXPECT_EQ(svg->simplified, std::vector<std::string>{}) << what;
  const double worst = worst_level(*svg, scene, side);
  EXPECT_LE(worst, kFewLevels) << what;
  testing::Test::RecordProperty(what,
                                fmt::format("{:.2f} levels, {} bytes", worst, svg->text.size()));
}

TEST(SvgFaces, ShowWhatMienDraws) {
  for (const char* name : {"faces/toon", "faces/bruno", "toon", "bruno", "seed0", "male"}) {
    const Scene scene = without_relief(scene_from_face(test::face_named(name)));
    expect_alike(scene, 128, name);
  }
}

TEST(SvgFaces, ShowPeopleOfFlatStyle) {
  for (int i = 0; i < test::times(6); ++i) {
    Recipe recipe = recipe_from_seed(seed_from_word(fmt::format("svg/{}", i)));
    recipe.style = "flat";
    const Face face = face_from_recipe(recipe).value();
    expect_alike(without_relief(scene_from_face(pose_face(face, {}))), 128,
                 fmt::format("person {}", i));
  }
}

TEST(SvgFaces, ShowAFeelingAndABlink) {
  const Face face = test::face_named("faces/bruno");
  for (const char* setting : {"emotion.joy=1", "blink=0.5"}) {
    const Scene scene = scene_from_face(test::posed(face, {setting}));
    expect_alike(without_relief(scene), 128, setting);
  }
}

/// Every shape, operator, linear and radial gradient, group, clip and transparency.
TEST(SvgScenes, RandomOnesShowWhatMienDraws) {
  double worst = 0;
  for (int seed = 1; seed <= test::times(60); ++seed) {
    const Scene scene = repainted(test::random_painted_scene(std::uint64_t(seed)), [](Paint paint) {
      if (paint.gradient && std::holds_alternative<DistanceGradient>(paint.gradient->along))
        paint.gradient = {};
      return paint;
    });
    const auto svg = svg_text(scene, {.width = 48, .height = 48});
    ASSERT_TRUE(svg) << sentence(svg.error());
    const double off = worst_level(*svg, scene, 48);
    EXPECT_LE(off, kFewLevels) << "seed " << seed << "\n" << svg->text;
    worst = std::max(worst, off);
  }
  RecordProperty("worst", fmt::format("{:.2f}", worst));
}

/// Vertices that many share, coincident and tangent outlines, widths of zero; and coordinates far outside. Where the
/// file says that an order is not proven, it is not judged.
TEST(SvgScenes, DegenerateOnesShowWhatMienDraws) {
  int judged = 0;
  for (int seed = 1; seed <= test::times(40); ++seed) {
    const auto number = std::uint64_t(seed);
    for (const Scene& scene : {test::degenerate_scene(number, 0),
                               test::degenerate_scene(number, 1e-6), test::huge_scene(number)}) {
      const auto svg = svg_text(scene, {.width = 32, .height = 32});
      ASSERT_TRUE(svg) << sentence(svg.error());
      const double off = worst_level(*svg, scene, 32);
      if (!svg->simplified.empty()) continue;
      EXPECT_LE(off, kFewLevels) << "seed " << seed << "\n" << svg->text;
      ++judged;
    }
  }
  EXPECT_GE(judged, test::times(110));
  RecordProperty("judged", judged);
}

/// Groups in groups that multiply and screen, over a background and over none.
TEST(SvgScenes, MixedGroupsShowWhatMienDraws) {
  for (const double opaque : {1.0, 0.4, 0.0}) {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.3, 0.5, 0.2, opaque});
    const Area disc = build.shape(Disc{{-0.3, 0.1}, 0.6}), other = build.shape(Disc{{0.3, 0}, 0.5}),
               bar = build.shape(Line{{-0.9, -0.4}, {0.8, 0.7}, 0.2});
    const Paint ramp{.gradient = shared(Gradient{LinearGradient{{-0.5, 0}, {0.6, 0.3}},
                                                 {{0, {0.9, 0.1, 0.1, 1}}, {1, {0, 0.2, 0.9, 0}}},
                                                 Extend::reflect})};
    build.layer("disc", disc, {{0.8, 0.6, 0.1, 0.7}});
    build.open_group("outer", 0.8);
    build.layer("other", other, ramp);
    build.open_group("inner", 0.9, disc, MixMode::multiply);
    build.layer("bar", bar, {{0.2, 0.7, 0.9, 0.8}});
    build.layer("other again", other, {{0.9, 0.9, 0.2, 1}});
    build.close_group();
    build.close_group();
    build.open_group("light", 1, {}, MixMode::screen);
    build.layer("bar again", bar, ramp);
    build.close_group();
    const Scene scene = std::move(build).finish();
    expect_alike(scene, 64, fmt::format("background {}", opaque));
  }
}

/// Gradients along a distance are drawn in steps, and that is said.
TEST(SvgScenes, StepsOfADistanceAreNear) {
  for (const double faint : {1.0, 0.5}) {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.6, 0.7, 0.8, 1});
    const Area star = build.unite(build.shape(Disc{{-0.2, 0.1}, 0.3}),
                                  build.shape(Line{{-0.1, 0}, {0.5, -0.4}, 0.12}));
    glow(build, "glow", star, {{1, 0.9, 0.2, faint}, 0.3});
    soft_shadow(build, "shadow", star, {.color = {0, 0, 0, 0.5 * faint}, .blur = 0.2});
    const DistanceGradient inside{star, -0.3, 0};
    build.layer(
        "ramp", star,
        {.color = {0, 0, 0, faint},
         .gradient = shared(Gradient{inside, {{0, {1, 0, 0}}, {0.5, {0, 1, 0}}, {1, {0, 0, 1}}}})});
    const Scene scene = std::move(build).finish();
    const auto svg = svg_text(scene, {.width = 64, .height = 64});
    ASSERT_TRUE(svg);
    ASSERT_EQ(svg->simplified.size(), 3u);
    EXPECT_EQ(svg->simplified[2].substr(0, 55),
              "layer \"ramp\": its gradient along a distance is drawn in");
    // Half a step of a fortieth, and somewhat more where two of these layers lie over each other.
    EXPECT_LE(worst_level(*svg, scene, 64), 1.5 * 255 / 80);
  }
}

}  // namespace
}  // namespace mien
