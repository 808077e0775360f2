#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::poses_named;
using test::sample_face;
using test::slice_of;

Face posed(const Face& face, std::optional<double> time, const std::vector<std::string>& settings) {
  Pose pose = test::pose_of(face, settings);
  pose.time = time;
  return pose_face(face, pose);
}

/// The blink of the source at a time: which shape, 0 … 3 (E10).
double source_shape(double t) {
  const double whole = std::floor(t), part = t - whole;
  if (std::fmod(whole, 4) != 0 || part > 0.45) return 0;
  const double stage = part / (0.45 / 7);
  return stage <= 3 ? stage : stage <= 4 ? 3 : 7 - stage;
}

TEST(PoseFace, WithoutATimeRests_G11) {
  for (const char* name : {"seed0", "toon", "male"}) {
    const Face face = sample_face(name);
    EXPECT_EQ(pose_face(face).vector, face.vector) << name;
    EXPECT_EQ(posed(face, {}, {}).vector, face.vector) << name;
  }
  const Face seed = sample_face("seed0");  // explicitly: gaze 0, dilation 1, eyes open
  EXPECT_EQ(posed(seed, {}, {"gaze.x=0", "gaze.y=0", "dilation=1", "blink=0"}).vector, seed.vector);
}

TEST(PoseFace, GazeFollowsTheSource_E8) {
  const Face seed = sample_face("seed0");
  for (double t = 0; t < 40; t += 0.173) {
    const Face now = posed(seed, t, {});
    EXPECT_NEAR(slice_of(now, "pupil.right/center")[0], 0.23 + 0.08 * std::sin(1.4 * t), 1e-14)
        << t;
    EXPECT_NEAR(slice_of(now, "pupil.right/center")[1], 0.19 + 0.07 * std::cos(0.6 * t), 1e-14)
        << t;
    EXPECT_NEAR(slice_of(now, "pupil.left/center")[0], 0.76 + 0.08 * std::sin(1.4 * t), 1e-14) << t;
  }
}

TEST(PoseFace, DilationFollowsTheSource_E9) {
  const Face seed = sample_face("seed0");
  double least = 9, most = 0;
  for (double t = 0; t < 40; t += 0.0173) {
    const double dilation = std::abs(std::sin(0.2 * t + 1.4)) * 0.5 + 0.7;
    const std::vector<double> radii = slice_of(posed(seed, t, {}), "pupil.left/radii");
    EXPECT_NEAR(radii[0], 0.09 * dilation, 1e-15) << t;
    EXPECT_NEAR(radii[1], 0.105 * dilation, 1e-15) << t;
    least = std::min(least, radii[0] / 0.09), most = std::max(most, radii[0] / 0.09);
  }
  EXPECT_NEAR(least, 0.7, 2e-3);
  EXPECT_NEAR(most, 1.2, 1e-5);
}

constexpr double kLower[4][2] = {{0.9, 0.04}, {0.7, 0.06}, {0.5, 0.10}, {0.3, 0.20}};  // E4
constexpr double kUpper[4][2] = {{-1, 0.34}, {-0.7, 0.30}, {-0.4, 0.24}, {-0.1, 0.20}};
constexpr double kLid[4][3][2] = {{{.01, .19}, {.26, .50}, {.47, .15}},  // E5
                                  {{.01, .19}, {.30, .44}, {.47, .15}},
                                  {{.01, .19}, {.30, .32}, {.47, .15}},
                                  {{.01, .19}, {.30, .23}, {.47, .17}}};

TEST(PoseFace, BlinkFollowsTheSource_E10) {
  const Face seed = sample_face("seed0");
  for (double t = -8; t < 12; t += 0.00913) {
    const double shape = source_shape(t);
    const int k = std::min(2, int(shape));
    const Face now = posed(seed, t, {});
    for (int i = 0; i < 2; ++i) {
      const auto mixed = [&](double a, double b) { return a + (shape - k) * (b - a); };
      EXPECT_NEAR(slice_of(now, "opening.left/lower")[i], mixed(kLower[k][i], kLower[k + 1][i]),
                  1e-13)
          << t;
      EXPECT_NEAR(slice_of(now, "opening.right/upper")[i], mixed(kUpper[k][i], kUpper[k + 1][i]),
                  1e-13)
          << t;
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(slice_of(now, "upper_lid.right/spine/" + std::to_string(j))[i],
                    mixed(kLid[k][j][i], kLid[k + 1][j][i]), 1e-13)
            << t;
    }
  }
}

