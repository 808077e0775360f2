// What is seen at a place has a name, and pictures agree.

#include <mien/feature_at.h>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "sdf/scene/part.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/sample_poses.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

const Canvas kTenWide{{{0, 0}, {10, 10}}, true};

TEST(FeatureAt, IsTheUppermostThatCovers) {
  SceneBuilder build(kTenWide, {1, 1, 1, 1});
  build.layer("below", build.shape(Disc{{4, 5}, 3}), {{1, 0, 0, 1}});
  build.layer("above", build.shape(Disc{{6, 5}, 3}), {{0, 1, 0, 0.5}});
  const Scene scene = std::move(build).finish();
  EXPECT_EQ(feature_at(scene, {2, 5}), "below");
  EXPECT_EQ(feature_at(scene, {5, 5}), "above");
  EXPECT_EQ(feature_at(scene, {5, 9}), "");
  EXPECT_EQ(layer_seen_at(scene, {5, 9}), -1);
  EXPECT_EQ(layer_seen_at(scene, {8, 5}), 1);
}

TEST(FeatureAt, LooksThroughWhatIsTransparent) {
  SceneBuilder build(kTenWide, {1, 1, 1, 1});
  const Area all = build.shape(Disc{{5, 5}, 4});
  build.layer("ground", all, {{1, 0, 0, 1}});
  build.layer("clear", all, {{0, 1, 0, 0}});
  build.open_group("hidden", 0);
  build.layer("in hidden", all, {{0, 1, 0, 1}});
  build.close_group();
  const Color ink{0, 0, 1, 1}, none{0, 0, 1, 0};
  build.layer("fading", all,
              {.color = {0, 0, 0, 1},
               .gradient = shared({.along = LinearGradient{{4, 5}, {6, 5}},
                                   .stops = {{0, ink}, {0.5, none}, {1, none}}})});
  const Scene scene = std::move(build).finish();
  EXPECT_EQ(feature_at(scene, {2, 5}), "fading");
  EXPECT_EQ(feature_at(scene, {4.9, 5}), "fading");
  EXPECT_EQ(feature_at(scene, {5.1, 5}), "ground");
  EXPECT_NEAR(opacity_at(scene, 3, {4.25, 5}), 0.75, 1e-12);
  EXPECT_EQ(opacity_at(scene, 3, {0, 0}), 0);
}

TEST(FeatureAt, FollowsEveryGradient) {
  SceneBuilder build(kTenWide, {1, 1, 1, 1});
  const Area all = build.everywhere(), disc = build.shape(Disc{{5, 5}, 2});
  const std::vector<Stop> stops{{0, {0, 0, 0, 1}}, {1, {0, 0, 0, 0}}};
  const auto layer = [&](auto along, Extend extend) {
    build.layer("one", all, {.color = {0, 0, 0, 1}, .gradient = shared({along, stops, extend})});
  };
  layer(RadialGradient{{5, 5}, {2, 4}, {0, 1}}, Extend::pad);  // 2 upwards, 4 sideways
  layer(DistanceGradient{disc, -1, 1}, Extend::pad);
  layer(LinearGradient{{0, 0}, {1, 0}}, Extend::repeat);
  layer(LinearGradient{{0, 0}, {1, 0}}, Extend::reflect);
  layer(LinearGradient{{1, 1}, {1, 1}}, Extend::pad);
  layer(RadialGradient{{5, 5}, {0, 1}}, Extend::pad);
  layer(DistanceGradient{disc, 0, 0}, Extend::pad);
  const Scene scene = std::move(build).finish();
  EXPECT_NEAR(opacity_at(scene, 0, {5, 6}), 0.5, 1e-12);
  EXPECT_NEAR(opacity_at(scene, 0, {6, 5}), 0.75, 1e-12);
  EXPECT_NEAR(opacity_at(scene, 1, {5, 7}), 0.5, 1e-12);
  EXPECT_NEAR(opacity_at(scene, 1, {5, 6.5}), 0.75, 1e-12);
  EXPECT_NEAR(opacity_at(scene, 2, {3.25, 0}), 0.75, 1e-12);
  EXPECT_NEAR(opacity_at(scene, 3, {3.25, 0}), 0.25, 1e-12);
  EXPECT_EQ(opacity_at(scene, 4, {0, 0}), 0);
  EXPECT_EQ(opacity_at(scene, 5, {5, 5}), 0);
  EXPECT_EQ(opacity_at(scene, 6, {5, 5}), 1);
  EXPECT_EQ(opacity_at(scene, 6, {0, 0}), 0);
}

