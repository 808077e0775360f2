// What follows the outline of a path filled by the nonzero rule follows the one that is seen: contours, reliefs,
// gradients, feathers, shadows, glows and offsets, against a truth that finds outlines by winding numbers alone.

#include <mien/scene_effects.h>
#include <mien/svg.h>

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/exact/exact_windows.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/pictures/svg_raster.h"
#include "tests/support/process/effort.h"
#include "tests/support/scenes/overlapping_paths.h"

namespace mien {
namespace {

using test::ExactTruth;
using test::NamedPath;
using test::Tallies;

constexpr Color kFilled{0.7, 0.4, 0.2, 1}, kInked{0.05, 0.1, 0.3, 1}, kShadow{0, 0, 0, 0.6},
    kGreen{0.2, 0.7, 0.3, 1};

struct Feature {
  std::string name;
  std::function<void(SceneBuilder&, Area)> add;
  bool in_svg = true;  ///< to the level
};

Paint ramp_along(Area area) {
  return {.color = {0, 0, 0, 1},
          .gradient = shared(Gradient{DistanceGradient{area, -0.3, 0.1},
                                      {{0, kInked}, {0.4, kGreen}, {0.8, kFilled}, {1, kShadow}}})};
}

const std::vector<Feature>& outline_features() {
  static const std::vector<Feature> all{
      {"contour",
       [](SceneBuilder& build, Area area) {
         build.layer("skin", area, {kFilled});
         build.layer("line", contour(build, area, 0.04), {kInked});
       }},
      {"pen",
       [](SceneBuilder& build, Area area) {
         build.layer("skin", area, {kFilled});
         build.layer("line", pen_contour(build, area, 0.01, 0.07, {0.6, -0.8}), {kInked});
       }},
      {"relief",
       [](SceneBuilder& build, Area area) {
         build.layer("skin", area,
                     {.color = kFilled,
                      .relief = shared(
                          {.area = area, .profile = Profile::bevel, .width = 0.2, .height = 0.1})});
       },
       false},
      {"gradient",
       [](SceneBuilder& build, Area area) { build.layer("skin", area, ramp_along(area)); }, false},
      {"feather",
       [](SceneBuilder& build, Area area) {
         build.layer("skin", area, falling(area, kFilled, -0.15, 0));
       },
       false},
      {"shadow",
       [](SceneBuilder& build, Area area) {
         soft_shadow(build, "shade", area, {.color = kShadow, .blur = 0.15, .shift = {0.1, -0.08}});
       },
       false},
      {"glow",
       [](SceneBuilder& build, Area area) {
         glow(build, "light", area, {kGreen, 0.2});
       },
       false},
      {"narrower", [](SceneBuilder& build,
                      Area area) { build.layer("skin", build.offset(area, -0.06), {kFilled}); }},
      {"wider, in a group, cut",
       [](SceneBuilder& build, Area area) {
         build.open_group("cut", 0.7, build.offset(area, -0.03));
         build.layer("skin", build.offset(area, 0.05), {kFilled});
         build.layer("line", build.shell(build.offset(area, -0.08), 0.03), {kInked});
         build.close_group();
       }},
  };
  return all;
}

Scene scene_of(const Path& path, const Feature& feature) {
  SceneBuilder build({.box = {{-1.1, -1.1}, {1.1, 1.1}}}, {0.9, 0.9, 0.85, 1});
  build.light({.direction = {-0.45, 0.65, 0.85}, .ambient = 0.35});
  feature.add(build, build.shape(path));
  return std::move(build).finish();
}

Tallies judged_outlines(const Scene& drawn, const Scene& meant, int side, int every) {
  const View view{.width = side, .height = side, .dither = false};
  const ExactTruth truth(meant, view, ExactTruth::kLit);
  const auto one_in = [&](int x, int y) {
    const auto hash = (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca6bu);
    return (hash >> 8) % std::uint32_t(every) == 0;
  };
  Tallies tallies;
  test::judge_window(drawn, view, {0, 0, side, side}, truth, test::kAllStorages, one_in, tallies);
  return tallies;
}

TEST(ExactOutlines, AreThoseThatAreSeen) {
  for (const NamedPath& named : test::overlapping_paths())
    for (const Feature& feature : outline_features()) {
      const Scene scene = scene_of(named.path, feature);
      const Tallies tallies = judged_outlines(scene, scene, 23, 29 * test::kThinning);
      for (std::size_t i = 0; i < tallies.size(); ++i)
        EXPECT_EQ(tallies[i].over, 0) << named.name << ", " << feature.name << ", "
                                      << test::kStorages[i].name << ": " << tallies[i].where;
    }
}

/// By the even-odd rule the same sides are outline all along.
TEST(ExactOutlines, ByTheOtherRuleWouldBeSeenToDiffer) {
  for (const Feature& feature : outline_features()) {
    const Path path{{test::pentagram(0.8)}};
    Path other = path;
    other.rule = FillRule::even_odd;
    EXPECT_GT(judged_outlines(scene_of(other, feature), scene_of(path, feature), 23, 7)[0].over, 0)
        << feature.name;
  }
}

/// A pentagram is the star of ten sides.
TEST(ExactOutlines, OfAPentagramAreAStars) {
  std::vector<glm::dvec2> points;
  const double inner = 0.8 * std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
  for (int k = 0; k < 10; ++k) {
    const double turn = 0.2 * std::numbers::pi * k;
    points.push_back((k % 2 ? inner : 0.8) * glm::dvec2{std::sin(turn), std::cos(turn)});
  }
  const Path star{{test::polygon(points)}}, pentagram{{test::pentagram(0.8)}};
  for (const Feature& feature : outline_features()) {
    const View view{.width = 120, .height = 120, .dither = false};
    const Image a = test::rendered(scene_of(star, feature), view),
                b = test::rendered(scene_of(pentagram, feature), view);
    int worst = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
      worst = std::max(worst, std::abs(int(a.bytes[i]) - int(b.bytes[i])));
    EXPECT_LE(worst, 1) << feature.name;
  }
}

TEST(ExactOutlines, AreTheSameInSvg) {
  constexpr double kFewLevels = 3;
  for (const NamedPath& named : test::overlapping_paths())
    for (const Feature& feature : outline_features()) {
      if (!feature.in_svg) continue;
      const Scene scene = scene_of(named.path, feature);
      const auto svg = svg_text(scene, {.width = 64, .height = 64});
      ASSERT_TRUE(svg) << sentence(svg.error());
      const Image image =
          test::rendered(scene, {.width = 64, .height = 64, .blend = Blend::srgb, .dither = false});
      const test::SvgRaster raster = test::svg_raster(test::read_svg_tree(svg->text));
      double worst = 0;
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
          for (std::size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(255 * raster.at(x, y)[c] -
                                             double(image.row(y)[4 * std::size_t(x) + c])));
      EXPECT_LE(worst, kFewLevels) << named.name << ", " << feature.name;
    }
}

}  // namespace
}  // namespace mien
