#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/support/faces/face_path.h"

namespace mien {
namespace {

Face sample(const std::string& name) {
  const Expected<Face> face = read_face(test::face_path(name));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

Scene scene_of(const Face& face, std::initializer_list<std::string> settings) {
  Pose pose;
  for (const std::string& text : settings) {
    const Expected<Setting> setting = read_setting(face, text);
    if (!setting) throw std::runtime_error(sentence(setting.error()));
    pose.settings.push_back(*setting);
  }
  return scene_from_face(pose_face(face, pose));
}

const Layer& layer(const Scene& scene, std::string_view name) {
  for (const Layer& l : scene.layers())
    if (l.name == name) return l;
  throw std::runtime_error("no layer " + std::string(name));
}

/// The areas of a small face with the given features, all painted.
Scene scene_with(const std::string& features, const char* axis = "up") {
  const Expected<Face> face = read_face_text(
      R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": ")" +
      std::string(axis) +
      R"("}, "palette": {"ink": "#000000"}, "background": "ink", "features": [)" + features + "]}");
  if (!face) throw std::runtime_error(sentence(face.error()));
  return scene_from_face(*face);
}

/// A smooth polyline passes through its points, meets its mirror image without a corner, and is a line
/// where its points are.
TEST(SceneFromFace, SmoothPolylinesPassThroughTheirPoints) {  // M2
  const std::string points = "[[0, 0.2], [0.3, 0.5], [0.6, -0.4], [0.7, -0.4]]";
  const Scene scene = scene_with(
      R"({"name": "a", "kind": "polyline", "side": "left", "paint": "ink", "smooth": true, "half_width": 0.01, "points": )" +
      points + "}");
  const Area left = layer(scene, "a.left").area, right = layer(scene, "a.right").area;
  for (const glm::dvec2 p : {glm::dvec2{0, 0.2}, {0.3, 0.5}, {0.6, -0.4}, {0.7, -0.4}}) {
    EXPECT_NEAR(scene.distance(left, p), -0.01, 1e-9);
    EXPECT_NEAR(scene.distance(right, {-p.x, p.y}), -0.01, 1e-9);
  }
  // Level where the halves meet: nothing of the line lies below its middle point nearby.
  EXPECT_GT(scene.distance(left, {0.01, 0.185}), 0);
  EXPECT_GT(scene.distance(left, {0.3, 0.515}), -0.01);
  EXPECT_GT(scene.distance(left, {0.45, 0.05}), 0) << "not the straight line";
  const Scene straight = scene_with(
      R"({"name": "a", "kind": "polyline", "paint": "ink", "smooth": true, "half_width": 0.01, "points": [[0.1, 0.1], [0.5, 0.5], [0.5, 0.5]]})");
  EXPECT_NEAR(straight.distance(layer(straight, "a").area, {0.25, 0.25}), -0.01, 1e-9);
}

TEST(SceneFromFace, DrawsTheEyesInTheSourcesOrder_E1toE6) {
  const Scene scene = scene_from_face(sample("seed0"));
  std::vector<std::string> names;
  for (const Layer& l : scene.layers()) names.push_back(l.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"sclera.right", "sclera.left", "pupil.right", "pupil.left",
                                      "upper_lid.right", "upper_lid.left", "brow_low.right",
                                      "brow_low.left", "brow_high.right", "brow_high.left"}));
  EXPECT_EQ(scene.canvas().box.hi, glm::dvec2(1, 0.5625));
  EXPECT_TRUE(scene.canvas().y_up);
}

