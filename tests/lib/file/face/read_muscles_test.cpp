#include <mien/face_file.h>
#include <mien/face_model.h>
#include "lib/face/standard_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/faces/face_path.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

/// A face with an iris, a brow that has sides, a mouth that has none, and what is given behind them.
std::string muscle_face(const std::string& rest) {
  return R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c"}, "background": "skin",
"features": [
{"name": "brow", "kind": "polyline", "side": "left", "points": [[0, 0.5], [0.4, 0.5]], "half_width": 0.01},
{"name": "iris", "kind": "disc", "side": "left", "center": [0.3, 0.2], "radius": 0.1},
{"name": "mouth", "kind": "stroke", "spine": [[-0.2, -0.4], [0, -0.4], [0.2, -0.4]], "half_width": 0.01}],
"controls": [{"name": "blink", "range": [0, 1], "rest": 0, "per_side": true}], )" +
         rest + "}";
}

std::string muscles(const std::string& attach, const std::string& more = "") {
  return muscle_face(R"("muscles": {"stiffness": 20, "damping": 8, "groups": [
{"name": "lift", "side": "left", "strength": 10, "stroke": 0.1, "origin": [0.3, 1], "attach": {)" +
                     attach + "}}]}" + more);
}

std::string muscles_said(const std::string& text) {
  const Expected<Face> face = read_face_text(text, "f");
  if (face) return "a face";
  const std::string all = sentence(face.error());
  return all.substr(all.rfind(": ") == std::string::npos ? 0 : all.find(": ") + 2);
}

TEST(ReadMuscles, ReadsBothSidesAndWeldsTheAxis) {  // M1, M4, M5
  const Expected<Face> face =
      read_face_text(muscles(R"("brow/points/0": 1, "brow/points/1": 0.5, "iris/scale": 0.5)"));
  ASSERT_TRUE(face) << sentence(face.error());
  const MuscleSystem& system = face->model->muscles;
  ASSERT_EQ(system.muscles.size(), 2u);
  EXPECT_EQ(system.muscles[1].origin, (glm::dvec2{-0.3, 1}));
  ASSERT_EQ(system.points.size(), 3u);  // the middle, left, right
  EXPECT_GE(system.points[0].twin, 0);
  EXPECT_EQ(system.points[0].holds.size(), 2u);
  EXPECT_EQ(system.points[1].twin, -1);
  ASSERT_EQ(system.numbers.size(), 2u);
  EXPECT_EQ(system.numbers[0].component, -1);
  EXPECT_DOUBLE_EQ(system.numbers[0].holds[0].stroke, -0.1 / 0.1);
}

TEST(ReadMuscles, NamesTheNearestOfWhatItDoesNotKnow) {  // M4
  EXPECT_EQ(muscles_said(muscles(R"("brow/points/2": 1)")),
            "/muscles/groups/0/attach/brow~1points~12: no point or number named \"brow/points/2\"");
  EXPECT_NE(muscles_said(muscles(R"("iris/scal": 1)")).find("did you mean \"iris/scale\"?"),
            std::string::npos);
  EXPECT_NE(
      muscles_said(muscles(R"("mouth/scale": 1)")).find("only discs and ellipses have a scale"),
      std::string::npos);
  EXPECT_NE(muscles_said(muscles(R"("iris/radius": 1)")).find("a number needs a stroke"),
            std::string::npos);
  EXPECT_NE(muscles_said(muscles(R"("brow/points/0/x": 1)"))
                .find("muscles hold points as a whole: \"brow/points/0\""),
            std::string::npos);
  EXPECT_NE(muscles_said(muscles("", R"(, "emotions": {"joy": {"lifd": 1}})"))
                .find("no muscle or control named \"lifd\"; did you mean \"lift\"?"),
            std::string::npos);
  EXPECT_NE(muscles_said(muscles("", R"(, "expressions": {"arkit": {"jawOpenn": {"lift": 1}}})"))
                .find("no arkit name named \"jawOpenn\"; did you mean \"jawOpen\"?"),
            std::string::npos);
}

TEST(ReadMuscles, KeepsNumbersInBounds) {
  EXPECT_NE(
      muscles_said(muscles(R"("brow/points/0": 1.5)")).find("a weight goes from 0 to 1, got 1.5"),
      std::string::npos);
  EXPECT_NE(muscles_said(muscles("", R"(, "emotions": {"joy": {"lift": -1}})"))
                .find("a share goes from 0 to 1, got -1"),
            std::string::npos);
  EXPECT_NE(muscles_said(muscle_face(R"("muscles": {"stiffness": 0, "damping": 8, "groups": []})"))
                .find("stiffness goes from 0.001 to 1000000, got 0"),
            std::string::npos);
  EXPECT_NE(muscles_said(muscle_face(R"("muscles": {"stiffness": 1, "damping": 0, "groups": []})"))
                .find("damping goes from 0.01 to 10000, got 0"),
            std::string::npos);
}

TEST(ReadMuscles, ExpressionsPullMusclesMoveControlsAndShareEmotions) {  // M10
  const Expected<Face> face = read_face_text(muscles(R"("brow/points/0": 1)", R"(,
"emotions": {"joy": {"lift": 0.5, "blink": 0.3}},
"expressions": {"vrm": {"happy": {"joy": 0.5}, "blinkLeft": {"blink.left": 1}}, "facs": {"AU2": {"left.lift": 1}}})"));
  ASSERT_TRUE(face) << sentence(face.error());
  const auto named = [&](std::string_view name) {
    for (const Expression& one : face->model->expressions)
      if (one.name == name) return one;
    ADD_FAILURE() << name;
    return Expression{};
  };
  const Expression joy = named("emotion.joy"), happy = named("vrm.happy");
  EXPECT_NE(joy.left, joy.right);
  ASSERT_EQ(joy.moves.size(), 2u);
  EXPECT_EQ(joy.moves[0].side, Side::left);
  EXPECT_EQ(happy.left, happy.right);
  EXPECT_DOUBLE_EQ(happy.pulls[0].amount, 0.25);
  EXPECT_EQ(named("vrm.blinkLeft").moves.size(), 1u);
  EXPECT_EQ(named("facs.AU2").pulls.size(), 1u);
  // The other names of these sets do nothing; other sets are not there.
  EXPECT_TRUE(named("facs.AU64").pulls.empty() && named("facs.AU64").moves.empty());
  EXPECT_NE(named("facs.AU64").left, named("facs.AU64").right);
  EXPECT_TRUE(named("vrm.aa").pulls.empty());
  EXPECT_EQ(face->model->expressions.size(),
            1 + standard_names("vrm").size() + standard_names("facs").size());
}

TEST(ReadMuscles, AMoodIsOfEmotions) {
  const auto said = [](const std::string& mood) {
    return muscles_said(
        muscles("\"brow/points/1\": 1", R"(, "emotions": {"joy": {"lift": 1}}, "mood": )" + mood));
  };
  EXPECT_EQ(said(R"({"joy": 0.3, "comment": "light"})"), "a face");
  EXPECT_EQ(said(R"({"jov": 0.3})"), "/mood/jov: no emotion named \"jov\"; did you mean \"joy\"?");
  EXPECT_EQ(said(R"({"joy": 1.5})"), "/mood/joy: a mood goes from 0 to 1, got 1.5");
  EXPECT_EQ(said(R"({"joy": "much"})").find("/mood/joy: "), 0u);
  EXPECT_EQ(said("3").find("/mood: "), 0u);
}

TEST(ReadMuscles, ReadsTheNativeFaceWithoutAWarning) {
  std::vector<Error> warnings;
  const Expected<Face> face = read_face(test::face_path("bruno"), {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  for (const Error& warning : warnings) ADD_FAILURE() << sentence(warning);
  for (const std::string_view set : {"arkit", "vrm", "viseme"})
    for (const std::string_view name : standard_names(set)) {
      const auto found = std::find_if(face->model->expressions.begin(),
                                      face->model->expressions.end(), [&](const Expression& e) {
                                        return e.name == std::string{set} + "." + std::string{name};
                                      });
      EXPECT_NE(found, face->model->expressions.end()) << name;
    }
}

/// Truncations and bytes changed, here and there: a face or an error.
TEST(ReadMuscles, SurvivesDamage) {
  std::ifstream file(test::face_path("male"));
  std::stringstream all;
  all << file.rdbuf();
  std::string text = all.str();
  for (std::size_t length = 0; length < text.size(); length += 29 * test::kThinning) {
    const Expected<Face> face = read_face_text(text.substr(0, length));
    if (!face) {
      EXPECT_FALSE(face.error().what.empty());
    }
  }
  for (std::size_t at = 0; at < text.size(); at += 37 * test::kThinning)
    for (const char c : {'"', '}', '9', '\\'}) {
      const char was = std::exchange(text[at], c);
      const Expected<Face> face = read_face_text(text);
      if (!face) {
        EXPECT_FALSE(face.error().what.empty());
      }
      text[at] = was;
    }
}

}  // namespace
}  // namespace mien