TEST(PoseFace, StageBordersEqualTheTableExactly_E10) {
  const Face seed = sample_face("seed0");
  constexpr int kShape[8] = {0, 1, 2, 3, 3, 2, 1, 0};
  for (int stage = 0; stage < 8; ++stage) {
    const Face now = posed(seed, stage * 0.45 / 7, {});
    const int k = kShape[stage];
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(slice_of(now, "opening.left/lower")[i], kLower[k][i]) << stage;
      EXPECT_EQ(slice_of(now, "opening.left/upper")[i], kUpper[k][i]) << stage;
      for (int j = 0; j < 3; ++j) {
        EXPECT_EQ(slice_of(now, "upper_lid.right/spine/" + std::to_string(j))[i], kLid[k][j][i])
            << stage;
        const double mirrored = i == 0 ? 1 - kLid[k][j][0] : kLid[k][j][1];
        EXPECT_EQ(slice_of(now, "upper_lid.left/spine/" + std::to_string(j))[i], mirrored) << stage;
      }
    }
  }
}

TEST(PoseFace, ScleraStaysAsItIsWhileTheOpeningMoves_E4) {
  const Face seed = sample_face("seed0");
  const Face shut = posed(seed, {}, {"blink=1"});
  EXPECT_EQ(slice_of(shut, "sclera.left/lower"), slice_of(seed, "sclera.left/lower"));
  EXPECT_NE(slice_of(shut, "opening.left/lower"), slice_of(seed, "opening.left/lower"));
}

/// The source's fourth shape: at q = 0, its middle, the opening is no height at all; elsewhere it is crossed.
TEST(PoseFace, Shape3IsShutInTheMiddle_E4) {
  const Face seed = sample_face("seed0");
  const Face shut = posed(seed, {}, {"blink=1"});
  for (const char* side : {"left", "right"}) {
    const auto lower = slice_of(shut, std::string("opening.") + side + "/lower"),
               upper = slice_of(shut, std::string("opening.") + side + "/upper");
    EXPECT_EQ(upper[1] - lower[1], 0) << side;
    EXPECT_LT(upper[0], lower[0]) << "it falls below the lower lid beside the middle";
    const auto open = slice_of(seed, std::string("opening.") + side + "/upper");
    EXPECT_EQ(open[1], 0.34);
  }
}

TEST(PoseFace, LeftIsMirroredAboutTheMiddleExceptWhereTheSourceShifts_E2) {
  const Face seed = sample_face("seed0");
  for (const char* part : {"upper_lid", "brow_low", "brow_high"})
    for (int j = 0; j < 3; ++j) {
      const auto right = slice_of(seed, std::string(part) + ".right/spine/" + std::to_string(j));
      const auto left = slice_of(seed, std::string(part) + ".left/spine/" + std::to_string(j));
      EXPECT_EQ(left[0], 1 - right[0]);
      EXPECT_EQ(left[1], right[1]);
    }
  EXPECT_EQ(slice_of(seed, "pupil.left/center"), (std::vector<double>{0.76, 0.19}));
  const auto frame = slice_of(seed, "opening.left/frame");
  for (double x = 0; x < 1; x += 0.1)
    EXPECT_NEAR(frame[0] * x + frame[1], 1.8 * (x - 0.53) - 0.42, 1e-15);
}

TEST(PoseFace, ToonIsItsOwnMirrorImageAtSymmetricPoses_E2) {
  const Face toon = sample_face("toon");
  for (const auto& now : {toon, posed(toon, {}, {"blink=0.37", "gaze.y=0.02", "dilation=1.2"}),
                          posed(toon, {}, {"blink=1"})})
    for (const Slice& slice : now.model->layout.slices()) {
      const std::size_t at = slice.name.find(".left/");
      if (at == std::string::npos) continue;
      std::vector<double> left = slice_of(now, slice.name);
      mirror_values(slice.kind, left, now.model->canvas.twice_axis());
      EXPECT_EQ(left, slice_of(now, fmt::format("{}.right/{}", slice.name.substr(0, at),
                                                slice.name.substr(at + 6))))
          << slice.name;
    }
}

