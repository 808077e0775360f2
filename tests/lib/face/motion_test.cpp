#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/motion.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::sample_face;
using test::slice_of;

const std::string kClips = R"({"format": "mien-face", "format_version": 1,
  "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"ink": "#000000"}, "background": "ink",
  "features": [{"name": "dot", "kind": "disc", "side": "left", "paint": "ink", "center": [0.5, 0.1], "radius": 0.1}],
  "controls": [{"name": "look", "range": [-1, 1], "rest": 0, "per_side": true, "offset": {"dot/center": [0, 1]}}],
  "poses": {"up": {"slices": {"dot/center": [0.5, 0.3]}}},
  "clips": {
    "swing": {"look": {"keys": [[0, 0], [1, 1]]}},
    "hold": {"look": {"keys": [[0, 0.5]]}, "up": {"keys": [[0, 1]]}},
    "more": {"additive": true, "tracks": {"look": {"keys": [[0, 0.1], [1, 0.2]]}}},
    "both": {"look": [{"keys": [[0, 0.25]]}, {"keys": [[0, 0], [1, 0.5]]}, {"keys": [[0, -0.125]]}]}}})";

double looks(const Face& face, const Pose& pose) {
  return slice_of(pose_face(face, pose), "dot.left/center")[1] - 0.1;
}

TEST(Clips, AreLaidOverEachOther) {
  const Face face = *read_face_text(kClips);
  const auto layer = [&](const char* text) {
    const Expected<MotionLayer> read = read_clip_layer(face, text);
    if (!read) throw std::runtime_error(sentence(read.error()));
    return *read;
  };
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("swing")}}), 0.25, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("swing=0.5")}}), 0.125, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("swing=1@0.15")}}), 0.1, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("more")}}), 0.125, 1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("swing"), layer("more")}}), 0.375,
              1e-15);
  EXPECT_NEAR(looks(face, {.time = 0.25, .motions = {layer("swing"), layer("more=2")}}), 0.5,
              1e-15);
  const double mixed = looks(face, {.time = 0.25, .motions = {layer("swing"), layer("hold=0.4")}});
  EXPECT_NEAR(mixed, 0.6 * 0.25 + 0.4 * 0.5 + 0.4 * 0.2, 1e-15);  // "hold" moves the pose "up" too
  EXPECT_EQ(looks(face, {.motions = {layer("swing")}}), 0) << "no time, no clip";
  EXPECT_EQ(looks(face, {.time = 0.5}), 0) << "no default clip";
}

TEST(Clips, AddTheCurvesOfAControl) {
  const Face face = *read_face_text(kClips);
  const auto both = [&](double time, const char* text = "both") {
    return looks(face, {.time = time, .motions = {*read_clip_layer(face, text)}});
  };
  EXPECT_NEAR(both(0), 0.25 + 0 - 0.125, 1e-15);
  EXPECT_NEAR(both(0.5), 0.25 + 0.25 - 0.125, 1e-15);
  EXPECT_NEAR(both(1, "both=0.5"), 0.5 * (0.25 + 0.5 - 0.125), 1e-15) << "the clip's weight";
  // What a curve adds is its difference from the control's rest, so resting at 1 shows a sum of differences.
  std::string raised = kClips;
  raised.replace(raised.find("\"rest\": 0, \"per_side\""), 9, "\"rest\": 0.5");
  const Face from_half = *read_face_text(raised);
  const double sum =
      looks(from_half, {.time = 0.5, .motions = {*read_clip_layer(from_half, "both")}});
  EXPECT_NEAR(sum, (0.25 + (0.25 - 0.5) + (-0.125 - 0.5)) - 0.5, 1e-15);
}

TEST(Clips, GoAsFarAsLivelinessSays) {
  const Face face = *read_face_text(kClips);
  const auto at = [&](const char* clip, double liveliness) {
    return looks(
        face, {.time = 0.5, .motions = {*read_clip_layer(face, clip)}, .liveliness = liveliness});
  };
  EXPECT_NEAR(at("both", 0.5), 0.5 * at("both", 1), 1e-15);
  EXPECT_NEAR(at("both", 2), 2 * at("both", 1), 1e-15);
  EXPECT_EQ(at("both", 9), at("both", 2)) << "the nearer end";
  for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(
        pose_face(face,
                  {.time = 0.5, .motions = {*read_clip_layer(face, "hold")}, .liveliness = none})
            .vector,
        face.vector);
}

/// Clips that drive muscles do so by the liveliness of the pose, too, whatever was posed before.
TEST(Clips, OfMusclesAreLivelyToo) {
  const Face bruno = sample_face("bruno");
  const auto joy = [&](double liveliness) {
    return Pose{
        .time = 1.5, .motions = {*read_clip_layer(bruno, "feelings")}, .liveliness = liveliness};
  };
  Poser poser(bruno);
  const FaceVector whole = poser.pose(joy(1)).vector, half = poser.pose(joy(0.5)).vector;
  EXPECT_NE(whole, half);
  EXPECT_EQ(half, pose_face(bruno, joy(0.5)).vector);
  EXPECT_EQ(poser.pose(joy(0)).vector, bruno.vector);
}

TEST(Clips, OfIdleLifeAreTheSameAgain) {
  const Face toon = sample_face("toon");
  int blinks = 0, looks_aside = 0;
  bool shut = false;
  for (int frame = 0; frame < 60 * 60; ++frame) {
    const Face now = pose_face(toon, {.time = frame / 60.0});
    const double gap =
        slice_of(now, "opening.left/upper")[1] - slice_of(now, "opening.left/lower")[1];
    blinks += gap < 0.1 && !shut;
    shut = gap < 0.1;
    looks_aside += std::abs(slice_of(now, "limbus.left/center")[0] -
                            slice_of(toon, "limbus.left/center")[0]) > 0.01;
  }
  EXPECT_GE(blinks, 12);  // people blink 12 to 20 times a minute
  EXPECT_LE(blinks, 20);
  EXPECT_GT(looks_aside, 600);
  EXPECT_EQ(pose_face(toon, {.time = 17.3}).vector, pose_face(toon, {.time = 17.3}).vector);
}

}  // namespace
}  // namespace mien
