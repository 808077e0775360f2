#include "lib/rig/pose/head_turn.h"

#include <mien/composed_face.h>
#include <mien/recipe.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using test::face_at;
using test::point_of;
using test::sample_face;
using test::slice_of;

const HeadTurn kTurnedHead{.pivot = {0, -0.3, 0.05}, .center = {0, 0}, .radii = {0.5, 0.65, 0.4}};

/// A nose that is drawn by light stands out as far as the one that is drawn by lines, or a turned face has two.
TEST(Turn, TakesAStylesReliefAlong) {
  Recipe recipe;
  recipe.style = "vinyl";
  const Face rest = face_from_recipe(recipe).value(),
             turned = face_at(rest, {"yaw=25", "pitch=-10"});
  const auto way = [&](const char* slice) {
    return point_of(turned, slice) - point_of(rest, slice);
  };
  const glm::dvec2 light = way("head/relief/domes/0/center"), line = way("nose_light/center");
  EXPECT_GT(glm::length(line), 0.15);
  EXPECT_LT(glm::length(light - line), 0.02) << light.x << ' ' << line.x;
}

TEST(Turn, OfNothingIsNothing_G4) {
  const Face toon = sample_face("toon");
  EXPECT_EQ(face_at(toon, {"yaw=0", "pitch=0", "roll=0"}).vector, toon.vector);
  const Turn none(kTurnedHead, 0, 0, 0, true);
  for (const glm::dvec2 p : {glm::dvec2{0.1, 0.2}, {-0.4, 0.1}, {0.9, 0.9}}) {
    EXPECT_LT(glm::length(none.surface(p, 0.03) - p), 1e-15);
    EXPECT_LT(glm::length(none.flat(p, -0.2) - p), 1e-15);
    EXPECT_EQ(none.foreshortening(p), glm::dvec2(1));
  }
}

/// Turned left is the mirror image of turned right, bit for bit; roll mirrors too.
TEST(Turn, LeftAndRightAreMirrorImages_G4) {
  const Face toon = sample_face("toon");
  for (const char* other : {"pitch=0", "pitch=12", "blink=0.4"}) {
    const Face one = face_at(toon, {"yaw=22", "roll=-7", other}),
               two = face_at(toon, {"yaw=-22", "roll=7", other});
    int compared = 0;
    for (const Slice& slice : toon.model->layout.slices()) {
      const std::size_t at = slice.name.find(".left/");
      if (at == std::string::npos || slice.name.find("/dome/") != std::string::npos) continue;
      std::vector<double> left = slice_of(one, slice.name);
      mirror_values(slice.kind, left, toon.model->canvas.twice_axis());
      EXPECT_EQ(left, slice_of(two, fmt::format("{}.right/{}", slice.name.substr(0, at),
                                                slice.name.substr(at + 6))))
          << slice.name;
      ++compared;
    }
    EXPECT_GT(compared, 50);
  }
}

/// Near things move more than far ones, to the side the face turns to; the outline stays.
TEST(Turn, MovesByParallax_G4) {
  const Face toon = sample_face("toon");
  const Face turned = face_at(toon, {"yaw=25"});
  const auto moved = [&](const char* name) {
    return point_of(turned, name).x - point_of(toon, name).x;
  };
  EXPECT_GT(moved("nose_shade/points/0"), moved("opening.right/inner"));
  EXPECT_GT(moved("opening.right/inner"), 0.08);
  EXPECT_EQ(moved("head/points/0"), 0);
  EXPECT_LT(moved("hair_back/points/0"), -0.02);
  EXPECT_EQ(moved("sweater/points/0"), 0);
  EXPECT_GT(point_of(face_at(toon, {"pitch=15"}), "nose_shade/points/0").y,
            point_of(toon, "nose_shade/points/0").y + 0.03);
}

