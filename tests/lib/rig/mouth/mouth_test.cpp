#include "lib/rig/mouth/mouth.h"

#include <mien/composed_face.h>
#include <mien/crowd.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::face_at;
using test::point_of;

constexpr std::array<const char*, 6> kEmotions{"joy",     "sadness", "anger",
                                               "disgust", "fear",    "surprise"};
const std::vector<std::string> kHead{"yaw=25", "pitch=-12", "roll=8"};

/// The three samples, and people of all kinds, without their moods.
const std::vector<Face>& mouths() {
  static const std::vector<Face> all = [] {
    std::vector<Face> faces{test::sample_face("faces/toon"), test::sample_face("faces/bruno"),
                            test::sample_face("faces/clay")};
    for (int i = 0; i < 17; ++i)
      faces.push_back(
          face_from_recipe(recipe_from_seed(seed_from_word(fmt::format("mouth/{}", i)))).value());
    for (Face& face : faces) face = without_mood(face);
    return faces;
  }();
  return all;
}

TEST(Mouth, ClosesWhateverElseTheFaceDoes) {
  for (const Face& face : mouths()) {
    Poser poser(face);
    for (std::size_t e = 0; e <= kEmotions.size(); ++e)
      for (const char* jaw : {"0", "0.2", "0.6", "1"})
        for (const bool turned : {false, true}) {
          std::vector<std::string> words{std::string("jaw.open=") + jaw, "mouth.close=1",
                                         "muscle.left.levator-labii=0.4"};
          if (e < kEmotions.size()) words.push_back(fmt::format("emotion.{}=1", kEmotions[e]));
          if (turned) words.insert(words.end(), kHead.begin(), kHead.end());
          const Face& shut = poser.pose(test::pose_of(face, words));
          ASSERT_EQ(test::inner_edge_of(shut, "upper"), test::inner_edge_of(shut, "lower"))
              << face.model->name << " " << e << " " << jaw;
        }
  }
}

TEST(Mouth, ClosesByARKitsLaw) {
  for (const Face& face : mouths())
    for (const char* emotion : {"emotion.joy=0", "emotion.joy=1", "emotion.surprise=1"})
      for (const double jaw : {0.05, 0.2, 0.6, 1.0}) {
        const auto at = [&](double close) {
          return face_at(face, {emotion, fmt::format("arkit.jawOpen={}", jaw),
                                fmt::format("arkit.mouthClose={}", close)});
        };
        const Face shut = at(std::max(jaw, 0.1)), open = at(0.3 * jaw);
        EXPECT_EQ(test::inner_edge_of(shut, "upper"), test::inner_edge_of(shut, "lower"))
            << face.model->name << emotion << jaw;
        EXPECT_NE(test::inner_edge_of(open, "upper"), test::inner_edge_of(open, "lower"))
            << face.model->name << emotion << jaw;
      }
}

/// No landmark moves by more than 0.01 for a change of 0.01.
TEST(Mouth, ClosesContinuously) {
  for (const Face& face : mouths())
    for (const double jaw : {0.0, 0.05, 0.1, 0.3, 0.99})
      for (const double close : {0.0, 0.05, 0.1, 0.3, 0.99})
        for (const auto& [dj, dc] : {std::pair{0.01, 0.0}, {0.0, 0.01}}) {
          const auto at = [&](double j, double c) {
            return face_at(
                face, {"arkit.mouthSmileLeft=0.7", "arkit.mouthSmileRight=0.7",
                       fmt::format("arkit.jawOpen={}", j), fmt::format("arkit.mouthClose={}", c)});
          };
          const Face a = at(jaw, close), b = at(jaw + dj, close + dc);
          for (const Slice& slice : face.model->layout.slices())
            if (slice.kind == SliceKind::point) {
              ASSERT_LT(glm::length(point_of(a, slice.name) - point_of(b, slice.name)), 0.01)
                  << slice.name << jaw << close;
            }
        }
}

/// Noise of a capture moves nothing that is seen, tongue and teeth included.
TEST(Mouth, HardlyMovesByNoise) {
  for (const Face& face : mouths())
    for (const char* emotion : {"emotion.joy=0", "emotion.joy=1"}) {
      const Face still = face_at(face, {emotion}),
                 noisy = face_at(face, {emotion, "arkit.mouthClose=0.001"});
      for (const Slice& slice : face.model->layout.slices())
        if (slice.kind == SliceKind::point || slice.kind == SliceKind::length)
          for (int i = 0; i < slice.size; ++i) {
            const auto at = std::size_t(slice.begin + i);
            ASSERT_NEAR(still.vector[at], noisy.vector[at], 0.003) << slice.name << emotion;
          }
    }
}

