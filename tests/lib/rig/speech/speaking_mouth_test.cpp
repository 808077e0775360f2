// What coarticulation promises of weights, seen in mouths: people say sentences in every mood.

#include <mien/bound_motion.h>
#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/face_model.h>
#include <mien/poser.h>
#include "lib/rig/speech/coarticulation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/posing.h"

namespace mien {
namespace {

using test::point_of;

constexpr int kPeople = 50, kMoments = 8;
constexpr std::array<const char*, 5> kMoods{"emotion.joy=0", "emotion.joy=1", "emotion.anger=1",
                                            "emotion.sadness=1", "emotion.surprise=1"};

/// "mama, a five boom", with sounds shorter than a contact lasts, and long ones.
const SpeechTrack kSentence{
    {0.00, 0.10, Viseme::PP}, {0.10, 0.25, Viseme::aa}, {0.25, 0.31, Viseme::PP},
    {0.31, 0.50, Viseme::aa}, {0.60, 0.70, Viseme::aa}, {0.70, 0.85, Viseme::FF},
    {0.85, 1.00, Viseme::aa}, {1.00, 1.06, Viseme::I},  {1.06, 1.11, Viseme::FF},
    {1.11, 1.20, Viseme::O},  {1.20, 1.21, Viseme::PP}, {1.21, 1.40, Viseme::U},
    {1.40, 1.70, Viseme::PP}};

std::vector<Face> speakers() {
  std::vector<Face> all{test::sample_face("faces/toon"), test::sample_face("faces/bruno"),
                        test::sample_face("faces/clay")};
  for (int i = 0; i < kPeople; ++i)
    all.push_back(
        face_from_recipe(recipe_from_seed(seed_from_word(fmt::format("speaks/{}", i)))).value());
  return all;
}

std::vector<double> inner_edge(const Face& face, const std::string& which) {
  std::vector<double> all;
  for (const char* side : {"left", "right"})
    for (const char* bend : {"0", "1"})
      for (const double x :
           test::slice_of(face, fmt::format("{}_edge.{}/spine/{}", which, side, bend)))
        all.push_back(x);
  return all;
}

double edge_of_teeth(const Face& face) {
  return 0.5 * point_of(face, "teeth/points/2").y +
         0.25 * (point_of(face, "teeth/points/1").y + point_of(face, "teeth/points/3").y);
}

double chin(const Face& face) {
  return point_of(face, "head/points/5").y;
}

/// For all speakers, moods and moments of the contacts of a shape.
template <class Look>
void during(Viseme viseme, Look&& look) {
  const Motion said = coarticulated(kSentence, "sentence");
  for (const Face& face : speakers()) {
    const BoundMotion bound = bind_motion(said, face);
    ASSERT_TRUE(bound.unfollowed.empty());
    Poser poser(face);
    for (const char* mood : kMoods) {
      Pose pose = test::pose_of(face, {mood});
      pose.motions = {{.motion = bound.motion}};
      for (const Phone& phone : kSentence) {
        if (phone.viseme != viseme) continue;
        const auto [begin, end] = contact_of(phone);
        ASSERT_GE(end - begin, kLeastContact - 1e-12);
        look(face, poser, pose, begin, end, fmt::format("{} {} {}", face.model->name, mood, begin));
      }
    }
  }
}

TEST(SpeakingMouth, ShutsForEveryClosingSoundWhileTheChinGoesOn) {
  during(Viseme::PP, [&](const Face& face, Poser& poser, Pose& pose, double begin, double end,
                         const std::string& what) {
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i <= kMoments; ++i) {
      pose.time = begin + (end - begin) * i / kMoments;
      const Face& posed = poser.pose(pose);
      ASSERT_EQ(inner_edge(posed, "upper"), inner_edge(posed, "lower")) << what;
      lowest = std::min(lowest, chin(posed)), highest = std::max(highest, chin(posed));
    }
    const bool between_vowels = begin > 0.1 && begin < 1.3;
    if (!between_vowels) return;
    const double drop = face.model->mouth->drop;
    EXPECT_LT(highest, chin(without_mood(face)) - 0.03 * drop) << what << ": the jaw is down";
    EXPECT_GT(highest - lowest, 0.002 * drop) << what << ": it goes on";
  });
}

TEST(SpeakingMouth, TouchesTheUpperTeethForEveryFAndV) {
  during(Viseme::FF, [&](const Face& face, Poser& poser, Pose& pose, double begin, double end,
                         const std::string& what) {
    for (int i = 0; i <= kMoments; ++i) {
      pose.time = begin + (end - begin) * i / kMoments;
      const Face& posed = poser.pose(pose);
      const double lip = point_of(posed, "lower_edge.left/spine/0").y, teeth = edge_of_teeth(posed);
      ASSERT_GT(lip, teeth) << what;
      ASSERT_LT(lip, teeth + 0.03 * face.model->mouth->width) << what;
    }
  });
}

/// The proofs see mouths that stay open: between the contacts they are.
TEST(SpeakingMouth, OpensForVowels) {
  for (const Face& face : speakers()) {
    const BoundMotion bound = bind_motion(coarticulated(kSentence, "sentence"), face);
    Pose pose;
    pose.motions = {{.motion = bound.motion}};
    for (const double vowel : {0.18, 0.42, 0.93}) {
      pose.time = vowel;
      const Face posed = pose_face(face, pose);
      EXPECT_GT(point_of(posed, "upper_edge.left/spine/0").y -
                    point_of(posed, "lower_edge.left/spine/0").y,
                0.05)
          << face.model->name << vowel;
    }
  }
}

}  // namespace
}  // namespace mien
