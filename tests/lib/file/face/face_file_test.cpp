#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/faces/face_path.h"
#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

using test::BadFace;
using test::expect_refused;
using test::face_with;
using test::said;
using test::take_mark;

constexpr const char* kSamples[] = {"seed0", "toon", "male", "bruno", "clay"};

std::string path_of(const std::string& name) {
  return test::face_path(name);
}

const std::string kIris =
    R"({"name": "iris", "kind": "disc", "side": "left", "center": [0.2, 0], "radius": 0.1})";

std::string control_with(const std::string& what) {
  return face_with(kIris, R"(,
"controls": [{"name": "look", "range": [0, 1], "rest": 0, "per_side": true, )" +
                              what + "}]");
}

std::string clip_with(const std::string& what) {
  return face_with(kIris, R"(, "controls": [{"name": "look", "range": [0, 1], "rest": 0}],
"clips": {"idle": )" + what + "}");
}

TEST(ReadFace, ReadsTheSamplesWithoutAWarning_E15) {
  for (const char* name : kSamples) {
    std::vector<Error> warnings;
    const Expected<Face> face = read_face(path_of(name), {}, &warnings);
    ASSERT_TRUE(face) << sentence(face.error());
    for (const Error& warning : warnings) ADD_FAILURE() << sentence(warning);
    EXPECT_EQ(face->model->name, name);
    EXPECT_FALSE(face->model->credit.empty());
    EXPECT_EQ(face->vector.size(), face->model->layout.size());
  }
}

/// They can do what the faces of version 1 could.
TEST(ReadFace, ReadsTheSampleRecipesWithoutAWarning) {
  for (const char* name : {"toon", "bruno", "clay"}) {
    SCOPED_TRACE(name);
    std::vector<Error> warnings;
    const Expected<Face> face = read_face(path_of(std::string("faces/") + name), {}, &warnings);
    ASSERT_TRUE(face) << sentence(face.error());
    for (const Error& warning : warnings) ADD_FAILURE() << sentence(warning);
    EXPECT_EQ(face->model->name, name);
    for (const char* setting : {"gaze.x=0.04", "gaze.y=0.02", "blink.left=1", "yaw=20", "pitch=-20",
                                "emotion.left.surprise=0.3"})
      EXPECT_TRUE(read_setting(*face, setting)) << setting;
    EXPECT_TRUE(read_look_at(*face, "0.5,0.3,1"));
    ASSERT_TRUE(face->model->default_clip);
    EXPECT_EQ(face->model->default_clip.in(face->model->clips).name, "idle");
  }
}

TEST(ReadFace, ReadsColoursAsLinearLight) {
  const Expected<Face> face = read_face_text(face_with(""));
  ASSERT_TRUE(face);
  const int skin = face->model->layout.find("palette/skin");
  ASSERT_EQ(skin, face->model->background);
  EXPECT_NEAR(face->vector[0], std::pow((247 / 255.0 + 0.055) / 1.055, 2.4), 1e-15);
  EXPECT_EQ(face->vector[3], 1);
}

/// The example on the format's page is a face, without a warning.
TEST(ReadFace, ReadsTheExampleOfItsPage) {
  std::ifstream file(MIEN_SOURCE_DIR "/docs/face-format.md");
  std::stringstream page;
  page << file.rdbuf();
  const std::string text = page.str(), fence = "```json\n";
  const std::size_t begin = text.find(fence) + fence.size();
  ASSERT_GT(text.find("```", begin), begin);
  std::vector<Error> warnings;
  const Expected<Face> face =
      read_face_text(text.substr(begin, text.find("```", begin) - begin), "f", {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(face->model->features.size(), 4u);
}

TEST(ReadFace, MirrorsOneSideToTheOther) {
  const Expected<Face> face = read_face_text(face_with(kIris));
  ASSERT_TRUE(face);
  const FaceModel& model = *face->model;
  ASSERT_EQ(model.features.size(), 2u);
  EXPECT_EQ(model.features[0].name, "iris.left");
  EXPECT_EQ(model.features[1].name, "iris.right");
  EXPECT_EQ(face->vector[std::size_t(model.layout[model.layout.find("iris.right/center")].begin)],
            -0.2);
}

TEST(ReadFace, TakesOneSideAloneAndOverrides) {
  const Expected<Face> face = read_face_text(face_with(
      R"({"name": "scar", "kind": "disc", "side": "left", "mirror": false, "center": [0.2, 0], "radius": 0.1},
         {"name": "eye", "kind": "disc", "side": "left", "center": [0.2, 0], "radius": 0.1, "right": {"radius": 0.2}})"));
  ASSERT_TRUE(face) << sentence(face.error());
  const Layout& layout = face->model->layout;
  EXPECT_GE(layout.find("scar.left/center"), 0);
  EXPECT_EQ(layout.find("scar.right/center"), -1);
  EXPECT_EQ(face->vector[std::size_t(layout[layout.find("eye.right/radius")].begin)], 0.2);
  EXPECT_EQ(face->vector[std::size_t(layout[layout.find("eye.right/center")].begin)], -0.2);
}

TEST(ReadFace, SharesPointsByReference) {
  const Expected<Face> face = read_face(path_of("toon"));
  ASSERT_TRUE(face);
  const auto feature = [&](std::string_view name) {
    for (const Feature& f : face->model->features)
      if (f.name == name) return f;
    throw std::runtime_error("no feature");
  };
  for (const char* side : {".left", ".right"}) {
    const auto opening = std::get<OpeningFigure>(feature(std::string("opening") + side).figure);
    const auto lid = std::get<StrokeFigure>(feature(std::string("upper_lid") + side).figure);
    EXPECT_EQ(lid.spine[0], opening.inner);  // ONE lid curve: the very same numbers
    EXPECT_EQ(lid.spine[1], opening.upper);
    EXPECT_EQ(lid.spine[2], opening.outer);
  }
}

/// Every refusal: its place, its pointer and its words.
TEST(ReadFace, SaysWhatIsWrongAndWhere) {
  const std::string version = R"({"format": "mien-face", "format_version": )";
  const std::string canvas = version + R"(1, "canvas": )";
  const std::string disc = R"({"name": "a", "kind": "disc", "center": [0, 0], "radius": 1)";
  const std::string marked_disc = R"({"name": ^"a", "kind": "disc", "center": [0, 0], "radius": 1)";
  const BadFace table[] = {
      {"^", ": the file is empty"},
      {" \n ^", ": the file is empty"},
      {"{^",
       ": malformed JSON: syntax error while parsing object key - unexpected end of input; "
       "expected string literal"},
      {R"({"format": "mien-face",^})",
       ": malformed JSON: syntax error while parsing object key - unexpected '}'; expected string "
       "literal"},
      {R"({"a": ^NaN})",
       ": malformed JSON: syntax error while parsing value - invalid literal; last read: '\"a\": "
       "N'"},
      {"{\"^\xFF\": 1}",
       ": malformed JSON: syntax error while parsing object key - invalid string: ill-formed UTF-8 "
       "byte; last read: '\"\\xFF'; expected string literal"},
      {"^[]", ": expected an object, got an array"},
      {R"({"a": 1, ^"a": 2})", ": /a: the key \"a\" stands here twice"},
      {R"({"a~/b": {"c": 1, ^"c": 2}})", ": /a~0~1b/c: the key \"c\" stands here twice"},
      {R"({"ö": 1, ^"ö": 1})", ": /ö: the key \"ö\" stands here twice"},
      {R"({"a": 1e99^9})", ": 1e999 is too large for a number"},
      {R"({"a": [0, ^-1e10]})",
       ": /a/1: -10000000000 is too large: numbers go from -1000000000 to 1000000000 (limit: "
       "magnitude)"},
      {"^{}", ": \"format\" is missing"},
      {R"({"format": ^"svg"})", ": /format: expected \"mien-face\", got \"svg\""},
      {version + "^3}",
       ": /format_version: format version 3 is newer than this program, which reads 1 and 2"},
      {version + "^1.5}", ": /format_version: expected the integer 1 or 2, got 1.5"},
      {version + "^\"1\"}", ": /format_version: expected a number, got a string"},
      {canvas + R"({"x": ^[1, 1]}})", ": /canvas/x: expected two rising numbers, got 1 and 1"},
      {canvas + R"(^{"x": [0, 1e-10], "y": [0, 1]}})",
       ": /canvas: a canvas must be at least 1e-09 wide and high"},
      {canvas + R"(^{"x": [0, 1e8], "y": [0, 1]}})",
       ": /canvas: a canvas must not be more than 1000000 times longer than wide"},
      {canvas + R"({"x": [0, 1], "y": [0, 1], "y_axis": ^"upp"}})",
       ": /canvas/y_axis: no y_axis named \"upp\"; did you mean \"up\"?"},
      {face_with("^5"), ": /features/0: expected an object, got a number"},
      {face_with("^{}"), ": /features/0: \"kind\" is missing"},
      {face_with(R"({"kind": ^"elipse"})"),
       ": /features/0/kind: no kind of feature named \"elipse\"; did you mean \"ellipse\"?"},
      {face_with(R"(^{"kind": "disc"})"), ": /features/0: \"name\" is missing"},
      {face_with(R"({"kind": "disc", "name": ^"a/b"})"),
       ": /features/0/name: the name \"a/b\" must have no spaces and none of / @ = , \" \\"},
      {face_with(R"({"kind": "disc", "name": ^""})"),
       ": /features/0/name: a name must not be empty"},
      {face_with(R"({"kind": "disc", "name": ^"a.left"})"),
       ": /features/0/name: the name \"a.left\" is taken: no feature may be called palette or "
       "groups or end "
       "in .left or .right"},
      {face_with(R"({"kind": "disc", "name": "a", "center": ^[0], "radius": 1})"),
       ": /features/0/center: expected 2 numbers, got 1"},
      {face_with(R"({"kind": "disc", "name": "a", "center": [0, ^"0"], "radius": 1})"),
       ": /features/0/center/1: expected a number, got a string"},
      {face_with(R"({"kind": "disc", "name": "a", "center": [0, 0], "radius": ^-1})"),
       ": /features/0/radius: a length must not be negative, got -1"},
      {face_with(R"(^{"kind": "disc", "name": "a", "center": [0, 0]})"),
       ": /features/0: \"radius\" is missing"},
      {face_with(R"({"kind": "stroke", "name": "a", "spine": ^[[0, 0], [1, 1]], "half_width": 1})"),
       ": /features/0/spine: expected 3 points, got 2"},
      {face_with(
           R"({"kind": "stroke", "name": "a", "spine": [[0, 0], [1, 1], [2, 2]], "half_width": ^[1, 2]})"),
       ": /features/0/half_width: expected 1 or 3 numbers, got 2"},
      {face_with(
           R"({"kind": "stroke", "name": "a", "spine": [[0, 0], [1, 1], [2, 2]], "half_width": ^[1, -1, 2]})"),
       ": /features/0/half_width: a length must not be negative, got -1"},
      {face_with(R"({"kind": "polyline", "name": "a", "points": ^[], "half_width": 1})"),
       ": /features/0/points: expected at least 1 point, got 0"},
      {face_with(R"({"kind": "path", "name": "a", "points": ^[[0, 0], [1, 1]]})"),
       ": /features/0/points: expected at least 3 points, got 2"},
      {face_with(R"({"kind": "path", "name": "a", "points": [[0, 0], [1, 1], [1, 0, ^"bent"]]})"),
       ": /features/0/points/2/2: no mark of a point named \"bent\"; did you mean \"bend\"?"},
      {face_with(R"(^{"kind": "path", "name": "a"})"),
       ": /features/0: a path has either \"points\" (one loop) or \"loops\" (any number)"},
      {face_with(disc + "}," + marked_disc + "}"),
       ": /features/1/name: there is a feature \"a\" already"},
      {face_with(disc + R"(, "paint": ^"skn"})"),
       ": /features/0/paint: no palette colour named \"skn\"; did you mean \"skin\"?"},
      {face_with(
           disc +
           R"(, "clip": ^"b"}, {"name": "b", "kind": "disc", "center": [0, 0], "radius": 1})"),
       ": /features/0/clip: the feature \"b\" comes later: move it before what it clips"},
      {face_with(kIris + "," + disc + R"(, "clip": ^"irsi"})"),
       ": /features/1/clip: no feature named \"irsi\"; did you mean \"iris\"?"},
      {face_with(disc + R"(, "mirror": ^true})"),
       ": /features/0/mirror: \"mirror\" needs a \"side\": the one that the numbers are for"},
      {face_with(disc + R"(, "side": ^"lft"})"),
       ": /features/0/side: no side named \"lft\"; did you mean \"left\"?"},
      {face_with(
           kIris +
           R"(, {"name": "b", "kind": "disc", "side": "left", "center": ^"@iris/centre", "radius": 1})"),
       ": /features/1/center: no number named \"iris/centre\"; did you mean \"iris/center\"?"},
      {face_with(
           kIris +
           R"(, {"name": "b", "kind": "disc", "side": "left", "center": ^"@iris/radius", "radius": 1})"),
       ": /features/1/center: \"@iris/radius\" is a length of 1, but a point of 2 is needed here"},
      {face_with(kIris +
                 R"(, {"name": "b", "kind": "disc", "center": ^"iris/center", "radius": 1})"),
       ": /features/1/center: expected numbers or a reference like \"@opening/upper\", got "
       "\"iris/center\""},
      {control_with(R"("offset": {"iris/centr": ^[1, 0]})"),
       ": /controls/0/offset/iris~1centr: no number named \"iris/centr\"; did you mean "
       "\"iris/center\"?"},
      {control_with(R"("offset": {"iri/*": ^[1, 0]})"),
       ": /controls/0/offset/iri~1*: no feature named \"iri\"; did you mean \"iris\"?"},
      {control_with(R"("offset": {"iris/*": ^[1]})"),
       ": /controls/0/offset/iris~1*: expected 2 numbers, got 1"},
      {control_with(R"("offset": {"iris/center": ^[1]})"),
       ": /controls/0/offset/iris~1center: expected 2 numbers, got 1"},
      {control_with(R"("scale": ^["iris/radius"])"),
       ": /controls/0/scale: a control that scales must rest at 1, not at 0"},
      {control_with(R"("offset": {"palette/skin": ^[1, 0, 0, 0]})"),
       ": /controls/0/offset/palette~1skin: \"palette/skin\" has no sides, but this control is per "
       "side"},
      {control_with(R"("key_shapes": {"slices": {"iris/radius": ^[0.1]}})"),
       ": /controls/0/key_shapes/slices/iris~1radius: expected at least 2 keys, got 1"},
      {control_with(R"("key_shapes": {"slices": {"iris/radius": [0.1, ^-1]}})"),
       ": /controls/0/key_shapes/slices/iris~1radius/1: a length must not be negative, got -1"},
      {control_with(R"("key_shapes": {"at": [0, ^0], "slices": {"iris/radius": [0.1, 1]}})"),
       ": /controls/0/key_shapes/at/1: the places of keys must rise"},
      {control_with(R"("key_shapes": {"slices": {"iris/radius": ["rest", ^"@iris/center"]}})"),
       ": /controls/0/key_shapes/slices/iris~1radius/1: \"@iris/center\" is a point of 2, but a "
       "length of 1 is needed here"},
      {face_with("", R"(, "controls": [{"name": "a", "range": [0, 1], "rest": ^2}])"),
       ": /controls/0/rest: must lie between 0 and 1, got 2"},
      {clip_with(R"({"lok": ^{"keys": [[0, 0]]}})"),
       ": /clips/idle/lok: no control named \"lok\"; did you mean \"look\"?"},
      {clip_with(R"({"look": {"keys": [[0, 0], ^[0, 1]]}})"),
       ": /clips/idle/look/keys/1: the times of keys must rise"},
      {clip_with(R"({"look": {"keys": [[0, 0, ^"smoth"]]}})"),
       ": /clips/idle/look/keys/0/2: no ease named \"smoth\"; did you mean \"smooth\"?"},
      {clip_with(R"({"look": {"period": ^-1, "keys": [[0, 0]]}})"),
       ": /clips/idle/look/period: a period must be positive, got -1"},
      {clip_with(R"({"look": ^{}})"),
       ": /clips/idle/look: a curve has \"keys\", \"sine\" or \"wander\""},
      {clip_with(R"({"look": {"jitter": ^1, "keys": [[0, 0]]}})"),
       ": /clips/idle/look/jitter: jitter needs a period"},
      {clip_with(R"({"look": {"period": 2, "jitter": ^1.5, "keys": [[0, 0], [1, 1]]}})"),
       ": /clips/idle/look/jitter: the last key and the jitter must end within the period 2, got 1 "
       "+ 1.5"},
      {clip_with(R"({"look": {"wander": ^{"amplitude": 1, "period": 1, "jitter": 0.98}}})"),
       ": /clips/idle/look/wander: jitter and move must end within the period 1, got 0.98 + 0.05"},
      {clip_with(R"({"look": {"wander": {"amplitude": 1, "period": 1, "home": ^2}}})"),
       ": /clips/idle/look/wander/home: a share of the periods lies between 0 and 1, got 2"},
      {clip_with(R"({"look": {"wander": {"amplitude": 1, "period": 1, "seed": ^-1}}})"),
       ": /clips/idle/look/wander/seed: a seed is a whole number from 0 to 4294967295, got -1"},
      {clip_with(R"({"life": ^[]})"), ": /clips/idle/life: expected at least one word"},
      {clip_with(R"({"life": [^"hed"]})"),
       ": /clips/idle/life/0: no part of idle life named \"hed\"; did you mean \"head\"?"},
      {clip_with(R"({"life": [^"head"]})"),
       ": /clips/idle/life/0: this face has no control that \"head\" moves"},
      {clip_with(R"({"look": ^[]})"), ": /clips/idle/look: expected at least one curve"},
      {clip_with(R"({"look": [{"keys": [[0, 0]]}, ^{}]})"),
       ": /clips/idle/look/1: a curve has \"keys\", \"sine\" or \"wander\""},
      {clip_with(R"({"tracks": {"lok": ^{"keys": [[0, 0]]}}})"),
       ": /clips/idle/tracks/lok: no control named \"lok\"; did you mean \"look\"?"},
      {face_with("", R"(, "default_clip": ^"idle")"), ": /default_clip: no clip named \"idle\""},
  };
  expect_refused(table);
}

TEST(ReadFace, WarnsOfUnknownKeysAndReadsOn) {
  std::string first = face_with("", R"(, ^"nmae": "x")");
  std::string second =
      face_with(R"({"name": "a", "kind": "disc", "center": [0, 0], "radius": 1, ^"pant": "skin"})");
  const std::string first_place = take_mark(first), second_place = take_mark(second);
  std::vector<Error> warnings;
  ASSERT_TRUE(read_face_text(first, "f", {}, &warnings));
  ASSERT_TRUE(read_face_text(second, "f", {}, &warnings));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(sentence(warnings[0]),
            first_place + ": /nmae: unknown key \"nmae\", ignored; did you mean \"name\"?");
  EXPECT_EQ(
      sentence(warnings[1]),
      second_place +
          ": /features/0/pant: unknown key \"pant\" of a disc, ignored; did you mean \"paint\"?");
}

TEST(ReadFace, WarnsOfKeyShapesThatJumpAtRest) {
  std::vector<Error> warnings;
  ASSERT_TRUE(
      read_face_text(control_with(R"("key_shapes": {"slices": {"iris/radius": [0.2, 0.3]}})"), "f",
                     {}, &warnings));
  ASSERT_EQ(warnings.size(), 2u);  // one for each side
  EXPECT_EQ(warnings[0].what, "the key at rest differs from \"iris.left/radius\" itself");
}

TEST(ReadFace, NamesTheLimitThatIsExceeded) {
  EXPECT_EQ(said(face_with(kIris), {.bytes = 10}), "f: longer than 10 bytes (limit: bytes)");
  EXPECT_EQ(said("[[[1]]]", {.nesting = 2}),
            "f:1:3: arrays and objects nested more than 2 deep (limit: nesting)");
  EXPECT_EQ(said("[1, 2, 3]", {.values = 3}), "f:1:8: /2: more than 3 JSON values (limit: values)");
  EXPECT_EQ(said(face_with(kIris), {.numbers = 10}),
            "f:3:93: /features/0/radius: more than 10 numbers in the face (limit: numbers)");
  EXPECT_EQ(said(face_with(kIris), {.features = 1}),
            "f:3:14: /features/0: more than 1 features (limit: features)");
  EXPECT_EQ(said("[100]", {.magnitude = 99}),
            "f:1:2: /0: 100 is too large: numbers go from -99 to 99 (limit: magnitude)");
}

TEST(ReadFace, LimitsHowDeepFeaturesAreClipped) {
  const std::string disc = R"(", "kind": "disc", "center": [0, 0], "radius": 1)";
  std::string chain = R"({"name": "n0)" + disc + "}";
  for (int i = 1; i <= 65; ++i)
    chain += R"(, {"name": "n)" + std::to_string(i) + disc + R"(, "clip": "n)" +
             std::to_string(i - 1) + "\"}";
  EXPECT_TRUE(
      said(face_with(chain))
          .ends_with(": /features/65/clip: features clipped more than 64 deep (limit: nesting)"))
      << said(face_with(chain));
}

TEST(ReadFace, SaysWhatIsWrongWithTheFileItself) {
  const Expected<Face> folder = read_face(MIEN_SOURCE_DIR "/faces");
  ASSERT_FALSE(folder);
  EXPECT_EQ(sentence(folder.error()), MIEN_SOURCE_DIR "/faces: is a directory");
  const Expected<Face> nothing = read_face("/nowhere/a\nface.json");
  ASSERT_FALSE(nothing);
  EXPECT_EQ(sentence(nothing.error()),
            "/nowhere/a\\x0Aface.json: cannot be read: No such file or directory");
  const Expected<Face> endless = read_face("/dev/zero", {.bytes = 1000});
  ASSERT_FALSE(endless);
  EXPECT_EQ(sentence(endless.error()), "/dev/zero: longer than 1000 bytes (limit: bytes)");
}

}  // namespace
}  // namespace mien