/// Inside and outside as the source's formulas say, at any pose, away from outlines by more than
/// rounding.
TEST(SceneFromFace, AgreesWithTheSourcesFormulas_E1toE4) {
  const Face seed = sample("seed0");
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit{0, 1};
  constexpr double kShape[4][4] = {
      {.9, .04, -1, .34}, {.7, .06, -.7, .30}, {.5, .10, -.4, .24}, {.3, .20, -.1, .20}};
  for (int turn = 0; turn < 60; ++turn) {
    const double gx = unit(random) * 0.2 - 0.1, gy = unit(random) * 0.2 - 0.1,
                 dilation = unit(random) + 0.5, blink = unit(random);
    const auto set = [](const char* name, double value) {
      return std::string(name) + "=" + std::to_string(value);
    };
    const Scene scene = scene_of(seed, {set("gaze.x", gx), set("gaze.y", gy),
                                        set("dilation", dilation), set("blink", blink)});
    const double s = std::stod(std::to_string(blink)) * 3;
    const int k = std::min(2, int(s));
    double shape[4];
    for (int i = 0; i < 4; ++i)
      shape[i] = kShape[k][i] + (s - k) * (kShape[k + 1][i] - kShape[k][i]);
    for (int i = 0; i < 400; ++i) {
      const double x = unit(random), y = unit(random) * 0.5625;
      for (const bool left : {false, true}) {
        const double q = (x - (left ? 0.53 : 0)) * 1.8 - 0.42;
        const double open =
            std::min(y - (shape[0] * q * q + shape[1]), shape[2] * q * q + shape[3] - y);
        const double white = std::min(open, std::min(y - (0.9 * q * q + 0.04), -q * q + 0.34 - y));
        const double ex = (x - (left ? 0.76 : 0.23) - gx) / (0.09 * dilation),
                     ey = (y - 0.19 - gy) / (0.105 * dilation);
        const double pupil = std::min(open, 1 - ex * ex - ey * ey);
        const std::string side = left ? ".left" : ".right";
        if (std::abs(white) > 1e-4) {
          EXPECT_EQ(scene.distance(layer(scene, "sclera" + side).area, {x, y}) < 0, white > 0)
              << x << " " << y;
        }
        if (std::abs(pupil) > 1e-4) {
          EXPECT_EQ(scene.distance(layer(scene, "pupil" + side).area, {x, y}) < 0, pupil > 0)
              << x << " " << y;
        }
      }
    }
  }
}

TEST(SceneFromFace, SharesTheClipsVeryArea) {
  const Scene scene = scene_from_face(sample("toon"));
  const auto clip_of = [&](std::string_view name) {
    const Node& node = scene.nodes()[std::size_t(layer(scene, name).area.node)];
    EXPECT_EQ(node.op, Op::intersect) << name;
    return node.b;
  };
  const int opening = layer(scene, "opening.left").area.node;
  EXPECT_EQ(clip_of("limbus.left"), opening);
  EXPECT_EQ(clip_of("lid_shade.left"), opening);
  EXPECT_EQ(clip_of("iris.left"), layer(scene, "limbus.left").area.node);
  EXPECT_NE(clip_of("limbus.right"), opening);
}

/// At rest the source's sclera and its opening are one outline: it is drawn as one.
TEST(SceneFromFace, KnowsAFeatureThatIsItsOwnClip) {
  const Face seed = sample("seed0");
  const auto op = [&](const Scene& scene) {
    return scene.nodes()[std::size_t(layer(scene, "sclera.left").area.node)].op;
  };
  EXPECT_EQ(op(scene_from_face(seed)), Op::shape);
  EXPECT_EQ(op(scene_of(seed, {"blink=0.1"})), Op::intersect);
}

TEST(SceneFromFace, DrawsPolylinesAndCutDiscs_M2_M3) {
  const Scene scene = scene_from_face(sample("male"));
  EXPECT_FALSE(scene.canvas().y_up);
  const auto distance = [&](std::string_view name, double x, double y) {
    return scene.distance(layer(scene, name).area, {x, y});
  };
  EXPECT_NEAR(distance("eyebrow.left", 40, -34), -2.5, 1e-12);  // 5 · weight wide
  EXPECT_NEAR(distance("eye.right", -50, 5 + 3), 3 - 0.75,
              1e-12);  // a round cap, on the other side
  EXPECT_LT(distance("eyeball.left", 82, -0.69 * 13),
            0);  // the upper chord is the one nearer the brow
  EXPECT_GT(distance("eyeball.left", 82, -0.71 * 13), 0);
  EXPECT_LT(distance("eyeball.left", 82, 0.93 * 13), 0);
  EXPECT_GT(distance("eyeball.left", 82, 0.95 * 13), 0);
}

TEST(SceneFromFace, CutsDiscsAboveAndBelowWhicheverWayYRuns) {
  const std::string cut =
      R"({"name": "a", "kind": "cut_disc", "paint": "ink", "center": [0, 0], "radius": 1, "chords": [0.2, 0.8]})";
  const Scene up = scene_with(cut), down = scene_with(cut, "down");
  EXPECT_GT(up.distance(up.layers()[0].area, {0, 0.5}), 0);
  EXPECT_LT(up.distance(up.layers()[0].area, {0, -0.5}), 0);
  EXPECT_GT(down.distance(down.layers()[0].area, {0, -0.5}), 0);
  EXPECT_LT(down.distance(down.layers()[0].area, {0, 0.5}), 0);
}

