#include "lib/rig/eye/eye.h"

#include "lib/rig/eye/blink.h"
#include "lib/rig/eye/gaze.h"
#include "lib/rig/eye/lid.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "tests/support/faces/eye_surface.h"
#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::face_at;
using test::point_of;
using test::poses_named;
using test::sample_face;
using test::slice_of;

std::string set(const std::string& name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s=%.17g", name.c_str(), value);
  return text;
}

glm::dvec2 iris_way(const Face& rest, const Face& now, const std::string& side) {
  const std::string name = "limbus." + side + "/center";
  return point_of(now, name) - point_of(rest, name);
}

Face looking(const Face& face, glm::dvec3 target) {
  return pose_face(face, {.look_at = target});
}

TEST(Eyes, OfToonAndSeedLookAtAPoint_E8) {
  const Face toon = sample_face("toon");
  double before = 0;
  for (const double z : {50.0, 5.0, 2.0, 1.0}) {
    const Face now = looking(toon, {0, 0.026, z});
    const glm::dvec2 left = iris_way(toon, now, "left"), right = iris_way(toon, now, "right");
    EXPECT_EQ(left.x, -right.x);
    EXPECT_GT(right.x, before) << z;  // they converge
    before = right.x;
  }
  const Face far = looking(toon, {3e8, 2e8, 1e9});
  EXPECT_LT(glm::length(iris_way(toon, far, "left") - iris_way(toon, far, "right")), 1e-9);
  EXPECT_GT(iris_way(toon, far, "left").x, 0.05);
  const Face seed = sample_face("seed0");
  const Face near = looking(seed, {0.5, 0.19, 0.5});
  EXPECT_GT(point_of(near, "pupil.right/center").x, 0.23 + 0.05);
  EXPECT_LT(point_of(near, "pupil.left/center").x, 0.76 - 0.05);
}

TEST(Eyes, LookNoFartherThanTheyReach_E8) {
  const Face toon = sample_face("toon");
  for (const glm::dvec3 target : {glm::dvec3{9, 0, 1}, {9, 9, 0}, {-9, 2, -5}, {0, -9, 0.1}})
    for (const char* side : {"left", "right"}) {
      const glm::dvec2 way = iris_way(toon, looking(toon, target), side);
      EXPECT_NEAR(std::hypot(way.x / 0.08, way.y / 0.06), 1, 1e-12);
    }
}

TEST(Eyes, SettingsBeatTheGazeAndTheGazeBeatsClips_E8) {
  const Face toon = sample_face("toon");
  Pose pose{.time = 2.0, .look_at = glm::dvec3{0.4, 0.2, 2}};
  const Face gazing = pose_face(toon, pose);
  EXPECT_EQ(iris_way(toon, gazing, "left"), iris_way(toon, looking(toon, {0.4, 0.2, 2}), "left"));
  pose.settings = test::pose_of(toon, {"gaze.left.x=0.01"}).settings;
  EXPECT_EQ(point_of(pose_face(toon, pose), "limbus.left/center").x,
            point_of(toon, "limbus.left/center").x + 0.01);
}

TEST(Eyes, DilateEachForItself_E3) {
  for (const char* name : {"toon", "seed0"}) {
    const Face face = sample_face(name);
    const Face now = face_at(face, {"dilation.left=1.3"});
    const auto area = [](const Face& f, const std::string& side) {
      const std::vector<double> radii = slice_of(f, "pupil." + side + "/radii");
      return radii[0] * radii[1];
    };
    EXPECT_NEAR(area(now, "left") / area(face, "left"), 1.3 * 1.3, 1e-12);
    EXPECT_EQ(area(now, "right"), area(face, "right"));
  }
}