TEST(Mouth, CarriesTheChin) {
  for (const Face& face : mouths())
    for (const char* close : {"0", "1"}) {
      const Face open = face_at(face, {"jaw.open=1", std::string("mouth.close=") + close});
      const double drop = face.model->mouth->drop;
      EXPECT_NEAR(point_of(face, "head/points/5").y - point_of(open, "head/points/5").y,
                  0.62 * drop, 1e-9);
      EXPECT_NEAR(point_of(face, "teeth_low/points/2").y - point_of(open, "teeth_low/points/2").y,
                  0.9 * drop, 1e-9);
      EXPECT_EQ(point_of(face, "teeth/points/2"), point_of(open, "teeth/points/2"));
      EXPECT_GT(drop, 0.1);
    }
}

TEST(Mouth, OfMusclesAndOfControlsIsOneJaw) {
  for (const Face& face : mouths()) {
    const Face pulled = face_at(face, {"muscle.jaw=1"}), open = face_at(face, {"jaw.open=1"});
    EXPECT_NEAR(point_of(pulled, "lower_edge.left/spine/0").y,
                point_of(open, "lower_edge.left/spine/0").y, 1e-4);
    EXPECT_EQ(test::inner_edge_of(face_at(face, {"jaw/open=1"}), "lower"),
              test::inner_edge_of(open, "lower"));
  }
}

/// At work it opens as wide as one that rests shut, and no wider; a jaw that drops never makes it smaller than that.
TEST(Mouth, ThatRestsOpenGivesItsGapUp) {
  const auto with = [](const char* mouth) {
    Recipe recipe;
    recipe.parts["mouth"] = mouth;
    return face_from_recipe(recipe).value();
  };
  const auto gap = [](const Face& face, const std::string& word) {
    const Face posed = face_at(face, {word});
    return point_of(posed, "upper_edge.left/spine/0").y -
           point_of(posed, "lower_edge.left/spine/0").y;
  };
  for (const char* name : {"grin", "toothy", "dot", "soft_gap", "small_missing", "wide_braces"}) {
    const Face face = with(name);
    const double rest = gap(face, "jaw.open=0");
    EXPECT_GT(rest, 0.05) << name;
    EXPECT_NEAR(gap(face, "viseme.U=1"), gap(with("soft"), "viseme.U=1"), 0.02) << name;
    EXPECT_NEAR(gap(face, "mouth.pucker=1"), 0, 1e-9) << name;
    for (const char* jaw : {"jaw.open=0.2", "jaw.open=0.6", "jaw.open=1"})
      EXPECT_GT(gap(face, jaw), rest) << name << jaw;
    EXPECT_LT(gap(face, "emotion.sadness=1"), 0.4 * rest) << name;
    EXPECT_LT(gap(face, "emotion.anger=1"), 0.4 * rest) << name;
  }
}

TEST(Mouth, KeepsTheLipsArea) {
  for (const Face& face : mouths())
    for (const char* close : {"0", "1"})
      for (const char* jaw : {"0", "0.5", "1"}) {
        const Face posed =
            face_at(face, {std::string("jaw.open=") + jaw, std::string("mouth.close=") + close});
        for (const char* lip : {"lip_upper.left/half_width", "lip_lower.left/half_width"}) {
          const double drawn = test::slice_of(face, lip)[0];
          if (drawn == 0) continue;  // a mouth that is a line has no lips
          const double by = test::slice_of(posed, lip)[0] / drawn;
          EXPECT_GT(by, 0.5) << lip << jaw << close;
          EXPECT_LE(by, 1.35 + 1e-9) << lip << jaw << close;
        }
      }
  const Face rolled = face_at(mouths()[0], {"mouth.roll_lower=1"});
  EXPECT_LT(test::slice_of(rolled, "lip_lower.left/half_width")[0],
            0.15 * test::slice_of(mouths()[0], "lip_lower.left/half_width")[0]);
}

TEST(Mouth, TouchesTheTeethAndShowsTheTongue) {
  for (const Face& face : mouths())
    for (const char* jaw : {"0", "0.3", "0.8"}) {
      const Face bitten = face_at(face, {std::string("jaw.open=") + jaw, "mouth.bite=1"});
      const double teeth =
          0.5 * point_of(bitten, "teeth/points/2").y +
          0.25 * (point_of(bitten, "teeth/points/1").y + point_of(bitten, "teeth/points/3").y);
      EXPECT_GT(point_of(bitten, "lower_edge.left/spine/0").y, teeth);
      EXPECT_LT(point_of(bitten, "lower_edge.left/spine/0").y, teeth + 0.03);
      const Face between = face_at(face, {std::string("jaw.open=") + jaw, "tongue.between=1"});
      EXPECT_GT(test::slice_of(between, "tongue_tip/radii")[1], 0.01);
      EXPECT_GT(
          point_of(between, "tongue_tip/center").y + test::slice_of(between, "tongue_tip/radii")[1],
          teeth);
      const Face out = face_at(face, {"tongue.out=1", "mouth.close=1"});
      EXPECT_EQ(test::slice_of(out, "tongue_out/opacity")[0], 1);
      EXPECT_LT(point_of(out, "tongue_out/points/3").y,
                point_of(out, "lip_lower.left/spine/0").y - 0.05);
    }
}