TEST(PoseFace, ToonsLidsMeetOnOneCurveAtBlink1) {
  const Face toon = sample_face("toon");
  for (const char* gaze : {"gaze.y=0", "gaze.y=0.06", "gaze.y=-0.06"}) {
    const Face shut = posed(toon, {}, {gaze, "blink=1"});
    EXPECT_EQ(slice_of(shut, "opening.left/upper"), slice_of(shut, "opening.left/lower"));
    EXPECT_EQ(slice_of(shut, "opening.right/upper"), slice_of(shut, "opening.right/lower"));
  }
}

TEST(PoseFace, ABlinkOnlyCloses) {
  const Face toon = sample_face("toon");
  double before = 9;
  for (int step = 0; step <= 100; ++step) {
    const std::string blink = "blink.left=" + std::to_string(step / 100.0);
    const Face now = posed(toon, {}, {blink});
    const double gap =
        slice_of(now, "opening.left/upper")[1] - slice_of(now, "opening.left/lower")[1];
    EXPECT_LT(gap, before) << step;
    EXPECT_GE(gap, 0) << step;
    before = gap;
    EXPECT_EQ(slice_of(now, "opening.right/upper"),
              slice_of(toon, "opening.right/upper"));  // the other eye stays open
  }
  EXPECT_EQ(before, 0);
}

TEST(PoseFace, GazeMovesBothEyesTheSameWayAndDilationScales) {
  const Face toon = sample_face("toon");
  const Face now = posed(toon, {}, {"gaze.x=0.05", "gaze.left.y=0.01", "dilation.right=1.5"});
  EXPECT_EQ(slice_of(now, "limbus.left/center")[0], slice_of(toon, "limbus.left/center")[0] + 0.05);
  EXPECT_EQ(slice_of(now, "limbus.right/center")[0],
            slice_of(toon, "limbus.right/center")[0] + 0.05);
  EXPECT_EQ(slice_of(now, "limbus.left/center")[1], slice_of(toon, "limbus.left/center")[1] + 0.01);
  EXPECT_EQ(slice_of(now, "limbus.right/center")[1], slice_of(toon, "limbus.right/center")[1]);
  EXPECT_EQ(slice_of(now, "pupil.left/radii"), slice_of(toon, "pupil.left/radii"));
  EXPECT_EQ(slice_of(now, "pupil.right/radii")[0], slice_of(toon, "pupil.right/radii")[0] * 1.5);
}

TEST(PoseFace, SettingsBeatClipsAndLaterOnesEarlierOnes) {
  const Face seed = sample_face("seed0");
  const Face now = posed(seed, 1.0, {"gaze.x=0.01", "dilation=1"});
  EXPECT_EQ(slice_of(now, "pupil.left/center")[0], 0.76 + 0.01);
  EXPECT_NEAR(slice_of(now, "pupil.left/center")[1], 0.19 + 0.07 * std::cos(0.6),
              1e-15);  // not set: the clip's
  EXPECT_EQ(slice_of(now, "pupil.left/radii")[0], 0.09);
  const Face later = posed(seed, {}, {"gaze.x=0.3", "gaze.left.x=0.2", "gaze.x=0.1"});
  EXPECT_EQ(slice_of(later, "pupil.left/center")[0], 0.76 + 0.1);
  const Face point =
      posed(seed, 0.2, {"upper_lid.left/spine/1=0.5,0.25", "blink=1"});  // slices beat key shapes
  EXPECT_EQ(slice_of(point, "upper_lid.left/spine/1"), (std::vector<double>{0.5, 0.25}));
}

TEST(PoseFace, IsTotal) {
  const Face seed = sample_face("seed0");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  for (const double time : {kNan, kInf, -kInf})
    EXPECT_EQ(posed(seed, time, {}).vector, seed.vector);
  for (const double time : {1e300, -1e300, 1e-300})
    for (const double number : posed(seed, time, {}).vector) EXPECT_TRUE(std::isfinite(number));
  Pose wild;
  for (int i = -2; i < int(seed.vector.size()) + 2; ++i)
    for (const double number : {kNan, kInf, -kInf, 1e300, -1.0}) {
      wild.settings.push_back({false, i, {number, number, number}});
      wild.settings.push_back({true, i, {number}});
    }
  wild.settings.push_back({true, 0, {}});
  const Face now = pose_face(seed, wild);
  for (const Slice& slice : seed.model->layout.slices())
    for (const double number : slice_of(now, slice.name)) {
      EXPECT_LE(std::abs(number), 1e9);
      EXPECT_GE(number, slice.range().lo);
      EXPECT_LE(number, slice.range().hi);
    }
}