/// The middle of an edge goes its share of the gaze's way; the crease goes its share of the lid's.
TEST(Lids, FollowTheGazeAndTheCreaseFollowsThem_C4) {
  const Face toon = sample_face("toon");
  const Eye& eye = toon.model->eyes[0];
  ASSERT_EQ(eye.name, "eyeball.left");
  const auto middle = [](const Face& f, const char* edge) {
    return point(QuadBezier{point_of(f, "opening.left/inner"),
                            point_of(f, std::string("opening.left/") + edge),
                            point_of(f, "opening.left/outer")},
                 0.5);
  };
  for (const double x : {-0.08, 0.0, 0.08})
    for (const double y : {-0.06, 0.0, 0.06}) {
      const Face now = face_at(toon, {set("gaze.x", x), set("gaze.y", y)});
      const glm::dvec2 upper = middle(now, "upper") - middle(toon, "upper");
      const glm::dvec2 lower = middle(now, "lower") - middle(toon, "lower");
      EXPECT_NEAR(upper.x, eye.follow_upper[0] * x, 1e-15);
      EXPECT_NEAR(upper.y, eye.follow_upper[1] * y, 1e-15);
      EXPECT_NEAR(lower.x, eye.follow_lower[0] * x, 1e-15);
      EXPECT_NEAR(lower.y, eye.follow_lower[1] * y, 1e-15);
      const glm::dvec2 crease =
          point_of(now, "crease.left/spine/1") - point_of(toon, "crease.left/spine/1");
      const double share = y > 0 ? eye.crease_rise : eye.crease_fall;
      EXPECT_NEAR(crease.y, share * 2 * upper.y, 1e-15) << x << " " << y;
    }
  EXPECT_GT(eye.follow_upper[1], 0.2);
  EXPECT_GT(eye.crease_rise, eye.crease_fall);
}

/// A lid stroke beside the edge keeps its distance to it.
TEST(Lids, CarryWhatRidesOnThem_C4) {
  const Face toon = sample_face("toon");
  const auto gap = [](const Face& f) {  // between the lower lid's line and the edge, at its middle
    const QuadBezier line{point_of(f, "lower_lid.left/spine/0"),
                          point_of(f, "lower_lid.left/spine/1"),
                          point_of(f, "lower_lid.left/spine/2")};
    const QuadBezier edge{point_of(f, "opening.left/inner"), point_of(f, "opening.left/lower"),
                          point_of(f, "opening.left/outer")};
    return glm::length(point(line, 0.5) - point(edge, nearest_parameter(edge, point(line, 0.5))));
  };
  const Face shut = face_at(toon, {"blink=1", "bias=1"});
  EXPECT_GT(point_of(shut, "lower_lid.left/spine/1").y,
            point_of(toon, "lower_lid.left/spine/1").y + 0.1);
  EXPECT_LT(std::abs(gap(shut) - gap(toon)), 0.012);
}

/// The bends of a lid's edge as they are drawn.
LidBends drawn_bends(const Face& face, const std::string& side, bool upper) {
  const std::string opening = "opening." + side, edge = upper ? "/upper" : "/lower";
  LidBends bends = lid_bends({point_of(face, opening + "/inner"), point_of(face, opening + edge),
                              point_of(face, opening + "/outer")});
  for (std::size_t i = 0; i < bends.size(); ++i)
    bends[i] += point_of(face, opening + edge + "_shift/" + std::to_string(i));
  return bends;
}

/// The drawn edge of a lid as points.
std::vector<glm::dvec2> drawn_edge(const Face& face, const std::string& side, bool upper) {
  const std::string opening = "opening." + side;
  std::vector<glm::dvec2> points;
  for (const QuadBezier& piece :
       pieces_between(point_of(face, opening + "/inner"), drawn_bends(face, side, upper),
                      point_of(face, opening + "/outer")))
    for (int k = 0; k <= 8; ++k) points.push_back(point(piece, k / 8.0));
  return points;
}