TEST(SceneFromFace, BuildsPathsFromOutlinePointsAndBends) {
  const Scene square = scene_with(
      R"({"name": "a", "kind": "path", "paint": "ink", "points": [[0, 0], [1, 0], [1, 1], [0, 1]]})");
  const auto& straight = std::get<Path>(square.shapes()[0]).loops[0].sides;
  ASSERT_EQ(straight.size(), 4u);
  EXPECT_EQ(straight[0].p1, glm::dvec2(0.5, 0));
  EXPECT_EQ(straight[3].p2, straight[0].p0);
  const Scene round = scene_with(
      R"({"name": "a", "kind": "path", "paint": "ink", "points": [[1, 1, "bend"], [-1, 1, "bend"], [-1, -1, "bend"], [1, -1, "bend"]]})");
  const auto& curved = std::get<Path>(round.shapes()[0]).loops[0].sides;
  ASSERT_EQ(curved.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(curved[i].p2, curved[(i + 1) % 4].p0);
  EXPECT_EQ(curved[0].p0, glm::dvec2(1, 0));  // half-way between two bends
  EXPECT_EQ(curved[0].p1, glm::dvec2(1, 1));
  const Scene mixed = scene_with(
      R"({"name": "a", "kind": "path", "paint": "ink", "points": [[0, 0], [1, 0, "bend"], [1, 1]]})");
  const auto& two = std::get<Path>(mixed.shapes()[0]).loops[0].sides;
  ASSERT_EQ(two.size(), 2u);  // a curve from 0,0 by 1,0 to 1,1 and a straight side back
  EXPECT_EQ(two[0].p1, glm::dvec2(1, 0));
  EXPECT_EQ(two[1].p0, glm::dvec2(1, 1));
  EXPECT_EQ(two[1].p2, glm::dvec2(0, 0));
}

TEST(SceneFromFace, TiltsEllipsesTheWayTheAngleSays) {
  const Scene scene = scene_with(
      R"({"name": "a", "kind": "ellipse", "paint": "ink", "side": "left", "center": [0.5, 0], "radii": [0.4, 0.1], "tilt": 45})");
  EXPECT_LT(scene.distance(layer(scene, "a.left").area, {0.5 + 0.2, 0.2}), 0);
  EXPECT_GT(scene.distance(layer(scene, "a.left").area, {0.5 + 0.2, -0.2}), 0);
  EXPECT_LT(scene.distance(layer(scene, "a.right").area, {-0.5 - 0.2, 0.2}), 0);
}

TEST(SceneFromFace, DrawsBandsInAFrameThatDoesNotChange) {
  const Scene scene = scene_with(
      R"({"name": "a", "kind": "band", "paint": "ink", "frame": [0, 0.5], "lower": [1, 0], "upper": [-1, 1]})");
  EXPECT_NEAR(scene.distance(scene.layers()[0].area, {7, 0.5}), -0.25,
              1e-15);  // between y = 1/4 and y = 3/4
  EXPECT_NEAR(scene.distance(scene.layers()[0].area, {7, 1}), 0.25, 1e-15);
}

/// The last shape of the source's blink leaves no height in the middle, q = 0.
TEST(SceneFromFace, TheSourcesShutEyeHasNoHeightInItsMiddle_E4) {
  const Scene scene = scene_of(sample("seed0"), {"blink=1"});
  for (const char* side : {"right", "left"}) {
    const double x = (side == std::string("right") ? 0.42 : 1.374) / 1.8;  // q = 1.8 x − …
    const Area pupil = layer(scene, std::string("pupil.") + side).area;
    for (double y = 0.1; y < 0.3; y += 0.001)
      EXPECT_GE(scene.distance(pupil, {x, y}), -1e-12) << side << " " << y;
  }
}

/// A stroke along a pushed lid edge is one pen line: its pieces' widths are those of the whole.
TEST(SceneFromFace, ALidStrokeKeepsItsWidthsWhenItsEdgeIsPushed) {
  const Face toon = sample("toon");
  const Scene rest = scene_from_face(toon);
  Pose touch;  // a push too small to see: the edge is cut into its pieces
  touch.settings.push_back(*read_setting(toon, "opening.left/upper_shift/3=0,1e-12"));
  const Scene cut = scene_from_face(pose_face(toon, touch));
  EXPECT_GT(cut.shapes().size(), rest.shapes().size() + 10);
  std::mt19937 random{4};
  std::uniform_real_distribution<double> unit{0, 1};
  for (const char* name : {"upper_lid.left", "lid_shade.left", "opening.left", "iris.left"}) {
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec2 p{0.05 + 0.4 * unit(random), -0.2 + 0.5 * unit(random)};
      const double was = rest.distance(layer(rest, name).area, p);
      const double is = cut.distance(layer(cut, name).area, p);
      if (was > 0) {
        EXPECT_NEAR(is, was, 1e-9) << name;
      }
      if (std::abs(was) > 1e-9) {
        EXPECT_EQ(is < 0, was < 0) << name;
      }
    }
  }
}