TEST(FeatureAt, RepeatsFromTheFirstStopToTheLast) {
  SceneBuilder build(kTenWide, {1, 1, 1, 1});
  const std::vector<Stop> stops{{2, {0, 0, 0, 1}}, {4, {0, 0, 0, 0}}};
  for (const Extend extend : {Extend::pad, Extend::repeat, Extend::reflect})
    build.layer("one", build.everywhere(),
                {.color = {0, 0, 0, 1},
                 .gradient = shared({LinearGradient{{0, 0}, {1, 0}}, stops, extend})});
  const Scene scene = std::move(build).finish();
  const double wanted[3][4] = {{1, 0.75, 0, 0}, {0.25, 0.75, 0.75, 0.25}, {0.75, 0.75, 0.25, 0.75}};
  const double places[] = {1.5, 2.5, 4.5, 9.5};
  for (int layer = 0; layer < 3; ++layer)
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(opacity_at(scene, layer, {places[k], 0}), wanted[layer][k], 1e-12)
          << layer << " " << k;
}

TEST(FeatureAt, IsTheThingAndNotItsShadow) {
  SceneBuilder build(kTenWide, {1, 1, 1, 1});
  const Area all = build.everywhere(), disc = build.shape(Disc{{5, 5}, 2});
  build.layer("wall", all, {{1, 1, 1, 1}});
  build.layer("lamp/shadow", all, {{0, 0, 0, 0.5}});
  build.layer("lamp/glow", all, {{1, 1, 0, 0.5}});
  build.layer("lamp", disc, {{1, 1, 0, 1}});
  build.layer("lamp/contour", build.shell(disc, 0.1), {{0, 0, 0, 1}});
  build.layer("a/b", build.shape(Disc{{1, 1}, 1}), {{0, 0, 0, 1}});
  const Scene scene = std::move(build).finish();
  EXPECT_EQ(feature_at(scene, {9, 9}), "wall");
  EXPECT_EQ(feature_at(scene, {5, 5}), "lamp");
  EXPECT_EQ(feature_at(scene, {7.05, 5}), "lamp") << "its contour";
  EXPECT_EQ(feature_at(scene, {1, 1}), "a/b");
}

/// The colour of one place, of some layers of a scene; 0 … 1, premultiplied.
std::vector<float> color_at(const Scene& scene, const std::vector<PartLayer>& layers, glm::dvec2 p,
                            const std::optional<Color>& background = {}) {
  const double half = 1e-7 * (scene.canvas().box.hi.x - scene.canvas().box.lo.x);
  ScenePart part;
  const Scene dot = part.make(scene, layers, {{p - half, p + half}, scene.canvas().y_up});
  const Image image =
      rendered(dot, {.width = 1, .height = 1, .background = background}, {.depth = Depth::f32});
  const auto* channel = reinterpret_cast<const float*>(image.bytes.data());
  return {channel, channel + 4};
}

bool is_light(const Layer& layer) {
  return layer.name.ends_with("/shadow") || layer.name.ends_with("/glow");
}

/// Without the layers above the seen one the place looks the same; and that one alone is not transparent.
void expect_seen(const Scene& scene, glm::dvec2 p) {
  const int seen = layer_seen_at(scene, p), count = int(scene.layers().size());
  std::vector<PartLayer> all, without;
  for (int i = 0; i < count; ++i) {
    const bool above = i > seen && !is_light(scene.layers()[std::size_t(i)]);
    all.push_back({i});
    if (!above) without.push_back({i});
  }
  const auto whole = color_at(scene, all, p), bare = color_at(scene, without, p);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(whole[k], bare[k], 2.0 / 255) << k;
  if (seen < 0) return;
  const Layer& layer = scene.layers()[std::size_t(seen)];
  EXPECT_LE(scene.distance(layer.area, p), 0);
  EXPECT_EQ(layer.name.substr(0, feature_at(scene, p).size()), feature_at(scene, p));
  EXPECT_GT(color_at(scene, {{seen}}, p, Color{0, 0, 0, 0})[3], 0.25f / 255);
}

TEST(FeatureAt, AgreesWithPicturesOfEverySampleFace) {
  constexpr int kPlaces = 24;
  Random random(11);
  for (const char* name : kSampleFaces) {
    const Face face = face_named(name);
    for (const NamedPose& pose : sample_poses(face)) {
      if (pose.name != "rest" && pose.name != "blink_half") continue;
      SCOPED_TRACE(std::string(name) + " " + pose.name);
      const Scene scene = scene_from_face(pose_face(face, pose.pose));
      const auto& [lo, hi] = scene.canvas().box;
      int named = 0;
      for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 p{random.between(lo.x, hi.x), random.between(lo.y, hi.y)};
        SCOPED_TRACE(i);
        expect_seen(scene, p);
        named += !feature_at(scene, p).empty();
      }
      EXPECT_GT(named, 0);
    }
  }
}

}  // namespace
}  // namespace mien::test