/// Where the bends of a posed lid stand before the cornea pushes them: drawn less the push at rest,
/// which closes with the lids.
std::array<LidBends, 2> standing_bends(const Face& rest, const Face& now, const EyeBody& body,
                                       double blink) {
  const auto bends = [](const Face& f, const char* edge) {
    return lid_bends(
        {point_of(f, "opening.left/inner"), point_of(f, edge), point_of(f, "opening.left/outer")});
  };
  const char* edges[] = {"opening.left/upper", "opening.left/lower"};
  std::array<LidBends, 2> standing = {bends(now, edges[0]), bends(now, edges[1])};
  for (std::size_t i = 0; i < standing[0].size(); ++i) {
    const auto push = [&](const char* edge) {
      const glm::dvec2 at = bends(rest, edge)[i];
      return at - standing_place(body, at, {0, 0, 1});
    };
    const LidPair less =
        blinked({push(edges[0]), push(edges[1])}, blink, meeting_share(0, now.model->eyes[0].meet));
    standing[0][i] -= less.upper, standing[1][i] -= less.lower;
  }
  return standing;
}

/// Every bend of a lid's edge clears the eye; between bends the edge does to a share of the bulge. The
/// canthi stay, so what runs into them is not looked at.
TEST(Lids, NeverCutIntoTheEyeThroughAGazeAndABlink_C3) {
  const Face toon = sample_face("toon");
  double least = 9, between = 9;
  for (double blink = 0; blink <= 1; blink += 0.125)
    for (int turn = 0; turn < 16; ++turn) {
      const double a = turn * 0.4, x = 0.08 * std::cos(a), y = 0.06 * std::sin(a);
      const Face now = face_at(toon, {set("gaze.x", x), set("gaze.y", y), set("blink", blink)});
      const EyeBody body = eye_body(*now.model, now.model->eyes[0], now.vector);
      ASSERT_GT(body.bulge, 0);
      const glm::dvec3 axis = gaze_axis({x, y}, body.radius);
      const std::array<LidBends, 2> standing = standing_bends(toon, now, body, blink);
      for (const bool upper : {true, false}) {
        const LidBends drawn = drawn_bends(now, "left", upper), &stand = standing[upper ? 0 : 1];
        for (std::size_t i = 0; i < drawn.size(); ++i) {
          least = std::min(least, test::lid_clearance(body, stand[i], drawn[i], axis));
          if (i == 0 || i + 1 == drawn.size()) continue;
          const QuadBezier stands{0.5 * (stand[i - 1] + stand[i]), stand[i],
                                  0.5 * (stand[i] + stand[i + 1])};
          const QuadBezier is{0.5 * (drawn[i - 1] + drawn[i]), drawn[i],
                              0.5 * (drawn[i] + drawn[i + 1])};
          for (int k = 0; k <= 8; ++k)
            between = std::min(between, test::lid_clearance(body, point(stands, k / 8.0),
                                                            point(is, k / 8.0), axis));
        }
      }
    }
  EXPECT_GE(least, -1e-15);
  EXPECT_LT(least, 1e-4);  // and lies close on it
  EXPECT_GE(between, -0.04 * 0.025);
}

/// Shut is shut: both edges are the same points, bit for bit, wherever they meet, whatever they were,
/// wherever the eye looks.
TEST(Lids, MeetOnOneCurveForEveryBiasPoseAndGaze_C5) {
  const Face toon = sample_face("toon");
  std::vector<std::string> lids = poses_named(toon, "lid.");
  lids.push_back("blink");  // none
  for (const std::string& lid : lids)
    for (const double bias : {-1.0, -0.3, 0.0, 0.6, 1.0})
      for (const double gaze : {-0.06, 0.0, 0.05}) {
        const Face shut = face_at(toon, {set(lid, 1), set("gaze.x", 1.3 * gaze),
                                         set("gaze.y", gaze), "blink=1", set("bias", bias)});
        for (const char* side : {"left", "right"}) {
          EXPECT_EQ(drawn_edge(shut, side, true), drawn_edge(shut, side, false))
              << lid << " " << bias;
        }
      }
}

