// Figures and clips of files, and what is said of those that are none.

#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <string>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

using test::BadFace;
using test::face_with;

const std::string kFigureHead =
    R"({"name": "head", "kind": "disc", "center": [0, 0], "radius": 1}, )";
const std::string kFigureCaps =
    R"({"name": "cap", "kind": "disc", "side": "left", "center": [0.4, 0], "radius": 0.3}, )";

Face figure_face(const std::string& features) {
  std::vector<Error> warnings;
  const Expected<Face> face = read_face_text(face_with(features), "f", {}, &warnings);
  if (!face) throw std::runtime_error(sentence(face.error()));
  EXPECT_TRUE(warnings.empty()) << sentence(warnings.at(0));
  return *face;
}

const std::string kFigurePath = R"("kind": "path", "points": [[0, 0], [1, 0], [0, 1]])";

TEST(FigureReader, ReadsClipsInsideAndOutside) {
  const Face face = figure_face(kFigureHead + kFigureCaps + R"({"name": "a", )" + kFigurePath +
                                R"(, "clip": "head"}, {"name": "b", "side": "left", )" +
                                kFigurePath + R"(, "clip": ["head", {"outside": "cap"}]})");
  const auto& features = face.model->features;
  ASSERT_EQ(features.size(), 6u);
  ASSERT_EQ(features[3].clips.size(), 1u);
  EXPECT_EQ(features[3].clips[0].feature.at, 0);
  EXPECT_FALSE(features[3].clips[0].outside);
  for (const int side : {0, 1}) {
    const Feature& b = features[std::size_t(4 + side)];
    ASSERT_EQ(b.clips.size(), 2u);
    EXPECT_EQ(b.clips[1].feature.at, 1 + side);  // the cap of its own side
    EXPECT_TRUE(b.clips[1].outside);
  }
}

TEST(FigureReader, ReadsAreas) {
  const Face face = figure_face(
      kFigureHead + kFigureCaps +
      R"({"name": "a", "kind": "area", "any": ["cap.left", "cap.right"], "all": ["head"], "minus": ["cap.left"]})");
  const auto& area = std::get<AreaFigure>(face.model->features[3].figure);
  ASSERT_EQ(area.any.size(), 2u);
  EXPECT_EQ(area.any[1].at, 2);
  EXPECT_EQ(area.all.at(0).at, 0);
  EXPECT_EQ(area.minus.at(0).at, 1);
  EXPECT_EQ(area.grow, -1);
}

TEST(FigureReader, ReadsHowFarAreasGrow) {
  const Face face =
      figure_face(kFigureHead + R"({"name": "a", "kind": "area", "any": ["head"], "grow": 0.07})");
  const Layout& layout = face.model->layout;
  const int grow = std::get<AreaFigure>(face.model->features[1].figure).grow;
  EXPECT_EQ(grow, layout.find("a/grow"));
  EXPECT_EQ(face.vector[std::size_t(layout[grow].begin)], 0.07);
}

TEST(FigureReader, ReadsRoundedRectanglesAndMirrorsThem) {
  const Face face = figure_face(
      R"({"name": "a", "kind": "rounded", "side": "left", "center": [0.4, 0], "radii": [0.2, 0.1], "corner": 0.05, "tilt": 8})");
  const Layout& layout = face.model->layout;
  const auto value = [&](const char* name) {
    return face.vector[std::size_t(layout[layout.find(name)].begin)];
  };
  EXPECT_EQ(value("a.right/center"), -0.4);
  EXPECT_EQ(value("a.right/tilt"), -8);
  EXPECT_EQ(value("a.right/corner"), 0.05);
}