/// The eye on the side it turns to is seen more narrowly.
TEST(Turn, ForeshortensTheFarSide_G4) {
  const Face toon = sample_face("toon");
  const Face turned = face_at(toon, {"yaw=25"});
  const auto width = [&](const Face& f, const std::string& side) {
    return std::abs(point_of(f, "opening." + side + "/outer").x -
                    point_of(f, "opening." + side + "/inner").x);
  };
  EXPECT_LT(width(turned, "left"), 0.85 * width(toon, "left"));
  EXPECT_GT(width(turned, "right"), width(turned, "left"));
  EXPECT_LT(slice_of(turned, "limbus.left/radii")[0], 0.9 * slice_of(toon, "limbus.left/radii")[0]);
  EXPECT_EQ(slice_of(turned, "limbus.left/radii")[1], slice_of(toon, "limbus.left/radii")[1]);
}

/// Sizes shrink as distances between near points do.
TEST(Turn, ForeshortensSizesAsItDoesWays_G4) {
  for (const bool y_up : {true, false})
    for (const double yaw : {-28.0, 0.0, 15.0})
      for (const double pitch : {-20.0, 0.0, 10.0}) {
        const Turn turn(kTurnedHead, yaw, pitch, 0, y_up);
        for (const glm::dvec2 p : {glm::dvec2{0.1, 0.2}, {-0.3, 0.1}, {0.25, -0.3}}) {
          constexpr double e = 1e-6;
          const double x =
              (turn.surface(p + glm::dvec2{e, 0}, 0).x - turn.surface(p - glm::dvec2{e, 0}, 0).x) /
              (2 * e);
          const double y =
              (turn.surface(p + glm::dvec2{0, e}, 0).y - turn.surface(p - glm::dvec2{0, e}, 0).y) /
              (2 * e);
          // 6e-11 was measured, the noise of the difference quotient.
          EXPECT_NEAR(turn.foreshortening(p).x, x, 2.5e-10) << yaw << " " << pitch;
          EXPECT_NEAR(turn.foreshortening(p).y, y, 2.5e-10) << yaw << " " << pitch;
        }
      }
}

/// Near the edge, where the surface's own slope has no bound: nothing is smaller than where it is turned away, nothing
/// larger than half as large again, on each of the four sides and beyond the head.
TEST(Turn, ForeshorteningHasLimits) {
  for (const bool y_up : {true, false})
    for (const double way : {-1.0, 1.0}) {
      const Turn yaw(kTurnedHead, 28 * way, 0, 0, y_up), pitch(kTurnedHead, 0, 28 * way, 0, y_up);
      for (const double share : {0.99, 1.0, 2.0}) {
        const double x = way * share * kTurnedHead.radii.x,
                     y = (y_up ? way : -way) * share * kTurnedHead.radii.y;
        EXPECT_EQ(yaw.foreshortening({x, 0}), glm::dvec2(0, 1)) << share;
        EXPECT_EQ(yaw.foreshortening({-x, 0}), glm::dvec2(1.5, 1)) << share;
        EXPECT_EQ(pitch.foreshortening({0, y}), glm::dvec2(1, 0)) << share;
        EXPECT_EQ(pitch.foreshortening({0, -y}), glm::dvec2(1, 1.5)) << share;
      }
    }
  // A plate that is turned away shows no back.
  EXPECT_EQ(Turn(kTurnedHead, 120, 100, 0, true).plate_foreshortening(), glm::dvec2(0));
}

/// Three points of a plate stay as they were among each other: seen from the side, narrower, but in line, and two
/// equal ways stay equal. On the head they would bend round it.
TEST(Turn, APlateTurnsAsOneRigidBody) {
  for (const double yaw : {-30.0, 12.0, 30.0}) {
    const Turn turn(kTurnedHead, yaw, 15, 5, true);
    const glm::dvec2 a = turn.plate({-0.3, 0.1}, 0.4), b = turn.plate({0, 0.1}, 0.4),
                     c = turn.plate({0.3, 0.1}, 0.4);
    EXPECT_LT(glm::length(a + c - 2.0 * b), 1e-15);
    EXPECT_NEAR(glm::length(c - a), 0.6 * std::cos(yaw * 3.14159265358979 / 180), 1e-2);
    const glm::dvec2 d = turn.surface({-0.3, 0.1}, 0), e = turn.surface({0, 0.1}, 0),
                     f = turn.surface({0.3, 0.1}, 0);
    EXPECT_GT(glm::length(d + f - 2.0 * e), 0.02);
    EXPECT_NEAR(turn.plate_foreshortening().x, std::cos(yaw * 3.14159265358979 / 180), 1e-12);
  }
}

