#include "lib/rig/muscle/muscle_poser.h"

#include <mien/face_model.h>

#include <gtest/gtest.h>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

double number_of(const Face& face, const std::string& slice, int component = 0) {
  const int found = face.model->layout.find(slice);
  if (found < 0) throw std::runtime_error("no " + slice);
  return face.vector[std::size_t(face.model->layout[found].begin + component)];
}

Face face_from(const std::string& muscles) {
  const Expected<Face> face = read_face_text(R"({"format": "mien-face", "format_version": 1,
"canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"skin": "#f7db9c"}, "background": "skin",
"features": [
  {"name": "brow", "kind": "stroke", "side": "left", "paint": "skin", "spine": [[0.1, 0.3], [0.3, 0.4], [0.5, 0.3]], "half_width": [0.01, 0.02, 0.01]},
  {"name": "mouth", "kind": "stroke", "paint": "skin", "spine": [[-0.2, -0.4], [0, -0.4], [0.2, -0.4]], "half_width": 0.01},
  {"name": "iris", "kind": "ellipse", "side": "left", "paint": "skin", "center": [0.3, 0], "radii": [0.1, 0.2], "tilt": 10}],
"muscles": {"stiffness": 20, "damping": 8, "groups": [)" +
                                             muscles + "]}}");
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

TEST(MusclePose, AtRestTheFaceIsAsItIsWritten) {  // M1
  const Face face = test::face_named("male");
  EXPECT_EQ(pose_face(face).vector, face.vector);
  EXPECT_EQ(test::posed(face, {"emotion.joy=0", "muscle.jaw=0"}).vector, face.vector);
}

TEST(MusclePose, TheEyesRingMuscleShrinksTheEyeball) {  // M4
  const Face face = test::face_named("male");
  const Face posed = test::posed(face, {"muscle.orbicularis-oculi=1"});
  // k (R − R0) = −c (stroke + R − R0) with c = 0.5 · 20, as for a point of its rim pulled to its middle
  const double change = -10. * 10 / (20 + 10);
  EXPECT_NEAR(number_of(posed, "eyeball.left/radius"), 13 + change, 1e-12);
  EXPECT_NEAR(number_of(posed, "eyeball.right/radius"), 13 + change, 1e-12);
  EXPECT_EQ(number_of(posed, "eyeball.left/center", 0), 82);
}

TEST(MusclePose, OneSideMovesAlone) {  // M10
  const Face face = test::face_named("male");
  const Face posed = test::posed(face, {"emotion.left.joy=0.4"});
  EXPECT_LT(number_of(posed, "mouth.left/points/2", 1), 169);
  EXPECT_EQ(number_of(posed, "mouth.right/points/2", 1), 170);
  // The middle of the mouth is one point, on the axis.
  EXPECT_EQ(number_of(posed, "mouth.left/points/0", 0), 0);
  EXPECT_EQ(number_of(posed, "mouth.left/points/0", 1),
            number_of(posed, "mouth.right/points/0", 1));
  EXPECT_LT(number_of(posed, "mouth.left/points/0", 1), 170);
  const Face both = test::posed(face, {"emotion.joy=0.4"});
  EXPECT_EQ(number_of(both, "mouth.left/points/2", 1), number_of(posed, "mouth.left/points/2", 1));
}

TEST(MusclePose, MirroredPullsGiveTheMirroredFaceToTheBit) {  // M5
  const Face face = test::face_named("male");
  const Face a =
      test::posed(face, {"emotion.left.fear=0.7", "emotion.right.anger=0.3", "emotion.joy=0.2"});
  const Face b =
      test::posed(face, {"emotion.right.fear=0.7", "emotion.left.anger=0.3", "emotion.joy=0.2"});
  for (const char* point : {"eyebrow", "mouth", "eye", "nose", "chin"})
    for (int i = 0; i < 2; ++i) {
      const std::string part = "/points/" + std::to_string(i);
      EXPECT_EQ(number_of(a, point + (".left" + part), 0),
                -number_of(b, point + (".right" + part), 0));
      EXPECT_EQ(number_of(a, point + (".left" + part), 1),
                number_of(b, point + (".right" + part), 1));
    }
}

TEST(MusclePose, HoldsAnyPointOrNumber) {  // M4
  const Face face = face_from(R"(
    {"name": "lift", "side": "left", "strength": 20, "stroke": 0.1, "origin": [0.3, 2],
     "attach": {"brow/spine/1": 1, "brow/half_width/1": {"weight": 0.5, "stroke": 0.03},
                "iris/tilt": {"weight": 1, "stroke": 20}, "iris/scale": 0.5}},
    {"name": "pull", "side": "left", "strength": 20, "stroke": 0.1, "origin": [1, -0.4],
     "attach": {"mouth/spine/2": 1, "mouth/spine/1": 0.5}, "right": {"attach": {"mouth/spine/0": 1, "mouth/spine/1": 0.5}}},
    {"name": "jaw", "strength": 20, "stroke": 0.1, "origin": [0, -2], "attach": {"mouth/spine/1": 1}})");
  const Face lifted = test::posed(face, {"muscle.lift=1"});
  EXPECT_NEAR(number_of(lifted, "brow.left/spine/1", 1), 0.45, 1e-12);
  EXPECT_NEAR(number_of(lifted, "brow.left/half_width", 1), 0.02 + 0.03 * 10 / 30, 1e-12);
  EXPECT_NEAR(number_of(lifted, "iris.left/tilt"), 20, 1e-12);
  EXPECT_NEAR(number_of(lifted, "iris.right/tilt"), -20, 1e-12);
  EXPECT_NEAR(number_of(lifted, "iris.left/radii", 0) / 0.1,
              number_of(lifted, "iris.left/radii", 1) / 0.2, 1e-12);
  EXPECT_LT(number_of(lifted, "iris.left/radii", 0), 0.1);
  const Face half = test::posed(face, {"muscle.left.pull=1"});
  EXPECT_GT(number_of(half, "mouth/spine/2", 0), 0.2);
  EXPECT_EQ(number_of(half, "mouth/spine/0", 0), -0.2);
  EXPECT_GT(number_of(half, "mouth/spine/1", 0), 0) << "the middle of an unsided feature is free";
  EXPECT_EQ(number_of(test::posed(face, {"muscle.pull=1"}), "mouth/spine/1", 0), 0);
  EXPECT_LT(number_of(test::posed(face, {"muscle.jaw=1"}), "mouth/spine/1", 1), -0.4);
}

TEST(MusclePose, AddsToWhatElsePosesAPoint) {
  const Face face = test::face_named("male");
  FaceVector vector = face.vector;
  for (double& v : vector) v += 1;
  const Face posed = test::posed(face, {"emotion.joy=1"});
  MusclePoser poser;
  Pose pose;
  for (const char* text : {"emotion.joy=1"}) pose.settings.push_back(*read_setting(face, text));
  std::vector<double> values(face.model->channels.size());
  for (const Index<Channel> c : face.model->controls[std::size_t(pose.settings[0].index)].channels)
    values[std::size_t(c.at)] = 1;
  poser.act(face, pose, values, {}, vector);
  const auto corner =
      std::size_t(face.model->layout[face.model->layout.find("mouth.left/points/2")].begin);
  EXPECT_NEAR(vector[corner], posed.vector[corner] + 1, 1e-12);
}

TEST(MusclePose, KnowsWhetherAClipDrivesIt) {
  const Face face = test::face_named("male");
  EXPECT_FALSE(muscles_in_motion(*face.model, {.time = 1}));
  EXPECT_FALSE(muscles_in_motion(*test::face_named("toon").model, {.time = 1}));
}

}  // namespace
}  // namespace mien
