#include "lib/rig/pose/unwrap.h"
#include <mien/face_model.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::sample_face;

constexpr UnwrapMode kModes[] = {UnwrapMode::linear, UnwrapMode::delayed, UnwrapMode::sine};

TEST(UnwrapProgress, FollowsTheLawOfItsMode_G8) {
  EXPECT_EQ(unwrap_progress(UnwrapMode::linear, 0.3, 0.9), 0.3);
  EXPECT_EQ(unwrap_progress(UnwrapMode::delayed, 0.3, 0.9), 0);
  EXPECT_NEAR(unwrap_progress(UnwrapMode::delayed, 0.6, 0.2), 0.5, 1e-15);
  EXPECT_NEAR(unwrap_progress(UnwrapMode::sine, 0.6, 0.2), std::sqrt(0.5), 1e-15);
}

/// 0 at 0, 1 at 1, for every depth: the deepest point moves and the nearest arrives; never backwards.
TEST(UnwrapProgress, RisesFrom0To1AtEveryDepth_G8) {
  for (const UnwrapMode mode : kModes)
    for (const double r : {0.0, 0.3, 0.999, 1.0}) {
      double before = 0;
      for (double w = 0; w < 1; w += 0.01) {
        const double now = unwrap_progress(mode, w, r);
        EXPECT_GE(now, before) << w << " " << r;
        EXPECT_LE(now, 1);
        before = now;
      }
      EXPECT_EQ(unwrap_progress(mode, 0, r), 0);
      EXPECT_EQ(unwrap_progress(mode, 1, r), 1);
      if (r == 0) {
        EXPECT_GT(unwrap_progress(mode, 0.1, r), 0);
      }
    }
}

Face unwrapped(const Face& face, double w, UnwrapMode mode,
               std::vector<std::string> settings = {}) {
  Pose pose = test::pose_of(face, settings);
  pose.unwrap = w, pose.unwrap_mode = mode;
  return pose_face(face, pose);
}

TEST(Unwrap, IsTheFaceAt0AndTheWholeChartAt1_G8) {
  for (const char* name : {"toon", "male", "seed0"}) {
    const Face face = sample_face(name);
    const Face chart = unwrapped(face, 1, UnwrapMode::linear);
    for (const UnwrapMode mode : kModes) {
      EXPECT_EQ(unwrapped(face, 0, mode).vector, face.vector) << name;
      EXPECT_EQ(unwrapped(face, 1, mode).vector, chart.vector) << name;
    }
    EXPECT_NE(chart.vector, face.vector) << name;
  }
}

/// Points go straight to their places, never back, the deep ones first.
TEST(Unwrap, TravelsStraightAndByDepth_G8) {
  const Face toon = sample_face("toon");
  for (const UnwrapMode mode : kModes) {
    const Face chart = unwrapped(toon, 1, mode);
    for (const char* name : {"hair_back/points/0", "nose_shade/points/0", "opening.left/upper",
                             "brow.right/spine/1"}) {
      const glm::dvec2 from = test::point_of(toon, name), to = test::point_of(chart, name);
      double before = 0;
      for (double w = 0.05; w < 1; w += 0.05) {
        const glm::dvec2 way = test::point_of(unwrapped(toon, w, mode), name) - from,
                         whole = to - from;
        const double along = glm::dot(way, whole) / glm::dot(whole, whole);
        EXPECT_LT(std::abs(way.x * whole.y - way.y * whole.x), 1e-12) << name;
        EXPECT_GE(along, before) << name;
        before = along;
      }
    }
  }
  const Face early = unwrapped(toon, 0.4, UnwrapMode::delayed);
  EXPECT_NE(test::point_of(early, "hair_back/points/0"),
            test::point_of(toon, "hair_back/points/0"));
  EXPECT_EQ(test::point_of(early, "nose_shade/points/0"),
            test::point_of(toon, "nose_shade/points/0"));
}