/// Everything but clothes and neck grows about the pivot by the same share, lengths too, on a turned head as well.
TEST(Turn, AHeadThatComesNearerGrows) {
  const Face face = sample_face("faces/toon");
  for (const char* yaw : {"yaw=0", "yaw=-20"})
    for (const double nearer : {0.1, -0.08}) {
      const Face before = face_at(face, {yaw}),
                 after = face_at(face, {yaw, fmt::format("nearer={}", nearer)});
      const glm::dvec2 pivot{face.model->turn.pivot};
      int points = 0, lengths = 0;
      for (const TurnedSlice& turned : face.model->turn.slices) {
        const Slice& slice = face.model->layout[turned.slice];
        const std::vector<double> a = slice_of(before, slice.name), b = slice_of(after, slice.name);
        const bool point = slice.kind == SliceKind::point;
        if ((!point && slice.kind != SliceKind::length) || turned.kind == TurnKind::body) continue;
        for (std::size_t i = 0; i < a.size(); ++i) {
          const double zero = point ? pivot[int(i)] : 0;
          ASSERT_NEAR(b[i] - zero, (1 + nearer) * (a[i] - zero), 1e-12) << slice.name;
        }
        ++(point ? points : lengths);
      }
      EXPECT_GT(points, 200);
      EXPECT_GT(lengths, 40);
      EXPECT_EQ(point_of(after, "neck/points/0"), point_of(before, "neck/points/0"));
    }
}