TEST(Poses, AreEightLidShapesAndEightBrowShapesAtLeast_E11_E14) {
  for (const char* name : {"toon", "seed0"}) {
    const Face face = sample_face(name);
    for (const char* kind : {"lid.", "brow."}) {
      const std::vector<std::string> names = poses_named(face, kind);
      EXPECT_GE(names.size(), 8u) << name;
      for (const std::string& one : names)  // all differ, and by more than a rounding
        for (const std::string& two : names) {
          const Face a = posed(face, {}, {one + "=1"}), b = posed(face, {}, {two + "=1"});
          double most = 0;
          for (std::size_t i = 0; i < a.vector.size(); ++i)
            most = std::max(most, std::abs(a.vector[i] - b.vector[i]));
          EXPECT_EQ(most > 0.01, one != two) << one << " " << two;
        }
    }
  }
}

/// A weight of 1 is the shape in the file, bit for bit; a weight of 0 the face at rest.
TEST(Poses, AreTheirShapesExactly_E11) {
  const Face toon = sample_face("toon");
  const Face angry = posed(toon, {}, {"brow.angry=1"});
  EXPECT_EQ(slice_of(angry, "brow.left/spine/0"), (std::vector<double>{0.082, 0.196}));
  EXPECT_EQ(slice_of(angry, "brow.right/spine/0"), (std::vector<double>{-0.082, 0.196}));
  EXPECT_EQ(slice_of(angry, "brow.left/half_width"), (std::vector<double>{0.018, 0.044, 0.004}));
  for (const std::string& name : poses_named(toon, ""))
    EXPECT_EQ(posed(toon, {}, {name + "=0"}).vector, toon.vector);
}

/// Any pair tweens: weights 1 − u and u lie on the straight line between the two shapes. Lids do so
/// as long as the lines do not cross (a lid's own law keeps them from it).
TEST(Poses, TweenInAnyPair_E11_E14) {
  for (const char* name : {"toon", "seed0"}) {
    const Face face = sample_face(name);
    const std::vector<std::string> names = poses_named(face, "brow.");
    for (const std::string& one : names)
      for (const std::string& two : names) {
        if (one == two) continue;
        const Face a = posed(face, {}, {one + "=1"}), b = posed(face, {}, {two + "=1"});
        const Face half = posed(face, {}, {one + "=0.75", two + "=0.25"});
        for (std::size_t i = 0; i < half.vector.size(); ++i)
          EXPECT_NEAR(half.vector[i], 0.75 * a.vector[i] + 0.25 * b.vector[i], 1e-15) << one << two;
      }
  }
}

TEST(Poses, OfTheLidsTweenInAnyPair_E14) {
  const Face toon = sample_face("toon");
  const std::vector<std::string> names = poses_named(toon, "lid.");
  for (const std::string& one : names)
    for (const std::string& two : names) {
      if (one == two) continue;
      const Face a = posed(toon, {}, {one + "=1"}), b = posed(toon, {}, {two + "=1"});
      const Face half = posed(toon, {}, {one + "=0.5", two + "=0.5"});
      for (const char* part : {"opening.left/upper", "opening.left/lower", "opening.right/upper"})
        for (int i = 0; i < 2; ++i)
          EXPECT_NEAR(slice_of(half, part)[i], 0.5 * (slice_of(a, part)[i] + slice_of(b, part)[i]),
                      1e-15)
              << one << two;
    }
}

TEST(Poses, LeftAndRightAreIndependent_E11) {
  const Face toon = sample_face("toon");
  const Face one = posed(toon, {}, {"brow.left.sly=1", "brow.right.sad=0.5", "lid.right.sleepy=1"});
  EXPECT_EQ(slice_of(one, "brow.left/spine/1"),
            slice_of(posed(toon, {}, {"brow.sly=1"}), "brow.left/spine/1"));
  EXPECT_EQ(slice_of(one, "brow.right/spine/1"),
            slice_of(posed(toon, {}, {"brow.sad=0.5"}), "brow.right/spine/1"));
  EXPECT_EQ(slice_of(one, "opening.left/upper"), slice_of(toon, "opening.left/upper"));
  EXPECT_NE(slice_of(one, "opening.right/upper"), slice_of(toon, "opening.right/upper"));
}