/// The spines of a tapered stroke, or of a union of them.
std::vector<QuadBezier> spines_of(const Scene& scene, int index) {
  const Node& node = scene.nodes()[std::size_t(index)];
  if (node.op == Op::shape)
    return {std::get<TaperedStroke>(scene.shapes()[std::size_t(node.a)]).spine};
  EXPECT_EQ(node.op, Op::unite);
  std::vector<QuadBezier> all = spines_of(scene, node.a), more = spines_of(scene, node.b);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The lid stroke covers the edge of what is white: nothing of the eye's inside is ever farther out
/// than it.
TEST(SceneFromFace, NothingOfTheEyeLeavesTheLidThroughABlink_E5) {
  const Face toon = sample("toon");
  std::mt19937 random{2};
  std::uniform_real_distribution<double> unit{0, 1};
  for (int step = 0; step <= 1000;
       ++step) {  // through it the eye looks all round, and the lids bulge
    const double a = step * 0.02;
    const Scene scene = scene_of(toon, {"blink=" + std::to_string(step / 1000.0),
                                        "gaze.x=" + std::to_string(0.07 * std::cos(a)),
                                        "gaze.y=" + std::to_string(0.05 * std::sin(a))});
    const Area white = layer(scene, "opening.left").area, lid = layer(scene, "upper_lid.left").area;
    const std::vector<QuadBezier> spines = spines_of(scene, lid.node);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec2 edge = point(spines[std::size_t(i) % spines.size()], unit(random));
      const glm::dvec2 above = edge + glm::dvec2(0, 1e-9 + 0.1 * unit(random));
      EXPECT_GE(scene.distance(white, above), 0) << "white above the lid at blink " << step;
      EXPECT_LT(scene.distance(lid, edge), 0) << "the lid leaves its edge at blink " << step;
    }
    if (step < 1000) continue;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec2 p{0.05 + 0.4 * unit(random), -0.2 + 0.4 * unit(random)};
      for (const char* part :
           {"opening.left", "limbus.left", "iris.left", "pupil.left", "glint.left"}) {
        EXPECT_GT(scene.distance(layer(scene, part).area, p), 0) << part << " shows in a shut eye";
      }
    }
  }
}

TEST(SceneFromFace, IsTotal) {
  const Face toon = sample("toon");
  std::mt19937 random{3};
  std::uniform_real_distribution<double> wide{-2e9, 2e9};
  for (int turn = 0; turn < 20; ++turn) {
    Pose pose;
    for (int i = 0; i < int(toon.vector.size()); ++i)
      pose.settings.push_back({false, i, {turn == 0 ? 0.0 : wide(random)}});
    const Scene scene = scene_from_face(pose_face(toon, pose));
    for (const Layer& l : scene.layers())
      EXPECT_FALSE(std::isnan(scene.distance(l.area, {0.1, 0.2}))) << l.name;
  }
}

TEST(SceneFromFace, PaintsWithGradients_E13) {
  const Scene scene = scene_with(
      R"({"name": "eye", "kind": "disc", "center": [0, 0], "radius": 0.5, "opacity": 0.5,
          "paint": {"gradient": "distance", "inside": 0.1, "outside": 0.05, "extend": "repeat",
                    "stops": [[0, "ink"], [1, "ink"]]}})");
  const Paint& paint = scene.layers()[0].paint;
  EXPECT_EQ(paint.color.a, 0.5);
  ASSERT_TRUE(paint.gradient);
  const auto& along = std::get<DistanceGradient>(paint.gradient->along);
  EXPECT_EQ(along.from, -0.1);
  EXPECT_EQ(along.to, 0.05);
  EXPECT_EQ(along.area.node, scene.layers()[0].area.node);
  EXPECT_EQ(paint.gradient->extend, Extend::repeat);
}

