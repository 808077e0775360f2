#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

std::string painted_face(const std::string& features, const std::string& rest = "") {
  return R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c", "black": [0, 0, 0]}, "background": "skin",
)" + rest +
         R"("features": [)" + features + "]}";
}

std::string disc_with(const std::string& more) {
  return R"({"name": "iris", "kind": "disc", "side": "left", "center": [0.2, 0.1], "radius": 0.1, )" +
         more + "}";
}

std::string paint_said(const std::string& text) {
  const Expected<Face> face = read_face_text(text, "f");
  return face ? "a face" : sentence(face.error());
}

Face read(const std::string& text) {
  std::vector<Error> warnings;
  const Expected<Face> face = read_face_text(text, "f", {}, &warnings);
  if (!face) throw std::runtime_error(sentence(face.error()));
  EXPECT_TRUE(warnings.empty()) << sentence(warnings.at(0));
  return *face;
}

double number(const Face& face, const std::string& slice, int i) {
  const int found = face.model->layout.find(slice);
  if (found < 0) throw std::runtime_error("no " + slice);
  return face.vector[std::size_t(face.model->layout[found].begin + i)];
}

TEST(ReadPaint, ReadsGradientsOfEverySide) {  // E13
  const Face face = read(painted_face(disc_with(
      R"("paint": {"gradient": "radial", "center": "@iris/center", "radii": [0.1, 0.2], "tilt": 30,
                   "stops": [[0, "skin"], [0.5, "black"], [1, "skin"]], "extend": "reflect"})")));
  ASSERT_EQ(face.model->gradients.size(), 2u);
  const Feature& right = face.model->features.at(1);
  EXPECT_EQ(right.paint, -1);
  EXPECT_TRUE(right.painted());
  const GradientPaint& gradient = face.model->gradients.at(std::size_t(right.gradient.at));
  EXPECT_EQ(gradient.extend, GradientPaint::Extend::reflect);
  EXPECT_EQ(gradient.colors.size(), 3u);
  EXPECT_EQ(std::get<RadialPaint>(gradient.along).center,
            face.model->layout.find("iris.right/center"));
  EXPECT_EQ(number(face, "iris.left/paint/tilt", 0), 30);
  EXPECT_EQ(number(face, "iris.right/paint/tilt", 0), -30);
  EXPECT_EQ(number(face, "iris.right/paint/places", 1), 0.5);
}

TEST(ReadPaint, MirrorsAGradientsPointsAndTakesOverrides) {
  const Face face = read(painted_face(disc_with(
      R"("paint": {"gradient": "linear", "from": [0.1, 0], "to": [0.3, 0], "stops": [[0, "skin"], [1, "black"]]},
         "opacity": 0.5, "right": {"opacity": 0.25})")));
  EXPECT_EQ(number(face, "iris.right/paint/from", 0), -0.1);
  EXPECT_EQ(number(face, "iris.left/opacity", 0), 0.5);
  EXPECT_EQ(number(face, "iris.right/opacity", 0), 0.25);
}

TEST(ReadPaint, ReadsReliefsAndTheLight) {  // G3, C
  const Face face = read(painted_face(
      disc_with(R"("paint": "black", "relief": {"profile": "custom", "width": 0.05, "height": 0.02,
                   "table": [0, 0.8, 1], "specular": 0.4, "shininess": 12, "sunk": true,
                   "domes": [{"center": "@iris/center", "radii": [0.04, 0.04], "height": 0.01}]})"),
      R"("light": {"direction": [1, 2, 3], "ambient": 0.2}, )"));
  const FaceRelief& relief = face.model->reliefs.at(0);
  EXPECT_EQ(relief.profile, FaceRelief::Profile::custom);
  EXPECT_TRUE(relief.sunk);
  ASSERT_EQ(relief.domes.size(), 1u);
  EXPECT_EQ(relief.domes[0].center, face.model->layout.find("iris.left/center"));
  EXPECT_EQ(number(face, "iris.left/relief/table", 1), 0.8);
  EXPECT_EQ(number(face, "iris.right/relief/domes/0/height", 0), 0.01);
  EXPECT_EQ(face.model->light.direction, glm::dvec3(1, 2, 3));
  EXPECT_EQ(face.model->light.ambient, 0.2);
  const Face plain = read(
      painted_face(disc_with(R"("paint": "black")"), R"("light": {"direction": [1, 2, 3]}, )"));
  EXPECT_EQ(plain.model->light.ambient, 0.35);  // as docs/face-format.md has it
}

TEST(ReadPaint, ReadsWhatFollowsAnOutline) {
  const Face face = read(painted_face(disc_with(
      R"("paint": "black", "shadow": {"color": "black", "blur": 0.1, "shift": [0.02, -0.03]},
                   "glow": {"color": "skin", "reach": 0.2}, "right": {"glow": {"color": "skin", "reach": 0.3}})")));
  ASSERT_EQ(face.model->surroundings.size(), 2u);
  EXPECT_EQ(number(face, "iris.left/shadow/shift", 0), 0.02);
  EXPECT_EQ(number(face, "iris.right/shadow/shift", 0), 0.02);  // one lamp
  EXPECT_EQ(number(face, "iris.left/glow/reach", 0), 0.2);
  EXPECT_EQ(number(face, "iris.right/glow/reach", 0), 0.3);
  EXPECT_FALSE(face.model->surroundings[0].contour);
  EXPECT_EQ(paint_said(painted_face(disc_with(R"("glow": {"color": "skin", "reach": 0})"))),
            "f:3:135: /features/0/glow/reach: expected more than 0");
  EXPECT_EQ(
      paint_said(painted_face(disc_with(R"("contour": {"color": "skn", "half_width": 0.1})"))),
      "f:3:121: /features/0/contour/color: no palette colour named \"skn\"; did you mean "
      "\"skin\"?");
}

const std::string kHead =
    R"({"name": "head", "kind": "disc", "paint": "skin", "center": [0, 0], "radius": 0.9})";
const std::string kLens =
    R"({"name": "lens", "kind": "disc", "paint": "black", "group": "glasses", "center": [0, 0], "radius": 0.2})";

TEST(ReadPaint, ReadsGroups) {
  const Face face = read(painted_face(
      kHead + "," + kLens,
      R"("groups": {"glasses": {"opacity": 0.5, "mix": "screen", "clip": "head"}, "rim": {}}, )"));
  ASSERT_EQ(face.model->groups.size(), 2u);
  EXPECT_EQ(face.model->groups[0].mix, MixMode::screen);
  EXPECT_EQ(face.model->groups[1].mix, MixMode::normal);
  EXPECT_EQ(face.model->groups[0].clip.at, 0);
  EXPECT_EQ(number(face, "groups/glasses/opacity", 0), 0.5);
  EXPECT_EQ(face.model->features.at(1).group.at, 0);
}

TEST(ReadPaint, SaysWhatIsWrongAndWhere) {
  const auto paint = [](const std::string& what) {
    return paint_said(painted_face(disc_with("\"paint\": " + what)));
  };
  EXPECT_EQ(paint(R"({"gradient": "radail"})"),
            "f:3:122: /features/0/paint/gradient: no gradient named \"radail\"; did you mean "
            "\"radial\"?");
  EXPECT_EQ(
      paint(R"({"gradient": "linear", "from": [0, 0], "to": [1, 0], "stops": [[0, "skin"]]})"),
      "f:3:171: /features/0/paint/stops: expected at least 2 stops, got 1");
  EXPECT_EQ(
      paint(
          R"({"gradient": "linear", "from": [0, 0], "to": [1, 0], "stops": [[1, "skin"], [0, "black"]]})"),
      "f:3:185: /features/0/paint/stops/1: places must not fall, got 0 after 1");
  EXPECT_EQ(
      paint(
          R"({"gradient": "linear", "from": [0, 0], "to": [1, 0], "stops": [[0, "skin"], [1, "blck"]]})"),
      "f:3:189: /features/0/paint/stops/1/1: no palette colour named \"blck\"; did you mean "
      "\"black\"?");
  const auto relief = [](const std::string& what) {
    return paint_said(painted_face(disc_with("\"relief\": " + what)));
  };
  EXPECT_EQ(relief(R"({"profile": "round", "width": 0, "height": 1})"),
            "f:3:140: /features/0/relief/width: expected more than 0");
  EXPECT_EQ(relief(R"({"profile": "custom", "width": 1, "height": 1, "table": [1]})"),
            "f:3:166: /features/0/relief/table: expected 2 to 1000 numbers, got 1");
  EXPECT_EQ(paint_said(painted_face(disc_with(R"("opacity": 1.5)"))),
            "f:3:111: /features/0/opacity: an opacity goes from 0 to 1, got 1.5");
  EXPECT_EQ(paint_said(painted_face(kHead, R"("light": {"direction": [0, 0, -1]}, )")),
            "f:3:24: /light/direction: a lamp shines from the front: the third number must be more "
            "than 0");
  const std::string groups = R"("groups": {"glasses": {"clip": "head"}}, )";
  EXPECT_EQ(paint_said(painted_face(kLens + "," + kHead, groups)),
            "f:3:32: /groups/glasses/clip: the feature \"head\" must come before the group that it "
            "clips");
  EXPECT_EQ(paint_said(painted_face(kHead, R"("groups": {"glasses": {"mix": "mulitply"}}, )")),
            "f:3:31: /groups/glasses/mix: no way to mix named \"mulitply\"; did you mean "
            "\"multiply\"?");
  std::string second = kLens;
  second.replace(second.find("lens"), 4, "glow");
  EXPECT_EQ(
      paint_said(
          painted_face(kLens + "," + kHead + "," + second, R"("groups": {"glasses": {}}, )")),
      "f:3:288: /features/2/group: the features of the group \"glasses\" must stand together");
}

}  // namespace
}  // namespace mien