constexpr const char* kPosable = R"({"format": "mien-face", "format_version": 1,
  "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"ink": "#000000"}, "background": "ink",
  "features": [{"name": "dot", "kind": "disc", "side": "left", "paint": "ink", "center": [0.5, 0.1], "radius": 0.1}],
  "controls": [{"name": "look", "range": [-1, 1], "rest": 0, "per_side": true, "offset": {"dot/center": [0, 1]}}],
  "poses": {
    "up": {"slices": {"dot/center": [0.5, 0.3]}},
    "big": {"per_side": true, "range": [-1, 2], "by": {"dot/radius": [0.05]}, "controls": {"look": 0.4}}}})";

Face posable() {
  return *read_face_text(kPosable);
}

TEST(Poses, MoveControlsToo) {
  const Face face = posable();
  const Face big = posed(face, {}, {"big=0.5", "look=0.1"});
  EXPECT_NEAR(slice_of(big, "dot.left/radius")[0], 0.125, 1e-15);
  EXPECT_NEAR(slice_of(posed(face, {}, {"big=0.5"}), "dot.left/center")[1], 0.1 + 0.2, 1e-15);
  EXPECT_NEAR(slice_of(big, "dot.left/center")[1], 0.1 + 0.1, 1e-15);  // a setting holds
  const Face left = posed(face, {}, {"big.left=1"});
  EXPECT_NEAR(slice_of(left, "dot.left/center")[1], 0.5, 1e-15);
  EXPECT_EQ(slice_of(left, "dot.right/center"), slice_of(face, "dot.right/center"));
  EXPECT_NEAR(slice_of(posed(face, {}, {"big=-1"}), "dot.left/radius")[0], 0.05, 1e-15);
}

// A face with a mood: at rest it is what its numbers are at that emotion, and everything else begins from its numbers.

Face male_in(const std::string& mood) {
  std::string text = test::text_of_face("male");
  text.insert(text.rfind('}'), ", \"mood\": " + mood);
  const Expected<Face> face = read_face_text(text);
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

void expect_near(const FaceVector& a, const FaceVector& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-11) << i;
}

TEST(Mood, IsTheFaceAtRest) {
  const Face plain = sample_face("male"), glad = male_in(R"({"joy": 0.4})");
  EXPECT_EQ(glad.vector, posed(plain, {}, {"emotion.joy=0.4"}).vector);
  EXPECT_EQ(pose_face(glad).vector, glad.vector);
  EXPECT_EQ(posed(glad, {}, {"emotion.joy=0.4"}).vector, glad.vector);
  EXPECT_EQ(male_in(R"({"joy": 0})").vector, plain.vector);
}

TEST(Mood, GivesWayToWhatIsSet) {
  const Face plain = sample_face("male"), glad = male_in(R"({"joy": 0.4})");
  for (const std::string set : {"emotion.joy=0", "emotion.joy=1", "emotion.sadness=0.5"})
    expect_near(posed(glad, {}, {set}).vector, posed(plain, {}, {set}).vector);
  expect_near(posed(glad, {}, {"emotion.sadness=0.25"}).vector,
              posed(plain, {}, {"emotion.sadness=0.25", "emotion.joy=0.2"}).vector);
  expect_near(posed(glad, {}, {"emotion.left.joy=0"}).vector,
              posed(plain, {}, {"emotion.right.joy=0.4"}).vector);
}

TEST(Mood, KeepsNumbersThatWereChangedAtRest) {
  const Face plain = sample_face("male");
  Face glad = male_in(R"({"joy": 0.4})");
  const int brow = glad.model->layout.find("eyebrow.left/points/0");
  ASSERT_GE(brow, 0);
  const auto moved = std::size_t(glad.model->layout[brow].begin);
  glad.vector[moved] += 0.125;
  EXPECT_EQ(pose_face(glad).vector, glad.vector);
  EXPECT_NEAR(posed(glad, {}, {"emotion.joy=0"}).vector[moved], plain.vector[moved] + 0.125, 1e-12);
}

}  // namespace
}  // namespace mien
