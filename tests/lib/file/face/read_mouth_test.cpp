#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

const std::string kPlainMouth =
    R"("corners": ["lip/spine/2", "lip/spine/0"], "upper": ["lip/spine/1"], "lower": ["under"], "jaw": {"drop": 0.3})";

/// A face whose mouth is one opening between two strokes, and a mouth of these members.
std::string mouth_face(const std::string& mouth, const std::string& more = "") {
  std::string text =
      R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c", "red": "#aa2211"}, "background": "skin",
"features": [
{"name": "head", "kind": "disc", "center": [0, 0], "radius": 0.9},
{"name": "lip", "kind": "stroke", "spine": [[-0.3, -0.4], [0, -0.5], [0.3, -0.4]], "half_width": 0.01},
{"name": "lower", "kind": "stroke", "spine": ["@lip/spine/0", [0, -0.5], "@lip/spine/2"], "half_width": 0.01},
{"name": "tongue", "kind": "path", "paint": "red", "points": [[0, 0, "bend"], [0.1, 0, "bend"], [0, 0.1, "bend"]]},
{"name": "mouth", "kind": "path", "paint": "red", "points": ["@lip/spine/0", ["@lip/spine/1", "bend"], "@lip/spine/2", ["@lower/spine/1", "bend"]]}],
"mouth": {)" +
      mouth + "}" + more + "}";
  if (const std::size_t at = text.find("\"under\""); at != std::string::npos)
    text.replace(at, 7, "\"lower/spine/1\"");
  return text;
}

std::string mouth_said(const std::string& mouth, const std::string& more = "") {
  const Expected<Face> face = read_face_text(mouth_face(mouth, more), "f");
  if (face) return "a face";
  const std::string all = sentence(face.error());
  return all.substr(all.find(": ") + 2);
}

TEST(ReadMouth, GivesAnyFaceAMouth) {
  const Face face = read_face_text(mouth_face(kPlainMouth), "f").value();
  ASSERT_TRUE(face.model->mouth);
  EXPECT_FALSE(face.model->mouth->has_handles);
  const Face open = test::face_at(face, {"jaw.open=1"});
  EXPECT_DOUBLE_EQ(test::point_of(open, "lower/spine/1").y, -0.8);
  EXPECT_EQ(test::point_of(open, "lip/spine/1").y, -0.5);
  EXPECT_EQ(test::point_of(open, "head/center"), glm::dvec2(0));
  const Face shut = test::face_at(face, {"jaw.open=1", "mouth.close=1"});
  EXPECT_EQ(test::point_of(shut, "lower/spine/1"), test::point_of(shut, "lip/spine/1"));
}

TEST(ReadMouth, LetsPointsGoWithTheJawAndRide) {
  const Face face =
      read_face_text(
          mouth_face(
              kPlainMouth.substr(0, kPlainMouth.size() - 1) +
              R"(, "shares": {"head/center": [0.5, 0]}}, "ride": {"tongue/points/0": {"lower/spine/1": 0.5}})"),
          "f")
          .value();
  const Face open = test::face_at(face, {"jaw.open=1"});
  EXPECT_DOUBLE_EQ(test::point_of(open, "head/center").y, -0.15);
  EXPECT_DOUBLE_EQ(test::point_of(open, "tongue/points/0").y, -0.15);
}

TEST(ReadMouth, NamesWhatIsWrong) {
  EXPECT_EQ(mouth_said(R"("corners": ["lip/spine/2"])"),
            "/mouth/corners: expected two corners, left and right, got 1");
  EXPECT_EQ(mouth_said(R"("corners": ["lip/spine/2", "lop/spine/0"])"),
            "/mouth/corners/1: no number named \"lop/spine/0\"; did you mean \"lip/spine/0\"?");
  const std::string corners = R"("corners": ["lip/spine/2", "lip/spine/0"], )";
  EXPECT_EQ(
      mouth_said(corners + R"("upper": ["lip/spine/1", "lip/spine/1"])"),
      "/mouth/upper: an edge has one bend, or a left handle, a middle and a right handle, got 2");
  EXPECT_EQ(mouth_said(corners + R"("upper": ["lip/half_width"])"),
            "/mouth/upper/0: \"lip/half_width\" is no point");
  EXPECT_EQ(mouth_said(kPlainMouth + R"(, "seam": 2)"),
            "/mouth/seam: lips meet from 0, the upper lip, to 1, the lower, got 2");
  EXPECT_EQ(mouth_said(kPlainMouth + R"(, "tongue": {"out": "tongue"})"),
            "/mouth/tongue/out: \"tongue\" needs an \"opacity\", 0 at rest");
  EXPECT_EQ(mouth_said(kPlainMouth + R"(, "tongue": {"body": "tongue"})"),
            "/mouth/tongue/body: \"tongue\" is no ellipse");
  EXPECT_EQ(mouth_said(kPlainMouth + R"(, "stiff": ["head/center"])"),
            "/mouth/stiff/0: \"head/center\" does not ride");
  EXPECT_EQ(mouth_said(kPlainMouth + R"(, "ride": {"lip/spine/1": {}})"),
            "/mouth/ride/lip~1spine~11: corners and edges ride on nothing");
}

TEST(ReadMouth, DividesAnAmountByAnotherExpression) {
  const auto of = [&](const std::string& table) {
    return mouth_said(kPlainMouth, R"(, "expressions": {"own": {)" + table + "}}");
  };
  EXPECT_EQ(of(R"("shut": {"mouth.close": {"amount": 1, "per": "open"}}, "open": {"jaw.open": 1})"),
            "a face");
  EXPECT_EQ(
      of(R"("shut": {"mouth.close": {"amount": 1, "per": "opan"}}, "open": {"jaw.open": 1})"),
      "/expressions/own/shut/mouth.close/per: no own name named \"opan\"; did you mean \"open\"?");
  EXPECT_EQ(of(R"("open": {"jaw.open": 1.5})"),
            "/expressions/own/open/jaw.open: a share goes from 0 to 1, got 1.5");
}

/// Slices that are one point may be set one by one; whoever reads the file hears of it.
TEST(ReadMouth, WarnsOfTwoPlacesOfOnePoint) {
  std::string mouth = kPlainMouth;
  mouth.replace(mouth.find("\"lip/spine/1\""), 13, "[\"lip/spine/1\", \"head/center\"]");
  std::vector<Error> warnings;
  const Expected<Face> face = read_face_text(mouth_face(mouth), "f", {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(sentence(warnings[0])
                  .ends_with("/mouth/upper/0: the two slices of one point have different places"))
      << sentence(warnings[0]);
  const Face shut = test::face_at(*face, {"mouth.close=1"});
  EXPECT_EQ(test::point_of(shut, "lip/spine/1"), test::point_of(shut, "head/center"));
  EXPECT_EQ(test::point_of(shut, "lip/spine/1"), test::point_of(shut, "lower/spine/1"));
}

}  // namespace
}  // namespace mien
