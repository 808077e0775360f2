#include "lib/rig/muscle/motion.h"

#include <mien/face_model.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/support/faces/face_path.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/muscle_reference.h"

namespace mien {
namespace {

const std::string kMaleInMotion = test::face_path("male");

/// The male face with a clip.
Face male_with(const std::string& clip) {
  std::ifstream file(kMaleInMotion);
  std::stringstream text;
  text << file.rdbuf();
  std::string all = text.str();
  all.insert(all.rfind('}'), R"(, "clips": {"act": )" + clip + R"(}, "default_clip": "act")");
  const Expected<Face> face = read_face_text(all);
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

/// Jumps, ramps and a wave, in four emotions.
const std::string kAct = R"({
  "emotion.fear": {"keys": [[0, 0], [0.25, 0], [0.5, 1, "step"], [1.2, 0.2]]},
  "emotion.joy": {"sine": {"amplitude": 0.4, "frequency": 3, "offset": 0.5}},
  "emotion.left.surprise": {"keys": [[0.9, 0, "step"], [1, 1]]},
  "muscle.jaw": {"period": 1.5, "keys": [[0, 0.1], [0.7, 0.9, "smooth"], [1.5, 0.1]]}})";

FaceVector at(const Face& face, double time) {
  return pose_face(face, {.time = time}).vector;
}

TEST(MuscleMotion, FollowsTheLaw) {  // M8, M9
  const Face face = male_with(R"({"emotion.fear": {"keys": [[0, 0], [0.25, 1], [0.5, 0.6]]}})");
  const test::MuscleReference reference(kMaleInMotion);
  const auto pulls = [&](double t) {
    const double e = t < 0.25 ? 4 * t : t < 0.5 ? 1 - 1.6 * (t - 0.25) : 0.6;
    return reference.mix({{"fear", e}});
  };
  double most = 0;
  for (const double time : {0.125, 0.3, 0.75}) {
    const FaceVector now = at(face, time);
    for (const auto& [name, where] : reference.run(pulls, time, 1. / 16000)) {
      const std::size_t slash = name.find('/');
      const Layout& layout = face.model->layout;
      const auto i = std::size_t(
          layout[layout.find(name.substr(0, slash) + ".left" + name.substr(slash))].begin);
      most = std::max({most, std::abs(now[i] - where.real()), std::abs(now[i + 1] - where.imag())});
    }
  }
  EXPECT_LT(most, 1e-6) << "of units, in a face of 400";
  RecordProperty("worst", std::to_string(most));
}

TEST(MuscleMotion, IsTheSameAtEveryFrameRate) {  // M9
  const Face face = male_with(kAct);
  for (const int rate : {24, 30, 60, 1000}) {
    Poser poser(face);
    FaceVector there;
    for (int frame = 0; frame <= rate; ++frame)
      there = poser.pose({.time = double(frame) / rate}).vector;
    EXPECT_EQ(there, at(face, 1)) << rate;
  }
}

TEST(MuscleMotion, IsTheSameInAnyOrder) {  // M9
  const Face face = male_with(kAct);
  Poser poser(face);
  for (const double time : {0.1, 1.3, 0.7, 9.9, 8.01, 0.1, 16., 7.999})
    EXPECT_EQ(poser.pose({.time = time}).vector, at(face, time)) << time;
}

/// Nearby moments are near, at cells' and epochs' borders too.
TEST(MuscleMotion, IsContinuous) {
  const Face face = male_with(kAct);
  const double epoch = muscle_epoch(face.model->muscles);
  EXPECT_EQ(epoch, 8);
  Poser poser(face);
  for (const double time : {1. / 256, 0.5, epoch, 2 * epoch}) {
    const FaceVector before = poser.pose({.time = std::nextafter(time, 0)}).vector;
    const FaceVector now = poser.pose({.time = time}).vector;
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(before[i], now[i], 1e-6) << time;
  }
}

TEST(MuscleMotion, SurvivesAnyTime) {  // M9
  const Face face = male_with(kAct);
  for (const double time : {-1e300, -10., 0., 10., 20., 1e6, 1e9, 1e300})
    for (const double number : at(face, time)) {
      ASSERT_TRUE(std::isfinite(number)) << time;
      ASSERT_LT(std::abs(number), 500) << time;
    }
}

TEST(MuscleMotion, ComesToTheEquilibrium) {  // M8
  const Face face = male_with(R"({"emotion.sadness": {"keys": [[0, 0, "step"], [0.1, 1]]}})");
  const FaceVector still = test::posed(face, {"emotion.sadness=1"}).vector, late = at(face, 7);
  for (std::size_t i = 0; i < still.size(); ++i) EXPECT_NEAR(late[i], still[i], 1e-8);
  EXPECT_NE(at(face, 0.3), still);
}

TEST(MuscleMotion, BeginsInTheEquilibriumOfItsBegin) {
  const Face face = male_with(R"({"emotion.joy": {"keys": [[0, 0.8], [1, 0]]}})");
  EXPECT_EQ(at(face, 0), test::posed(face, {"emotion.joy=0.8"}).vector);
  EXPECT_EQ(at(face, -5), at(face, 0));
}

}  // namespace
}  // namespace mien
