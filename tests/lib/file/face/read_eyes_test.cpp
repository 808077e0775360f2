// Eyes, turns and poses in a face file.

#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <string>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

using test::BadFace;
using test::expect_refused;
using test::face_with;
using test::said;

/// A face with an eye that has lids, a ball and whatever is given.
std::string eye_with(const std::string& what, const std::string& rest = "") {
  return face_with(
      R"({"name": "hole", "kind": "opening", "side": "left", "inner": [0.1, 0], "upper": [0.3, 0.3], "outer": [0.5, 0],
 "lower": [0.3, -0.3]},
{"name": "slit", "kind": "band", "side": "left", "frame": [1, 0], "lower": [1, 0], "upper": [-1, 1]},
{"name": "line", "kind": "stroke", "side": "left", "spine": ["@hole/inner", "@hole/upper", "@hole/outer"], "half_width": 0.1},
{"name": "dot", "kind": "disc", "center": [0, 0], "radius": 0.1})",
      R"(, "controls": [{"name": "blink", "range": [0, 1], "rest": 0, "per_side": true}, {"name": "size", "range": [0, 2], "rest": 1}],
"eyes": [{"name": "ball", "side": "left", "center": [0.3, 0], "radius": 0.4)" +
          what + "}]" + rest);
}

TEST(ReadEyes, SaysWhatIsWrongWithEyesTurnsAndPoses) {
  const BadFace table[] = {
      {eye_with(R"(, "bulge": ^0.1)"),
       ": /eyes/0/bulge: a bulge needs a \"cornea\": the height of its cap"},
      {eye_with(R"(, "cornea": ^0.5, "bulge": 0.1)"),
       ": /eyes/0/cornea: a cornea is no higher than its eye's radius 0.4, got 0.5"},
      {eye_with(R"(, "cornea": 0.1, "bulge": ^0.2)"),
       ": /eyes/0/bulge: a cornea of that height bulges by at most 0.133333, got 0.2"},
      {eye_with(R"(, "cornea": 0.1, "bulge": 0.1, "bulge_law": ^"nativ")"),
       ": /eyes/0/bulge_law: no law of a bulge named \"nativ\"; did you mean \"native\"?"},
      {eye_with(R"(, "reach": ^[0.1, 0.5])"),
       ": /eyes/0/reach: a gaze reaches from 0 to the eye's radius 0.4, got 0.5"},
      {eye_with(R"(, "gaze": ^["blink"])"),
       ": /eyes/0/gaze: expected two controls, for x and y, got 1"},
      {eye_with(R"(, "gaze": ["blink", ^"blnk"])"),
       ": /eyes/0/gaze/1: no control named \"blnk\"; did you mean \"blink\"?"},
      {eye_with(R"(, "gaze": ["blink", ^"size"])"),
       ": /eyes/0/gaze/1: the control \"size\" must rest at 0"},
      {eye_with(R"(, "lids": {"opening": ^"hoel"})"),
       ": /eyes/0/lids/opening: no opening named \"hoel\"; did you mean \"hole\"?"},
      {eye_with(R"(, "lids": {"opening": ^"dot"})"),
       ": /eyes/0/lids/opening: \"dot\" is no opening and no band"},
      {eye_with(R"(, "cornea": 0.1, "bulge": 0.1, "lids": {"opening": ^"slit"})"),
       ": /eyes/0/lids/opening: a bulge needs lids of the kind opening, not band"},
      {eye_with(R"(, "lids": {"opening": "hole", "meet": ^2})"),
       ": /eyes/0/lids/meet: lids meet from 0, the upper, to 1, the lower, got 2"},
      {eye_with(R"(, "lids": {"opening": "hole", "ride": {"upper": [^"dot"]}})"),
       ": /eyes/0/lids/ride/upper/0: \"dot\" is no stroke and no polyline"},
      {eye_with(
           R"(, "lids": {"opening": "hole", "crease": {"point": ^"dot/radius", "rise": 1, "fall": 1}})"),
       ": /eyes/0/lids/crease/point: \"dot/radius\" is no point"},
      {eye_with(R"(, "lids": {"opening": "hole", "raise": ^["dot"]})"),
       ": /eyes/0/lids/raise: without a bulge nothing is raised"},
      {eye_with(R"(, "cornea": 0.1, "bulge": 0.1, "lids": {"opening": "hole", "raise": [^"dto"]})"),
       ": /eyes/0/lids/raise/0: no feature named \"dto\"; did you mean \"dot\"?"},
      {eye_with("", R"(, "turn": {"pivot": [0, 0, 0], "center": [0, 0], "radii": ^[1, 0, 1]})"),
       ": /turn/radii: a radius must be positive, got 0"},
      {eye_with("", R"(, "turn": ^{"pivot": [0, 0, 0], "center": [0, 0]})"),
       ": /turn: \"radii\" is missing"},
      {eye_with(
           "",
           R"(, "turn": {"pivot": [0, 0, 0], "center": [0, 0], "radii": [1, 1, 1], "yaw": ^"blink"})"),
       ": /turn/yaw: the control that turns must have no sides and rest at 0"},
      {eye_with(
           "",
           R"(, "turn": {"pivot": [0, 0, 0], "center": [0, 0], "radii": [1, 1, 1], "flat": {"dto": ^0}})"),
       ": /turn/flat/dto: no feature named \"dto\"; did you mean \"dot\"?"},
      {eye_with(
           "",
           R"(, "turn": {"pivot": [0, 0, 0], "center": [0, 0], "radii": [1, 1, 1], "still": [^"dot/centre"]})"),
       ": /turn/still/0: no number named \"dot/centre\"; did you mean \"dot/center\"?"},
      {eye_with("", R"(, "poses": {"sad": {"slices": {"hole/uper": ^[0, 0]}}})"),
       ": /poses/sad/slices/hole~1uper: no number named \"hole/uper\"; did you mean "
       "\"hole/upper\"?"},
      {eye_with("", R"(, "poses": {"sad": {"slices": {"hole/upper": ^[0]}}})"),
       ": /poses/sad/slices/hole~1upper: expected 2 numbers, got 1"},
      {eye_with("", R"(, "poses": {"sad": {"controls": {"blnk": ^1}}})"),
       ": /poses/sad/controls/blnk: no control named \"blnk\"; did you mean \"blink\"?"},
      {eye_with("", R"(, "poses": {"sad": {}, "mad": {"controls": {"sad": ^1}}})"),
       ": /poses/mad/controls/sad: a pose moves slices and controls, not other poses"},
      {eye_with("", R"(, "poses": {"blink": ^{}})"),
       ": /poses/blink: there is a control \"blink\" already"},
      {eye_with("", R"(, "poses": {"sad": {"range": ^[0.5, 1]}})"),
       ": /poses/sad/range: the range of a pose must hold 0, where the face rests, got 0.5 to 1"},
  };
  expect_refused(table);
  EXPECT_EQ(said(eye_with(
                R"(, "cornea": 0.1, "bulge": 0.1, "lids": {"opening": "hole", "blink": "blink"})")),
            "a face");
}

TEST(ReadEyes, GivesLidsAndTheirStrokesTheirShifts) {
  const Expected<Face> face = read_face_text(
      eye_with(R"(, "cornea": 0.1, "bulge": 0.1, "lids": {"opening": "hole", "blink": "blink"})"));
  ASSERT_TRUE(face) << sentence(face.error());
  ASSERT_EQ(face->model->eyes.size(), 2u);
  for (const Eye& eye : face->model->eyes) {
    ASSERT_GE(eye.shifts, 0);
    const Layout& layout = face->model->layout;
    EXPECT_EQ(layout[eye.shifts].name,
              "hole." + std::string(side_name(eye.side)) + "/upper_shift/0");
    for (const Feature& f : face->model->features)
      if (const auto* line = std::get_if<StrokeFigure>(&f.figure); line && f.side == eye.side) {
        EXPECT_EQ(line->shifts, eye.shifts);
      }
  }
  EXPECT_EQ(face->model->eyes[1].name, "ball.right");
  const int center = face->model->layout.find("ball.right/center");
  EXPECT_EQ(face->vector[std::size_t(face->model->layout[center].begin)], -0.3);
}

}  // namespace
}  // namespace mien