/// Poses that would cross the lids do not.
TEST(Lids, NeverCross) {
  const Face toon = sample_face("toon");
  const std::vector<std::string> lids = poses_named(toon, "lid.");
  for (const std::string& one : lids)
    for (const std::string& two : lids)
      for (const double blink : {0.0, 0.5}) {
        const Face now =
            face_at(toon, {set(one, 1), set(two, 1), "gaze.y=-0.06", set("blink", blink)});
        EXPECT_GE(point_of(now, "opening.left/upper").y, point_of(now, "opening.left/lower").y)
            << one << " and " << two;
      }
}

TEST(Bulge, MovesTheLidsEdgeWithTheGaze_C2) {
  const Face toon = sample_face("toon");
  const auto shifts = [&](double x, double y, bool upper) {
    const Face now = face_at(toon, {set("gaze.x", x), set("gaze.y", y)});
    std::array<double, OpeningFigure::kLidBends> sizes;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      sizes[i] =
          glm::length(point_of(now, std::string("opening.left/") + (upper ? "upper" : "lower") +
                                        "_shift/" + std::to_string(i)));
    return sizes;
  };
  for (const double size : shifts(0, 0, true)) EXPECT_EQ(size, 0);
  for (const double size : shifts(0, 0, false)) EXPECT_EQ(size, 0);
  const auto inner = shifts(-0.07, 0, true), outer = shifts(0.07, 0, true);
  EXPECT_GT(inner[1], 2 * outer[1]);  // the bump is where the iris went
  EXPECT_GT(outer[6], 2 * inner[6]);
  const auto down = shifts(0, -0.06, false);
  EXPECT_GT(down[4], 0.0005);
}

/// The text of toon with things in it replaced.
Face toon_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = test::text_of_face("toon");
  for (const auto& [what, instead] : changes) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) throw std::runtime_error("toon has no " + what);
    text.replace(at, what.size(), instead);
  }
  const Expected<Face> face = read_face_text(text);
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

TEST(Bulge, Of0LeavesEveryBitAsWithoutOne_C1) {
  const Face flat = toon_with({{"\"bulge\": 0.025", "\"bulge\": 0"}});
  const Face none = toon_with(
      {{"\"cornea\": 0.05, \"bulge\": 0.025,", ""}, {",\n       \"raise\": [\"lid\"]", ""}});
  for (const std::vector<std::string>& settings : {std::vector<std::string>{},
                                                   {"gaze.x=0.07", "gaze.y=0.03"},
                                                   {"blink=0.4", "gaze.y=-0.05"},
                                                   {"blink=1"}}) {
    const Face a = face_at(flat, settings), b = face_at(none, settings);
    for (const Slice& slice : b.model->layout.slices())
      EXPECT_EQ(slice_of(a, slice.name), slice_of(b, slice.name)) << slice.name;
    for (const Slice& slice : a.model->layout.slices())
      if (slice.kind == SliceKind::shift) {
        EXPECT_EQ(point_of(a, slice.name), glm::dvec2(0)) << slice.name;
      }
  }
}

/// By the compat law the edge moves along the eye's axis: sideways where the eye looks aside, and
/// not at all in the picture where it looks ahead.
TEST(Bulge, CompatMovesTheEdgeAlongTheAxis_C1) {
  const Face compat =
      toon_with({{"\"bulge\": 0.025,", "\"bulge\": 0.025, \"bulge_law\": \"compat\","}});
  const Face now = face_at(compat, {"gaze.x=0.07", "gaze.y=0.035", "blink=0.4"});
  int moved = 0;
  for (int i = 0; i < OpeningFigure::kLidBends; ++i) {
    const glm::dvec2 shift = point_of(now, "opening.left/upper_shift/" + std::to_string(i));
    EXPECT_NEAR(shift.x * 0.035, shift.y * 0.07, 1e-15);
    moved += shift.x > 1e-5;
  }
  EXPECT_GE(moved, 1);
}

TEST(Lids, OfARestingFaceKeepEveryBit) {
  for (const char* name : {"toon", "seed0", "male"}) {
    const Face face = sample_face(name);
    EXPECT_EQ(pose_face(face).vector, face.vector);
  }
}

}  // namespace
}  // namespace mien