TEST(SceneFromFace, DrawsWhatFollowsAnOutline) {
  const Scene scene = scene_with(
      R"({"name": "eye", "kind": "disc", "center": [0, 0], "radius": 0.5, "paint": "ink",
          "shadow": {"color": "ink", "blur": 0.1, "shift": [0.2, 0]}, "glow": {"color": "ink", "reach": 0.3},
          "contour": {"color": "ink", "half_width": 0.05}})");
  ASSERT_EQ(scene.layers().size(), 4u);
  std::vector<std::string> names;
  for (const Layer& layer : scene.layers()) names.push_back(layer.name);
  EXPECT_EQ(names, (std::vector<std::string>{"eye/shadow", "eye/glow", "eye", "eye/contour"}));
  const auto& shadow = std::get<DistanceGradient>(scene.layers()[0].paint.gradient->along);
  EXPECT_NEAR(scene.distance(shadow.area, {0.7, 0}), 0, 1e-15);
  EXPECT_EQ(std::get<DistanceGradient>(scene.layers()[1].paint.gradient->along).to, 0.3);
  EXPECT_NEAR(scene.distance(scene.layers()[3].area, {0.55, 0}), 0, 1e-15);
  EXPECT_NEAR(scene.distance(scene.layers()[3].area, {0.5, 0}), -0.05, 1e-15);
  const Scene thin = scene_with(
      R"({"name": "eye", "kind": "disc", "center": [0, 0], "radius": 0.5,
          "contour": {"color": "ink", "half_width": 0}})");
  EXPECT_TRUE(thin.layers().empty());
}

TEST(SceneFromFace, LeavesOutReliefsThatDoNotRise_G3_C1) {
  const auto paint = [](const std::string& relief) {
    return scene_with(
               R"({"name": "lid", "kind": "disc", "center": [0, 0], "radius": 0.5, "paint": "ink", "relief": )" +
               relief + "}")
        .layers()[0]
        .paint;
  };
  EXPECT_FALSE(paint(R"({"profile": "flat"})").relief);
  EXPECT_FALSE(paint(R"({"profile": "round", "width": 0.1, "height": 0})").relief);
  const std::string dome = R"({"domes": [{"center": [0, 0], "radii": [0.1, 0.1], "height": )";
  EXPECT_FALSE(paint(dome + "0}]}").relief);
  const Paint bulging = paint(dome + "0.02}]}");
  ASSERT_TRUE(bulging.relief);
  EXPECT_EQ(bulging.relief->domes.at(0).height, 0.02);
  EXPECT_EQ(
      paint(R"({"profile": "bevel", "width": 0.1, "height": 0.2, "sunk": true})").relief->height,
      -0.2);
}

TEST(SceneFromFace, CountsAReliefFromTheFigureNotFromWhatItIsClippedTo_G3) {
  const Scene scene = scene_with(
      R"({"name": "eye", "kind": "disc", "center": [0, 0], "radius": 0.5},
         {"name": "ball", "kind": "disc", "clip": "eye", "center": [0.3, 0], "radius": 0.5, "paint": "ink",
          "relief": {"profile": "round", "width": 0.1, "height": 0.1}})");
  const Layer& ball = scene.layers()[0];
  EXPECT_NE(ball.paint.relief->area.node, ball.area.node);
  EXPECT_EQ(scene.distance(ball.paint.relief->area, {-0.2, 0}), 0);
}

TEST(SceneFromFace, PutsFeaturesIntoTheirGroups) {
  const Expected<Face> face = read_face_text(
      R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
          "palette": {"ink": "#000000"}, "background": "ink",
          "groups": {"frame": {}, "glasses": {"opacity": 0.5, "mix": "multiply", "clip": "head"}},
          "features": [
            {"name": "head", "kind": "disc", "center": [0, 0], "radius": 0.9, "paint": "ink"},
            {"name": "lens", "kind": "disc", "center": [0, 0], "radius": 0.2, "paint": "ink", "group": "glasses"},
            {"name": "bridge", "kind": "disc", "center": [0, 0], "radius": 0.1, "paint": "ink", "group": "frame"},
            {"name": "nose", "kind": "disc", "center": [0, 0], "radius": 0.1, "paint": "ink"}]})");
  ASSERT_TRUE(face) << sentence(face.error());
  const Scene scene = scene_from_face(*face);
  ASSERT_EQ(scene.groups().size(), 2u);
  EXPECT_EQ(scene.groups()[0].name, "glasses");
  EXPECT_EQ(scene.groups()[0].opacity, 0.5);
  EXPECT_EQ(scene.groups()[0].mix, MixMode::multiply);
  EXPECT_EQ(scene.groups()[1].mix, MixMode::normal);
  EXPECT_EQ(scene.groups()[1].parent, -1);
  const int expected[] = {-1, 0, 1, -1};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.layers()[i].group, expected[i]);
  EXPECT_EQ(scene.nodes()[std::size_t(scene.layers()[1].area.node)].op, Op::intersect);
}

}  // namespace
}  // namespace mien
