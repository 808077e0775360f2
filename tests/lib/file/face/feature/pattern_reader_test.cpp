#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

using test::BadFace;
using test::face_with;

std::string scatter_with(const std::string& count, const std::string& rest) {
  return face_with(
      R"({"name": "a", "kind": "scatter", "side": "left", "patch": [[[0.1, 0], [0.5, 0]], [[0.1, 0.4], [0.5, 0.4]]], "count": )" +
      count + R"(, "of": "ellipse", "radii": [0.1, 0.2])" + rest + "}");
}
const std::string kSquarePatch = R"("patch": [[[0, 0], [1, 0]], [[0, 1], [1, 1]]])";

TEST(PatternReader, PutsFewNumbersInTheVector) {
  const Expected<Face> face = read_face_text(
      scatter_with("2000", R"(, "tilt": 20, "seed": 7, "jitter": 0.5, "vary": 0.25, "sway": 90)"));
  ASSERT_TRUE(face) << sentence(face.error());
  const Layout& layout = face->model->layout;
  int own = 0;
  for (const Slice& slice : layout.slices()) own += slice.name.starts_with("a.left/");
  EXPECT_EQ(own, 6);  // four points, the radii, the tilt
  const auto& figure = std::get<ScatterFigure>(face->model->features[1].figure);
  EXPECT_EQ(figure.columns, 2000);
  EXPECT_EQ(figure.rows, 0);
  EXPECT_EQ(figure.chance.seed, 7u);
  EXPECT_EQ(figure.chance.jitter, 0.5);
  EXPECT_EQ(figure.chance.vary, 0.25);
  EXPECT_EQ(figure.chance.sway, 90);
  EXPECT_TRUE(figure.chance.mirrored);
  EXPECT_EQ(face->vector[std::size_t(layout[layout.find("a.right/patch/1/0")].begin)], -0.1);
  EXPECT_EQ(face->vector[std::size_t(layout[layout.find("a.right/tilt")].begin)], -20);
}

TEST(PatternReader, SaysWhatIsWrongAndWhere) {
  const std::string repeat = R"({"name": "a", "kind": "repeat", "points": [[0, 0], [1, 1]], )";
  const std::string stripes = R"({"name": "a", "kind": "stripes", )";
  const BadFace table[] = {
      {scatter_with("^1000000000", ""),
       ": /features/0/count: a pattern has at most 4000 figures, got 1000000000"},
      {scatter_with("^[100, 41]", ""),
       ": /features/0/count: a pattern has at most 4000 figures, got 100 times 41"},
      {scatter_with("^[1, 2, 3]", ""),
       ": /features/0/count: expected one count, or two: along and across; got 3"},
      {scatter_with("^0", ""), ": /features/0/count: a count is a whole number from 1, got 0"},
      {scatter_with("[^2.5, 1]", ""),
       ": /features/0/count/0: a count is a whole number from 1, got 2.5"},
      {scatter_with("5", R"(, "jitter": ^2)"),
       ": /features/0/jitter: \"jitter\" goes from 0 to 1, got 2"},
      {scatter_with("5", R"(, "sway": ^-1)"),
       ": /features/0/sway: \"sway\" goes from 0 to 180, got -1"},
      {scatter_with("5", R"(, "seed": ^0.5)"),
       ": /features/0/seed: a seed is a whole number from 0 to 4294967295, got 0.5"},
      {scatter_with("5", R"(, "stagger": ^true)"),
       ": /features/0/stagger: only a lattice is staggered: a count of two numbers"},
      {scatter_with("[5, 5]", R"(, "round": ^true)"),
       ": /features/0/round: a lattice is not round: a count of one number is"},
      {face_with(repeat + R"("count": 2, "of": ^"dics", "radius": 1})"),
       ": /features/0/of: no figure of a pattern named \"dics\"; did you mean \"disc\"?"},
      {face_with("^" + repeat + R"("count": 2, "of": "disc"})"),
       ": /features/0: \"radius\" is missing"},
      {face_with("^" + repeat + R"("of": "disc", "radius": 1})"),
       ": /features/0: \"count\" is missing"},
      {face_with(
           R"({"name": "a", "kind": "repeat", "points": ^[[0, 0]], "count": 2, "of": "disc", "radius": 1})"),
       ": /features/0/points: expected at least 2 points, got 1"},
      {face_with(stripes + R"("count": 2, "half_width": 1, "patch": ^[[[0, 0], [1, 1]]]})"),
       ": /features/0/patch: expected 2 or 3 rows of points, got 1"},
      {face_with(
           stripes +
           R"("count": 2, "half_width": 1, "patch": [[[0, 0], [1, 1]], ^[[0, 0], [1, 1], [2, 2]]]})"),
       ": /features/0/patch/1: all rows have as many points as the first, 2; got 3"},
      {face_with(stripes + kSquarePatch + R"(, "count": 2, "half_width": ^[1, 2]})"),
       ": /features/0/half_width: expected 1 or 3 numbers, got 2"},
  };
  test::expect_refused(table);
}

/// A thousand patterns of four thousand figures each would be drawn for hours.
TEST(PatternReader, CountsTheFiguresOfAllPatterns) {
  const auto two = [](int first, int second) {
    const auto pattern = [](const char* name, int count) {
      return fmt::format(
          R"({{"name": "{}", "kind": "stripes", "side": "left", {}, "count": {}, "half_width": 1}})",
          name, kSquarePatch, count);
    };
    return face_with(pattern("a", first) + ", " + pattern("b", second));
  };
  EXPECT_TRUE(read_face_text(two(1500, 500), "f"));
  EXPECT_TRUE(test::said(two(1500, 501))
                  .ends_with(": /features/1: the patterns of a face have at most 4000 figures in "
                             "all, left and right counted; with this one it is 4002"))
      << test::said(two(1500, 501));
}

/// A thousand features clipped to one pattern would each be asked about all of its figures.
TEST(PatternReader, CountsTheFiguresOfAreasInAll) {
  std::string features =
      R"({"name": "p", "kind": "stripes", "count": 4000, "half_width": 1, )" + kSquarePatch + "}";
  for (int i = 0; i < 30; ++i)
    features += fmt::format(
        R"(, {{"name": "d{}", "kind": "disc", "center": [0, 0], "radius": 1, "clip": "p"}})", i);
  EXPECT_TRUE(test::said(face_with(features))
                  .ends_with(": areas made of patterns and of other areas have more than 100000 "
                             "figures in all (limit: features)"))
      << test::said(face_with(features));
}

}  // namespace
}  // namespace mien