TEST(FigureReader, SaysWhatIsWrongAndWhere) {
  const std::string disc = R"({"name": "a", "kind": "disc", "center": [0, 0], "radius": 1)";
  const BadFace table[] = {
      {face_with(kFigureHead + disc + R"(, "clip": {"outside": ^"haed"}})"),
       ": /features/1/clip/outside: no feature named \"haed\"; did you mean \"head\"?"},
      {face_with(kFigureHead + disc + R"(, "clip": ["head", ^"haed"]})"),
       ": /features/1/clip/1: no feature named \"haed\"; did you mean \"head\"?"},
      {face_with(kFigureHead + disc + R"(, "clip": ^[]})"),
       ": /features/1/clip: expected at least 1 clip, got 0"},
      {face_with(kFigureHead + disc + R"(, "clip": ^{}})"),
       ": /features/1/clip: \"outside\" is missing"},
      {face_with(kFigureHead + disc + R"(, "clip": ^5})"),
       ": /features/1/clip: expected a string, got a number"},
      {face_with(kFigureHead + R"(^{"name": "a", "kind": "area", "minus": ["head"]})"),
       ": /features/1: an area has \"all\" or \"any\": the features that it is made of"},
      {face_with(kFigureHead + R"({"name": "a", "kind": "area", "any": ^[]})"),
       ": /features/1/any: expected at least 1 feature, got 0"},
      {face_with(R"({"name": "a", "kind": "area", "any": [^"b"]}, )"
                 R"({"name": "b", "kind": "disc", "center": [0, 0], "radius": 1})"),
       ": /features/0/any/0: the feature \"b\" comes later: move it before what it is part of"},
      {face_with(R"({"name": "a", "kind": "area", "all": [^"a"]})"),
       ": /features/0/all/0: no feature named \"a\""},
      {face_with(R"(^{"name": "a", "kind": "rounded", "center": [0, 0], "radii": [1, 1]})"),
       ": /features/0: \"corner\" is missing"},
      {face_with(
           R"({"name": "a", "kind": "rounded", "center": [0, 0], "radii": [1, 1], "corner": ^-1})"),
       ": /features/0/corner: a length must not be negative, got -1"},
      {face_with(
           R"({"name": "a", "kind": "polyline", "points": [[0, 0], [1, 1], [2, 0]], "half_width": ^[0.1, 0.2]})"),
       ": /features/0/half_width: expected 1 number or one for each of 3 points, got 2"},
      {face_with(disc + R"(, "feather": ^-0.1})"),
       ": /features/0/feather: a length must not be negative, got -0.1"},
      {face_with(
           disc +
           R"(, "feather": ^0.1, "paint": {"gradient": "distance", "inside": 1, "outside": 0, "stops": [[0, "skin"], [1, "black"]]}})"),
       ": /features/0/feather: a feather softens one colour, not a gradient"},
      {face_with(disc + R"(, "shadow": {"color": "black", "blur": 0.1, "on": ^"haed"}})"),
       ": /features/0/shadow/on: no feature named \"haed\""},
      {face_with(disc + R"(, "contour": {"color": "black", "widths": ^[0.1], "by": "angle"}})"),
       ": /features/0/contour/widths: expected 2 numbers, got 1"},
      {face_with(disc +
                 R"(, "contour": {"color": "black", "widths": [0.1, 0.2], "by": ^"angel"}})"),
       ": /features/0/contour/by: no way to vary named \"angel\"; did you mean \"angle\"?"},
      {face_with(disc + R"(, "contour": ^{"color": "black", "widths": [0.1, 0.2]}})"),
       ": /features/0/contour: \"by\" is missing"},
      {face_with(disc + R"(, "contour": {"color": "black", "half_width": 0.1, "by": ^"angle"}})"),
       ": /features/0/contour/by: a contour of one half-width varies by nothing: give it "
       "\"widths\""},
      {face_with(disc + R"(, "contour": ^{"color": "black"}})"),
       ": /features/0/contour: a contour has either \"half_width\" or \"widths\""},
      {face_with(
           R"({"name": "a", "kind": "polyline", "points": [[0, 0], [1, 1]], "half_width": 0.1, "contour": {"color": "black", "widths": [0.1, 0.2], "by": ^"along"}})"),
       ": /features/0/contour/by: a contour varies \"along\" paths, openings, discs and ellipses "
       "alone; by \"angle\" along all"},
  };
  test::expect_refused(table);
}

/// Sixty areas, each of the one before it twice, would be 2⁶⁰ figures.
TEST(FigureReader, CountsTheFiguresOfAreasOfAreas) {
  std::string chain = R"({"name": "n0", "kind": "disc", "center": [0, 0], "radius": 1})";
  for (int i = 1; i <= 60; ++i) {
    const std::string before = "\"n" + std::to_string(i - 1) + "\"";
    chain += R"(, {"name": "n)" + std::to_string(i) + R"(", "kind": "area", "any": [)" + before +
             ", " + before + "]}";
  }
  EXPECT_TRUE(test::said(face_with(chain))
                  .ends_with(": its area is made of more than 10000 figures, those of its clips "
                             "counted"))
      << test::said(face_with(chain));
}

}  // namespace
}  // namespace mien
