#include <mien/lib/face/face_model.h>
#include <mien/lib/file/face_file.h>
#include <mien/lib/rig/pose.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace mien {
namespace {

Face sample(const std::string& name) {
  const Expected<Face> face =
      read_face(std::string(MIEN_SOURCE_DIR "/faces/") + name + ".face.json");
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

std::vector<double> value(const Face& face, std::string_view name) {
  const int slice = face.model->layout.find(name);
  if (slice < 0) throw std::runtime_error("no slice " + std::string(name));
  const auto first = face.vector.begin() + face.model->layout[slice].begin;
  return {first, first + face.model->layout[slice].size};
}

Face posed(const Face& face, std::optional<double> time,
           std::initializer_list<const char*> settings) {
  Pose pose{.time = time, .settings = {}};
  for (const char* text : settings) {
    const Expected<Setting> setting = read_setting(face, text);
    if (!setting) throw std::runtime_error(sentence(setting.error()));
    pose.settings.push_back(*setting);
  }
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
    const Face face = sample(name);
    EXPECT_EQ(pose_face(face).vector, face.vector) << name;
    EXPECT_EQ(posed(face, {}, {}).vector, face.vector) << name;
  }
  const Face seed = sample("seed0");  // explicitly: gaze 0, dilation 1, eyes open
  EXPECT_EQ(posed(seed, {}, {"gaze.x=0", "gaze.y=0", "dilation=1", "blink=0"}).vector, seed.vector);
}

TEST(PoseFace, GazeFollowsTheSource_E8) {
  const Face seed = sample("seed0");
  for (double t = 0; t < 40; t += 0.173) {
    const Face now = posed(seed, t, {});
    EXPECT_NEAR(value(now, "pupil.right/center")[0], 0.23 + 0.08 * std::sin(1.4 * t), 1e-14) << t;
    EXPECT_NEAR(value(now, "pupil.right/center")[1], 0.19 + 0.07 * std::cos(0.6 * t), 1e-14) << t;
    EXPECT_NEAR(value(now, "pupil.left/center")[0], 0.76 + 0.08 * std::sin(1.4 * t), 1e-14) << t;
  }
}

TEST(PoseFace, DilationFollowsTheSource_E9) {
  const Face seed = sample("seed0");
  double least = 9, most = 0;
  for (double t = 0; t < 40; t += 0.0173) {
    const double dilation = std::abs(std::sin(0.2 * t + 1.4)) * 0.5 + 0.7;
    const std::vector<double> radii = value(posed(seed, t, {}), "pupil.left/radii");
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
  const Face seed = sample("seed0");
  for (double t = -8; t < 12; t += 0.00913) {
    const double shape = source_shape(t);
    const int k = std::min(2, int(shape));
    const Face now = posed(seed, t, {});
    for (int i = 0; i < 2; ++i) {
      const auto mixed = [&](double a, double b) { return a + (shape - k) * (b - a); };
      EXPECT_NEAR(value(now, "opening.left/lower")[i], mixed(kLower[k][i], kLower[k + 1][i]), 1e-13)
          << t;
      EXPECT_NEAR(value(now, "opening.right/upper")[i], mixed(kUpper[k][i], kUpper[k + 1][i]),
                  1e-13)
          << t;
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(value(now, "upper_lid.right/spine/" + std::to_string(j))[i],
                    mixed(kLid[k][j][i], kLid[k + 1][j][i]), 1e-13)
            << t;
    }
  }
}

TEST(PoseFace, StageBordersEqualTheTableExactly_E10) {
  const Face seed = sample("seed0");
  constexpr int kShape[8] = {0, 1, 2, 3, 3, 2, 1, 0};
  for (int stage = 0; stage < 8; ++stage) {
    const Face now = posed(seed, stage * 0.45 / 7, {});
    const int k = kShape[stage];
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(value(now, "opening.left/lower")[i], kLower[k][i]) << stage;
      EXPECT_EQ(value(now, "opening.left/upper")[i], kUpper[k][i]) << stage;
      for (int j = 0; j < 3; ++j) {
        EXPECT_EQ(value(now, "upper_lid.right/spine/" + std::to_string(j))[i], kLid[k][j][i])
            << stage;
        const double mirrored = i == 0 ? 1 - kLid[k][j][0] : kLid[k][j][1];
        EXPECT_EQ(value(now, "upper_lid.left/spine/" + std::to_string(j))[i], mirrored) << stage;
      }
    }
  }
}

TEST(PoseFace, ScleraStaysAsItIsWhileTheOpeningMoves_E4) {
  const Face seed = sample("seed0");
  const Face shut = posed(seed, {}, {"blink=1"});
  EXPECT_EQ(value(shut, "sclera.left/lower"), value(seed, "sclera.left/lower"));
  EXPECT_NE(value(shut, "opening.left/lower"), value(seed, "opening.left/lower"));
}

/// The source's fourth shape: at q = 0, its middle, the opening is no height at all; elsewhere it is crossed.
TEST(PoseFace, Shape3IsShutInTheMiddle_E4) {
  const Face seed = sample("seed0");
  const Face shut = posed(seed, {}, {"blink=1"});
  for (const char* side : {"left", "right"}) {
    const auto lower = value(shut, std::string("opening.") + side + "/lower"),
               upper = value(shut, std::string("opening.") + side + "/upper");
    EXPECT_EQ(upper[1] - lower[1], 0) << side;
    EXPECT_LT(upper[0], lower[0]) << "it falls below the lower lid beside the middle";
    const auto open = value(seed, std::string("opening.") + side + "/upper");
    EXPECT_EQ(open[1], 0.34);
  }
}

TEST(PoseFace, LeftIsMirroredAboutTheMiddleExceptWhereTheSourceShifts_E2) {
  const Face seed = sample("seed0");
  for (const char* part : {"upper_lid", "brow_low", "brow_high"})
    for (int j = 0; j < 3; ++j) {
      const auto right = value(seed, std::string(part) + ".right/spine/" + std::to_string(j));
      const auto left = value(seed, std::string(part) + ".left/spine/" + std::to_string(j));
      EXPECT_EQ(left[0], 1 - right[0]);
      EXPECT_EQ(left[1], right[1]);
    }
  EXPECT_EQ(value(seed, "pupil.left/center"), (std::vector<double>{0.76, 0.19}));
  const auto frame = value(seed, "opening.left/frame");
  for (double x = 0; x < 1; x += 0.1)
    EXPECT_NEAR(frame[0] * x + frame[1], 1.8 * (x - 0.53) - 0.42, 1e-15);
}

TEST(PoseFace, ToonIsItsOwnMirrorImageAtSymmetricPoses_E2) {
  const Face toon = sample("toon");
  for (const auto& now : {toon, posed(toon, {}, {"blink=0.37", "gaze.y=0.02", "dilation=1.2"}),
                          posed(toon, {}, {"blink=1"})})
    for (const Slice& slice : now.model->layout.slices()) {
      const std::size_t at = slice.name.find(".left/");
      if (at == std::string::npos) continue;
      std::vector<double> left = value(now, slice.name);
      mirror_values(slice.kind, left, now.model->canvas.twice_axis());
      EXPECT_EQ(left, value(now, slice.name.substr(0, at) + ".right/" + slice.name.substr(at + 6)))
          << slice.name;
    }
}

TEST(PoseFace, ToonsLidsMeetOnOneCurveAtBlink1) {
  const Face toon = sample("toon");
  for (const char* gaze : {"gaze.y=0", "gaze.y=0.06", "gaze.y=-0.06"}) {
    const Face shut = posed(toon, {}, {gaze, "blink=1"});
    EXPECT_EQ(value(shut, "opening.left/upper"), value(shut, "opening.left/lower"));
    EXPECT_EQ(value(shut, "opening.right/upper"), value(shut, "opening.right/lower"));
  }
}

TEST(PoseFace, ABlinkOnlyCloses) {
  const Face toon = sample("toon");
  double before = 9;
  for (int step = 0; step <= 100; ++step) {
    const std::string blink = "blink.left=" + std::to_string(step / 100.0);
    const Face now = posed(toon, {}, {blink.c_str()});
    const double gap = value(now, "opening.left/upper")[1] - value(now, "opening.left/lower")[1];
    EXPECT_LT(gap, before) << step;
    EXPECT_GE(gap, 0) << step;
    before = gap;
    EXPECT_EQ(value(now, "opening.right/upper"),
              value(toon, "opening.right/upper"));  // the other eye stays open
  }
  EXPECT_EQ(before, 0);
}

TEST(PoseFace, GazeMovesBothEyesTheSameWayAndDilationScales) {
  const Face toon = sample("toon");
  const Face now = posed(toon, {}, {"gaze.x=0.05", "gaze.left.y=0.01", "dilation.right=1.5"});
  EXPECT_EQ(value(now, "limbus.left/center")[0], value(toon, "limbus.left/center")[0] + 0.05);
  EXPECT_EQ(value(now, "limbus.right/center")[0], value(toon, "limbus.right/center")[0] + 0.05);
  EXPECT_EQ(value(now, "limbus.left/center")[1], value(toon, "limbus.left/center")[1] + 0.01);
  EXPECT_EQ(value(now, "limbus.right/center")[1], value(toon, "limbus.right/center")[1]);
  EXPECT_EQ(value(now, "pupil.left/radii"), value(toon, "pupil.left/radii"));
  EXPECT_EQ(value(now, "pupil.right/radii")[0], value(toon, "pupil.right/radii")[0] * 1.5);
}

TEST(PoseFace, SettingsBeatClipsAndLaterOnesEarlierOnes) {
  const Face seed = sample("seed0");
  const Face now = posed(seed, 1.0, {"gaze.x=0.01", "dilation=1"});
  EXPECT_EQ(value(now, "pupil.left/center")[0], 0.76 + 0.01);
  EXPECT_NEAR(value(now, "pupil.left/center")[1], 0.19 + 0.07 * std::cos(0.6),
              1e-15);  // not set: the clip's
  EXPECT_EQ(value(now, "pupil.left/radii")[0], 0.09);
  const Face later = posed(seed, {}, {"gaze.x=0.3", "gaze.left.x=0.2", "gaze.x=0.1"});
  EXPECT_EQ(value(later, "pupil.left/center")[0], 0.76 + 0.1);
  const Face point =
      posed(seed, 0.2, {"upper_lid.left/spine/1=0.5,0.25", "blink=1"});  // slices beat key shapes
  EXPECT_EQ(value(point, "upper_lid.left/spine/1"), (std::vector<double>{0.5, 0.25}));
}

TEST(PoseFace, IsTotal) {
  const Face seed = sample("seed0");
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
    for (const double number : value(now, slice.name)) {
      EXPECT_LE(std::abs(number), 1e9);
      EXPECT_GE(number, slice.lo);
      EXPECT_LE(number, slice.hi);
    }
}

TEST(SettableNames, AllGoThereAndBack) {
  for (const char* name : {"seed0", "toon", "male"}) {
    const Face face = sample(name);
    bool slices_begun = false;
    for (const SettableName& settable : settable_names(face)) {
      slices_begun |= !settable.control;
      EXPECT_EQ(settable.control, !slices_begun) << "controls first";
      EXPECT_FALSE(settable.unit.empty()) << settable.name;
      std::string text = settable.name + "=";
      for (std::size_t i = 0; i < settable.value.size(); ++i) {
        char number[40];
        std::snprintf(number, sizeof number, "%s%.17g", i ? "," : "", settable.value[i]);
        text += number;
      }
      const Expected<Setting> setting = read_setting(face, text);
      ASSERT_TRUE(setting) << sentence(setting.error());
      EXPECT_EQ(setting->values, settable.value);
      EXPECT_EQ(pose_face(face, {.settings = {*setting}}).vector, face.vector) << text;
    }
  }
}

TEST(SettableNames, HaveTheControlsOfBothSidesAndOfEach) {
  for (const char* name : {"seed0", "toon"}) {
    std::vector<std::string> controls;
    const Face face = sample(name);
    for (const SettableName& settable : settable_names(face))
      if (settable.control && !settable.pose && settable.unit != "strength")  // of an expression
        controls.push_back(settable.name);
    std::vector<std::string> wanted{
        "gaze.x",   "gaze.left.x",   "gaze.right.x",   "gaze.y", "gaze.left.y", "gaze.right.y",
        "dilation", "dilation.left", "dilation.right", "blink",  "blink.left",  "blink.right"};
    if (name == std::string("toon"))
      wanted.insert(wanted.end(), {"bias", "bias.left", "bias.right", "yaw", "pitch", "roll"});
    EXPECT_EQ(controls, wanted);
  }
}

TEST(ReadSetting, TakesColoursAndSingleNumbers) {
  const Face seed = sample("seed0");
  EXPECT_EQ(value(posed(seed, {}, {"palette/skin=#ffffff"}), "palette/skin"),
            (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(value(posed(seed, {}, {"palette/skin=0.25,0.5,1"}), "palette/skin"),
            (std::vector<double>{0.25, 0.5, 1, 1}));
  EXPECT_EQ(value(posed(seed, {}, {"palette/skin=0.25,0.5,1,0"}), "palette/skin"),
            (std::vector<double>{0.25, 0.5, 1, 0}));
  EXPECT_EQ(value(posed(seed, {}, {"palette/white/a=0.5"}), "palette/white"),
            (std::vector<double>{1, 1, 1, 0.5}));
  EXPECT_EQ(value(posed(seed, {}, {"pupil.left/center/y=+.25"}), "pupil.left/center"),
            (std::vector<double>{0.76, 0.25}));
}

TEST(ReadSetting, RefusesInASentence) {
  const Face seed = sample("seed0");
  const std::pair<const char*, const char*> table[] = {
      {"gaze.z=1", "gaze.z=1: no control or number named \"gaze.z\"; did you mean \"gaze.x\"?"},
      {"pupil.left/centre=1,2",
       "pupil.left/centre=1,2: no control or number named \"pupil.left/centre\"; did you mean "
       "\"pupil.left/center\"?"},
      {"blink", "blink: expected NAME=VALUE"},
      {"", ": expected NAME=VALUE"},
      {"blink=", "blink=: expected a number, got \"\""},
      {"blink=1x", "blink=1x: expected a number, got \"1x\""},
      {"blink=nan", "blink=nan: expected a finite number, got \"nan\""},
      {"blink=inf", "blink=inf: expected a finite number, got \"inf\""},
      {"pupil.left/center=1e999,0",
       "pupil.left/center=1e999,0: \"1e999\" is too large or too small for a number"},
      {"blink=2", "blink=2: \"blink\" goes from 0 to 1, got 2"},
      {"blink=0,1", "blink=0,1: expected 1 number, got 2"},
      {"pupil.left/center=1", "pupil.left/center=1: expected 2 numbers, got 1"},
      {"upper_lid.left/half_width=-1",
       "upper_lid.left/half_width=-1: \"upper_lid.left/half_width\" goes from 0 to 1000000000, got "
       "-1"},
      {"pupil.left/center=2e9,0",
       "pupil.left/center=2e9,0: \"pupil.left/center\" goes from -1000000000 to 1000000000, got "
       "2000000000"},
      {"palette/skin=#12345",
       "palette/skin=#12345: expected a colour like #rrggbb, got \"#12345\""},
      {"blink=#ffffff", "blink=#ffffff: expected a number, got \"#ffffff\""},
  };
  for (const auto& [text, expected] : table) {
    const Expected<Setting> setting = read_setting(seed, text);
    ASSERT_FALSE(setting) << text;
    const std::string said = sentence(setting.error());
    EXPECT_EQ(said, *text ? expected : expected + 2) << text;
  }
}

std::vector<std::string> poses_named(const Face& face, std::string_view begin) {
  std::vector<std::string> names;
  for (const SettableName& name : settable_names(face))
    if (name.pose && name.name.starts_with(begin) && face.model->layout.slices().size() > 0 &&
        std::count(name.name.begin(), name.name.end(), '.') == 1)
      names.push_back(name.name);
  return names;
}

TEST(Poses, AreEightLidShapesAndEightBrowShapesAtLeast_E11_E14) {
  for (const char* name : {"toon", "seed0"}) {
    const Face face = sample(name);
    for (const char* kind : {"lid.", "brow."}) {
      const std::vector<std::string> names = poses_named(face, kind);
      EXPECT_GE(names.size(), 8u) << name;
      for (const std::string& one : names)  // all differ, and by more than a rounding
        for (const std::string& two : names) {
          const Face a = posed(face, {}, {(one + "=1").c_str()}),
                     b = posed(face, {}, {(two + "=1").c_str()});
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
  const Face toon = sample("toon");
  const Face angry = posed(toon, {}, {"brow.angry=1"});
  EXPECT_EQ(value(angry, "brow.left/spine/0"), (std::vector<double>{0.082, 0.196}));
  EXPECT_EQ(value(angry, "brow.right/spine/0"), (std::vector<double>{-0.082, 0.196}));
  EXPECT_EQ(value(angry, "brow.left/half_width"), (std::vector<double>{0.018, 0.044, 0.004}));
  for (const std::string& name : poses_named(toon, ""))
    EXPECT_EQ(posed(toon, {}, {(name + "=0").c_str()}).vector, toon.vector);
}

/// Any pair tweens: weights 1 − u and u lie on the straight line between the two shapes. Lids do so
/// as long as the lines do not cross (a lid's own law keeps them from it).
TEST(Poses, TweenInAnyPair_E11_E14) {
  for (const char* name : {"toon", "seed0"}) {
    const Face face = sample(name);
    const std::vector<std::string> names = poses_named(face, "brow.");
    for (const std::string& one : names)
      for (const std::string& two : names) {
        if (one == two) continue;
        const Face a = posed(face, {}, {(one + "=1").c_str()}),
                   b = posed(face, {}, {(two + "=1").c_str()});
        const Face half = posed(face, {}, {(one + "=0.75").c_str(), (two + "=0.25").c_str()});
        for (std::size_t i = 0; i < half.vector.size(); ++i)
          EXPECT_NEAR(half.vector[i], 0.75 * a.vector[i] + 0.25 * b.vector[i], 1e-15) << one << two;
      }
  }
}

TEST(Poses, OfTheLidsTweenInAnyPair_E14) {
  const Face toon = sample("toon");
  const std::vector<std::string> names = poses_named(toon, "lid.");
  for (const std::string& one : names)
    for (const std::string& two : names) {
      if (one == two) continue;
      const Face a = posed(toon, {}, {(one + "=1").c_str()}),
                 b = posed(toon, {}, {(two + "=1").c_str()});
      const Face half = posed(toon, {}, {(one + "=0.5").c_str(), (two + "=0.5").c_str()});
      for (const char* part : {"opening.left/upper", "opening.left/lower", "opening.right/upper"})
        for (int i = 0; i < 2; ++i)
          EXPECT_NEAR(value(half, part)[i], 0.5 * (value(a, part)[i] + value(b, part)[i]), 1e-15)
              << one << two;
    }
}

TEST(Poses, LeftAndRightAreIndependent_E11) {
  const Face toon = sample("toon");
  const Face one = posed(toon, {}, {"brow.left.sly=1", "brow.right.sad=0.5", "lid.right.sleepy=1"});
  EXPECT_EQ(value(one, "brow.left/spine/1"),
            value(posed(toon, {}, {"brow.sly=1"}), "brow.left/spine/1"));
  EXPECT_EQ(value(one, "brow.right/spine/1"),
            value(posed(toon, {}, {"brow.sad=0.5"}), "brow.right/spine/1"));
  EXPECT_EQ(value(one, "opening.left/upper"), value(toon, "opening.left/upper"));
  EXPECT_NE(value(one, "opening.right/upper"), value(toon, "opening.right/upper"));
}

constexpr const char* kPosable = R"({"format": "mien-face", "format_version": 1,
  "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"ink": "#000000"}, "background": "ink",
  "features": [{"name": "dot", "kind": "disc", "side": "left", "paint": "ink", "center": [0.5, 0.1], "radius": 0.1}],
  "controls": [{"name": "look", "range": [-1, 1], "rest": 0, "per_side": true, "offset": {"dot/center": [0, 1]}}],
  "poses": {
    "up": {"slices": {"dot/center": [0.5, 0.3]}},
    "big": {"per_side": true, "range": [-1, 2], "by": {"dot/radius": [0.05]}, "controls": {"look": 0.4}}},
  "clips": {
    "swing": {"look": {"keys": [[0, 0], [1, 1]]}},
    "hold": {"look": {"keys": [[0, 0.5]]}, "up": {"keys": [[0, 1]]}},
    "more": {"additive": true, "tracks": {"look": {"keys": [[0, 0.1], [1, 0.2]]}}}}})";

Face posable() {
  return *read_face_text(kPosable);
}

TEST(Poses, MoveControlsToo) {
  const Face face = posable();
  const Face big = posed(face, {}, {"big=0.5", "look=0.1"});
  EXPECT_NEAR(value(big, "dot.left/radius")[0], 0.125, 1e-15);
  EXPECT_NEAR(value(posed(face, {}, {"big=0.5"}), "dot.left/center")[1], 0.1 + 0.2, 1e-15);
  EXPECT_NEAR(value(big, "dot.left/center")[1], 0.1 + 0.1, 1e-15);  // a setting holds
  const Face left = posed(face, {}, {"big.left=1"});
  EXPECT_NEAR(value(left, "dot.left/center")[1], 0.5, 1e-15);
  EXPECT_EQ(value(left, "dot.right/center"), value(face, "dot.right/center"));
  EXPECT_NEAR(value(posed(face, {}, {"big=-1"}), "dot.left/radius")[0], 0.05, 1e-15);
}

double looks(const Face& face, const Pose& pose) {
  return value(pose_face(face, pose), "dot.left/center")[1] - 0.1;
}

TEST(Clips, AreLaidOverEachOther) {
  const Face face = posable();
  const auto layer = [&](const char* text) {
    const Expected<ClipLayer> read = read_clip_layer(face, text);
    if (!read) throw std::runtime_error(sentence(read.error()));
    return *read;
  };
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("swing")}}), 0.25, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("swing=0.5")}}), 0.125, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("swing=1@0.15")}}), 0.1, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("more")}}), 0.125, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("swing"), layer("more")}}), 0.375, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .clips = {layer("swing"), layer("more=2")}}), 0.5, 1e-15);
  const double mixed = looks(face, {.time = 0.25, .clips = {layer("swing"), layer("hold=0.4")}});
  EXPECT_NEAR(mixed, 0.6 * 0.25 + 0.4 * 0.5 + 0.4 * 0.2, 1e-15);  // "hold" moves the pose "up" too
  EXPECT_EQ(looks(face, {.clips = {layer("swing")}}), 0) << "no time, no clip";
  EXPECT_EQ(looks(face, {.time = 0.5}), 0) << "no default clip";
}