/// In the chart every piece lies in the canvas, and no two on top of each other.
TEST(Unwrap, LaysThePiecesSideBySide_G8) {
  const Face toon = sample_face("toon");
  const Face chart = unwrapped(toon, 1, UnwrapMode::linear);
  const auto middle = [&](const std::string& name) {
    return 0.5 * (test::point_of(chart, name + "/0") + test::point_of(chart, name + "/2"));
  };
  const char* names[] = {"brow.left/spine", "brow.right/spine",  "nose_shade/points",
                         "mouth/spine",     "crease.left/spine", "head/points"};
  for (const std::string one : names) {
    const glm::dvec2 p = middle(one);
    EXPECT_TRUE(p.x > -1.6 && p.x < 1.6 && p.y > -0.95 && p.y < 0.85) << one;
    for (const std::string two : names)
      if (one != two) {
        EXPECT_GT(glm::length(p - middle(two)), 0.05) << one << " " << two;
      }
  }
}

TEST(Unwrap, WorksWithTheHeadTurnedAndEyesShut_G8) {
  const Face toon = sample_face("toon");
  const Face half = unwrapped(toon, 0.5, UnwrapMode::sine, {"yaw=20", "blink=1"});
  EXPECT_EQ(test::point_of(half, "opening.left/upper"), test::point_of(half, "opening.left/lower"));
  EXPECT_NE(test::point_of(half, "nose_shade/points/0"),
            test::point_of(unwrapped(toon, 0.5, UnwrapMode::sine), "nose_shade/points/0"));
  for (const double number : half.vector) EXPECT_TRUE(std::isfinite(number));
}

/// Normals turn to the viewer as a feature travels, and are there when it is: every height goes to 0,
/// in step.
TEST(Unwrap, TurnsNormalsToTheViewer_G8) {
  const Face clay = sample_face("clay");
  const FaceModel& model = *clay.model;
  const auto number = [&](const Face& f, int slice) {
    return f.vector[std::size_t(model.layout[slice].begin)];
  };
  int heights = 0;
  for (const Feature& feature : model.features) {
    if (!feature.relief) continue;
    std::vector<int> rises;
    const FaceRelief& relief = feature.relief.in(model.reliefs);
    if (relief.height >= 0) rises.push_back(relief.height);
    for (const FaceDome& dome : relief.domes) rises.push_back(dome.height);
    for (const int rise : rises) {
      ++heights;
      for (const double w : {0.25, 0.5, 1.0})
        EXPECT_NEAR(number(unwrapped(clay, w, UnwrapMode::linear), rise),
                    (1 - w) * number(clay, rise), 1e-15)
            << feature.name;
    }
  }
  EXPECT_GT(heights, 8);
}

/// A gradient stays where it is on its feature.
TEST(Unwrap, TakesGradientsAlong_G8) {
  const Face bruno = sample_face("bruno");
  const FaceModel& model = *bruno.model;
  const Face half = unwrapped(bruno, 0.5, UnwrapMode::linear);
  int gradients = 0;
  for (const Feature& feature : model.features) {
    const auto* radial = feature.gradient
                             ? std::get_if<RadialPaint>(&feature.gradient.in(model.gradients).along)
                             : nullptr;
    if (!radial) continue;
    ++gradients;
    // Of any two points, and of every size, the same share is left.
    const auto size = [&](const Face& f) {
      return f.vector[std::size_t(model.layout[radial->radii].begin)];
    };
    const auto center = [&](const Face& f) {
      return test::point_of(f, model.layout[radial->center].name);
    };
    for_each_slice(feature.figure, [&](std::string_view, int slice) {
      if (model.layout[slice].kind != SliceKind::point) return;
      const auto way = [&](const Face& f) {
        return test::point_of(f, model.layout[slice].name) - center(f);
      };
      EXPECT_LT(glm::length(way(half) - size(half) / size(bruno) * way(bruno)), 1e-12)
          << model.layout[slice].name;
    });
  }
  EXPECT_EQ(gradients, 7);
}

}  // namespace
}  // namespace mien