TEST(Turn, ReadsPlates) {
  const std::string text = test::text_of_face("toon");
  const auto with_plate = [&](const std::string& plate) {
    std::string changed = text;
    const std::string still = "\"still\":";
    return changed.insert(changed.find(still), "\"plate\": " + plate + ", ");
  };
  const Expected<Face> face = read_face_text(with_plate(R"({"brow": 0.4, "iris": 0.4})"));
  ASSERT_TRUE(face) << sentence(face.error());
  const Face turned = face_at(*face, {"yaw=25"});
  const double shift = 0.4 - face->model->turn.pivot.z;
  const double angle = 25 * 3.14159265358979 / 180;
  EXPECT_NEAR(point_of(turned, "brow.left/spine/1").x,
              std::cos(angle) * point_of(*face, "brow.left/spine/1").x + shift * std::sin(angle),
              1e-12);
  const Expected<Face> wrong = read_face_text(with_plate(R"({"brwo": 0.4})"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(sentence(wrong.error())
                .find("/turn/plate/brwo: no feature named \"brwo\"; did you mean \"brow\"?"),
            std::string::npos)
      << sentence(wrong.error());
}

HeadTurn head_with_a_skull() {
  HeadTurn head = kTurnedHead;
  head.skull = 0.62;
  head.body = {0.2, {0.9, 0.3}};
  return head;
}

/// With the yaw outermost, what is level stays level, however the head nods.
TEST(Turn, OfAWholeHeadKeepsEyesLevel) {
  const HeadTurn head = head_with_a_skull();
  for (const double yaw : {-30.0, 12.0, 30.0})
    for (const double pitch : {-20.0, 0.0, 20.0}) {
      const Turn turn(head, yaw, pitch, 0, true);
      EXPECT_NEAR(turn.surface({-0.2, 0.1}, 0).y, turn.surface({0.2, 0.1}, 0).y, 1e-15);
      EXPECT_NEAR(turn.flat({-0.5, 0.1}, -0.1).y, turn.flat({0.5, 0.1}, -0.1).y, 1e-15);
    }
  const Turn other(kTurnedHead, 30, 20, 0, true);
  EXPECT_GT(std::abs(other.surface({-0.2, 0.1}, 0).y - other.surface({0.2, 0.1}, 0).y), 0.05);
  const Face person = face_from_recipe(recipe_from_seed(5)).value();
  const auto slant = [&](const char* yaw, const char* pitch) {
    const Face turned = face_at(person, {yaw, pitch});
    return point_of(turned, "limbus.left/center").y - point_of(turned, "limbus.right/center").y;
  };
  EXPECT_NEAR(slant("yaw=30", "pitch=20"), slant("yaw=0", "pitch=0"), 0.02);
}

/// A skull is longer than wide: seen from the side its outline goes on behind, and not in front. The far cheek has a
/// shape: at 30° the cheekbone stands out by a hundredth of the head's half-width, the temple above it is hollow by a
/// fortieth, and the jaw narrower by a twentieth.
TEST(Turn, OfAWholeHeadIsLongerBehind) {
  const HeadTurn head = head_with_a_skull();
  const Turn turn(head, 30, 0, 0, true), back(head, -30, 0, 0, true);
  const double behind = turn.flat({-0.5, 0.75}, 0.05).x;
  EXPECT_NEAR(-0.5 - behind, 2 * 0.5 * (std::sqrt(0.75 + 0.25 * 1.24 * 1.24) - 1), 1e-12);
  const auto ahead = [&](double y) { return turn.flat({0.5, y}, 0.05).x - 0.5; };
  EXPECT_NEAR(ahead(0.03), 0.005, 1e-12) << "cheekbone";
  EXPECT_NEAR(ahead(0.26), -0.0125, 1e-12) << "temple";
  EXPECT_NEAR(ahead(-0.65), -0.0225, 1e-12) << "jaw";
  EXPECT_EQ(ahead(0.5), 0) << "beneath hats";
  EXPECT_EQ(turn.flat({-0.5, 0}, 0.05).x, -0.5) << "the near ear stays";
  for (double x = -0.7; x <= 0.7; x += 0.05)
    for (double y = -0.8; y <= 0.9; y += 0.05) {
      EXPECT_EQ(turn.flat({x, y}, 0.02), glm::dvec2(-1, 1) * back.flat({-x, y}, 0.02));
      EXPECT_LT(glm::length(turn.flat({x + 1e-7, y}, 0.02) - turn.flat({x, y}, 0.02)), 3e-7);
    }
}

/// To the left is the mirror of to the right, on heads that nod and roll, and outlines go with what lies on the head.
TEST(Turn, OfAWholeHeadIsMirroredByTheYaw) {
  const HeadTurn head = head_with_a_skull();
  const glm::dvec2 mirror{-1, 1};
  for (const double yaw : {15.0, 30.0, 45.0})
    for (const double pitch : {-20.0, -10.0, 10.0, 20.0})
      for (const double roll : {0.0, 12.0}) {
        const Turn to(head, yaw, pitch, roll, true), fro(head, -yaw, pitch, -roll, true);
        for (double x = -0.45; x <= 0.45; x += 0.15)
          for (double y = -0.6; y <= 0.6; y += 0.15) {
            const glm::dvec2 p{x, y};
            EXPECT_LT(glm::length(to.surface(p, 0) - mirror * fro.surface(mirror * p, 0)), 1e-12);
            EXPECT_LT(glm::length(to.flat(p, -0.1) - mirror * fro.flat(mirror * p, -0.1)), 1e-12);
            EXPECT_LT(glm::length(to.plate(p, 0.4) - mirror * fro.plate(mirror * p, 0.4)), 1e-12);
          }
      }
  // The far eye stays beside the far edge of a head that looks down.
  const Turn down(head, -30, -20, 0, true);
  EXPECT_GT(down.surface({-0.24, 0.1}, 0).x, down.flat({-0.5, 0}, 0).x + 0.02);
}

/// Shoulders turn by a share of the yaw, and neither nod nor tilt.
TEST(Turn, ShouldersFollow) {
  const HeadTurn head = head_with_a_skull();
  const double sixth = 6 * 3.14159265358979 / 180;
  const Turn turn(head, 30, 15, 10, true);
  EXPECT_NEAR(turn.body({0, -0.8}).x, 0.3 * std::sin(sixth), 1e-12);
  EXPECT_NEAR(turn.body({0.9, -0.8}).x, 0.9 * std::cos(sixth), 1e-12);
  EXPECT_EQ(turn.body({0.4, -0.8}).y, -0.8);
  const Face person = face_from_recipe(recipe_from_seed(5)).value();
  EXPECT_GT(point_of(face_at(person, {"yaw=30"}), "neck/points/0").x,
            point_of(person, "neck/points/0").x + 0.01);
  EXPECT_EQ(point_of(face_at(person, {"pitch=20", "roll=9"}), "neck/points/0"),
            point_of(person, "neck/points/0"));
}

TEST(Turn, RefusesABodyOrSkullOfNothing) {
  const std::string text = test::text_of_face("toon");
  for (const auto& [with, what] : std::initializer_list<std::pair<std::string, std::string>>{
           {R"("skull": 0, )", "/turn/skull: a length of the head must be positive, got 0"},
           {R"("body": {"share": 2, "radii": [1, 1], "features": []}, )",
            "/turn/body/share: a share of the yaw lies between 0 and 1, got 2"},
           {R"("body": {"share": 0.2, "radii": [1, -1], "features": []}, )",
            "/turn/body/radii/1: a length of the head must be positive, got -1"},
           {R"("body": {"share": 0.2, "radii": [1, 1], "features": ["swaeter"]}, )",
            "/turn/body/features/0: no feature named \"swaeter\"; did you mean \"sweater\"?"}}) {
    std::string changed = text;
    changed.insert(changed.find("\"still\":"), with);
    const Expected<Face> wrong = read_face_text(changed);
    ASSERT_FALSE(wrong);
    EXPECT_NE(sentence(wrong.error()).find(what), std::string::npos) << sentence(wrong.error());
  }
}

TEST(Turn, RollsRigidly_G4) {
  const Turn roll(kTurnedHead, 0, 0, 30, true), down(kTurnedHead, 0, 0, 30, false);
  const glm::dvec2 pivot{0, -0.3}, p{0.2, 0.1};
  const glm::dvec2 q = roll.surface(p, 0) - pivot, r = p - pivot;
  EXPECT_NEAR(glm::length(q), glm::length(r), 1e-15);
  EXPECT_NEAR(std::atan2(q.y, q.x) - std::atan2(r.y, r.x), 3.14159265358979 / 6, 1e-12);
  EXPECT_EQ(roll.tilt(), 30);
  EXPECT_EQ(down.tilt(), -30);
  EXPECT_LT(glm::length(roll.flat(p, 0.05) - roll.surface(p, 0)), 1e-12);
}

TEST(Turn, KeepsShutEyesShutAndIsTotal_G4) {
  const Face toon = sample_face("toon");
  for (const char* yaw : {"yaw=-30", "yaw=17"}) {
    const Face shut = face_at(toon, {yaw, "pitch=25", "roll=-30", "blink=1", "gaze.x=0.06"});
    for (const char* side : {"left", "right"}) {
      const std::string eye = std::string("opening.") + side;
      EXPECT_EQ(point_of(shut, eye + "/upper"), point_of(shut, eye + "/lower"));
      for (int i = 0; i < OpeningFigure::kLidBends; ++i)
        EXPECT_EQ(point_of(shut, eye + "/upper_shift/" + std::to_string(i)),
                  point_of(shut, eye + "/lower_shift/" + std::to_string(i)));
    }
    for (const double number : shut.vector) EXPECT_TRUE(std::isfinite(number));
  }
}

}  // namespace
}  // namespace mien