/// The upper lip's highest place within 0.045 of the nose's middle, by a finer walk than the law's.
double lip_top(const Face& face, glm::dvec2 nose) {
  double top = -1;
  for (const std::string side : {"left", "right"}) {
    const std::string lip = "lip_upper." + side;
    const std::vector<double> wide = test::slice_of(face, lip + "/half_width");
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100.0, a = (1 - t) * (1 - t), b = 2 * t * (1 - t), c = t * t;
      const glm::dvec2 p = a * point_of(face, lip + "/spine/0") +
                           b * point_of(face, lip + "/spine/1") +
                           c * point_of(face, "upper_edge." + side + "/spine/2");
      if (std::abs(p.x - nose.x) < 0.045)
        top = std::max(top, p.y + a * wide[0] + b * wide[1] + c * wide[2]);
    }
  }
  return top;
}

TEST(Mouth, StaysUnderTheNose) {
  std::vector<Face> faces = mouths();
  for (const char* code : {"AA9N1-HP6CV-SJ", "AS7ZR-P11FE-WB", "AKTC3-2HK25-41", "AGS3X-F80F3-72"})
    faces.push_back(without_mood(face_from_code(code).value()));
  int stopped = 0;
  for (const Face& face : faces) {
    const glm::dvec2 nose = face.model->mouth->under.value();
    const double most = std::max(lip_top(face, nose), nose.y - 0.012);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"arkit.noseSneerLeft=1", "arkit.mouthUpperUpLeft=1"},
          {"muscle.left.levator-labii=1", "muscle.right.levator-labii=1", "viseme.FF=1"},
          {"arkit.mouthLeft=1"},
          {"arkit.mouthRight=1"},
          {"arkit.mouthShrugLower=1", "arkit.noseSneerLeft=1", "arkit.noseSneerRight=1"}}) {
      const double top = lip_top(face_at(face, words), nose);
      EXPECT_LE(top, most) << face.model->name << " " << words[0];
      stopped += top > most - 0.004;
    }
  }
  EXPECT_GE(stopped, 3) << "the law is at work";
}

/// A moustache stays over the lip and in order while corners come in.
TEST(Mouth, DoesNotFoldAMoustache) {
  for (const char* style : {"walrus", "chevron"}) {
    Recipe recipe;
    recipe.parts["moustache"] = style;
    const Face face = face_from_recipe(recipe).value();
    for (const char* pose : {"jaw.open=1", "mouth.pucker=1", "emotion.surprise=1", "viseme.O=1"}) {
      const Face posed = face_at(face, {pose});
      const auto reach = [&](const Face& f) {
        return point_of(f, "moustache.left/spine/2").x - point_of(f, "moustache.left/spine/0").x;
      };
      EXPECT_GT(reach(posed), 0.6 * reach(face)) << style << " " << pose;
    }
  }
}

TEST(Mouth, IsTheSameOnBothSides) {
  Recipe recipe;
  recipe.numbers["asymmetry"] = 0;
  const Face face = face_from_recipe(recipe).value();
  for (const char* pose : {"jaw.open=0.7", "mouth.pucker=0.8", "viseme.FF=1",
                           "muscle.zygomaticus=1", "mouth.close=0.4"}) {
    const Face posed = face_at(face, {pose});
    for (const char* point :
         {"upper_edge.{}/spine/1", "upper_edge.{}/spine/2", "lower_edge.{}/spine/1",
          "lip_upper.{}/spine/1", "lip_lower.{}/spine/1"}) {
      const glm::dvec2 left = point_of(posed, fmt::format(fmt::runtime(point), "left"));
      EXPECT_EQ(point_of(posed, fmt::format(fmt::runtime(point), "right")),
                glm::dvec2(-left.x, left.y))
          << pose << point;
    }
  }
  const auto corner = [&](const char* pose, const char* side) {
    return point_of(face_at(face, {pose}), fmt::format("upper_edge.{}/spine/2", side));
  };
  EXPECT_EQ(corner("mouth.left.stretch=1", "left").x, -corner("mouth.right.stretch=1", "right").x);
}

TEST(Mouth, AtRestKeepsEveryBit) {
  for (const Face& face : mouths())
    for (const char* pose : {"mouth.close=0", "jaw.open=0", "blink=0"})
      EXPECT_EQ(face_at(face, {pose}).vector, face.vector);
}

}  // namespace
}  // namespace mien