TEST(Clips, OfIdleLifeAreTheSameAgain) {
  const Face toon = sample("toon");
  int blinks = 0, looks_aside = 0;
  bool shut = false;
  for (int frame = 0; frame < 60 * 60; ++frame) {
    const Face now = posed(toon, frame / 60.0, {});
    const double gap = value(now, "opening.left/upper")[1] - value(now, "opening.left/lower")[1];
    blinks += gap < 0.1 && !shut;
    shut = gap < 0.1;
    looks_aside +=
        std::abs(value(now, "limbus.left/center")[0] - value(toon, "limbus.left/center")[0]) > 0.01;
  }
  EXPECT_GE(blinks, 12);  // people blink 12 to 20 times a minute
  EXPECT_LE(blinks, 20);
  EXPECT_GT(looks_aside, 600);
  EXPECT_EQ(posed(toon, 17.3, {}).vector, posed(toon, 17.3, {}).vector);
}

std::string said(const auto& read) {
  return read ? "read" : sentence(read.error());
}

TEST(Names, ThatAreUnknownGetTheNearest) {
  const Face toon = sample("toon");
  EXPECT_EQ(said(read_pose(toon, "brow.angyr=1")),
            "brow.angyr=1: no pose named \"brow.angyr\"; did you mean \"brow.angry\"?");
  EXPECT_EQ(said(read_pose(toon, "blink=1")), "blink=1: no pose named \"blink\"");
  EXPECT_EQ(said(read_pose(toon, "brow.angry=1.5")),
            "brow.angry=1.5: \"brow.angry\" goes from 0 to 1, got 1.5");
  EXPECT_EQ(said(read_clip_layer(toon, "idel")),
            "idel: no clip named \"idel\"; did you mean \"idle\"?");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=x")), "idle=x: expected a number, got \"x\"");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=1@")), "idle=1@: expected a number, got \"\"");
  EXPECT_EQ(said(read_clip_layer(toon, "idle=1@2,3")),
            "idle=1@2,3: expected a number, got \"2,3\"");
  EXPECT_EQ(said(read_look_at(toon, "1,2")), "1,2: expected 3 numbers X,Y,Z, got 2");
  EXPECT_EQ(said(read_look_at(sample("male"), "1,2,3")),
            "1,2,3: this face has no eyes that look: its file says none under \"eyes\"");
  EXPECT_EQ(read_pose(toon, "lid.sad")->values, (std::vector<double>{1}));
}

}  // namespace
}  // namespace mien
