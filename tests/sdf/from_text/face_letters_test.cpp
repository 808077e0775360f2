#include <mien/face_file.h>
#include <mien/face_letters.h>
#include <mien/face_model.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace mien {
namespace {

Box2 box_of(const TextOutline& outline) {
  Box2 box;
  for (const auto& loop : outline.loops)
    for (const QuadBezier& side : loop) box = around(box, side.p0);
  return box;
}

TEST(FaceLetters, CapitalsAreOneHighAroundTheMiddle) {
  const TextOutline made = shipped_letters()("HIH").value();
  const Box2 box = box_of(made);
  EXPECT_NEAR(box.lo.y, -0.5, 1e-12);
  EXPECT_NEAR(box.hi.y, 0.5, 1e-12);
  EXPECT_NEAR(box.lo.x + box.hi.x, 0, 1e-12);
  EXPECT_GT(made.width, box.hi.x - box.lo.x);
  EXPECT_EQ(made.loops.size(), 3u);
}

TEST(FaceLetters, HaveUmlautsDigitsAndSigns) {
  for (const char* text : {"Äößé", "No. 7", "€ 10 − 3 × 2", "Ωд", "a b"})
    EXPECT_TRUE(shipped_letters()(text)) << text;
}

TEST(FaceLetters, NameWhatTheyLack) {
  const auto said = [](const char* text) { return shipped_letters()(text).error().what; };
  EXPECT_EQ(said("a漢"), "the font has no letter for \"漢\" (U+6F22)");
  EXPECT_EQ(said("a\tb"), "the font has no letter for the sign U+0009");
  EXPECT_EQ(said("a\xff"), "the font has no letter for the sign U+FFFD");
}

/// Letters stand upright wherever y points, on both sides of a face, and turn with their tilt.
TEST(FaceLetters, StandUprightInThePicture) {
  for (const char* up : {"up", "down"}) {
    const auto face = read_face_text(
        std::string(
            R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": ")") +
            up +
            R"("}, "palette": {"ink": "#000000"}, "background": "ink", "features": [
      {"name": "l", "kind": "text", "text": "L", "side": "left", "center": [0.5, 0], "height": 0.4, "paint": "ink"}]})",
        "f", {}, nullptr, shipped_letters());
    ASSERT_TRUE(face) << sentence(face.error());
    const Scene scene = scene_from_face(*face);
    const double down = std::string(up) == "up" ? -1 : 1;
    for (std::size_t i = 0; i < 2; ++i) {
      const Area area = scene.layers()[i].area;
      const double middle = i == 0 ? 0.5 : -0.5;
      EXPECT_LT(scene.distance(area, {middle + 0.02, down * 0.18}), 0) << up << i;   // its foot
      EXPECT_GT(scene.distance(area, {middle + 0.04, -down * 0.18}), 0) << up << i;  // above it
    }
  }
}

const std::string kLettered = MIEN_SOURCE_DIR "/examples/lettered/";

/// The example: a cap's text turns with the head and is as high as its frame makes it; a jersey's stays.
TEST(FaceLetters, OfPartsTurnWithTheHead) {
  std::vector<Error> warnings;
  const auto face = read_face(kLettered + "ole.face.json", {}, &warnings, shipped_letters());
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(warnings.empty());
  const auto moved = [&](const char* by, const char* slice) {
    const Face turned = pose_face(*face, {.settings = {read_setting(*face, by).value()}});
    const auto at = std::size_t(face->model->layout[face->model->layout.find(slice)].begin);
    return turned.vector[at] - face->vector[at];
  };
  EXPECT_NEAR(std::abs(moved("roll=12", "cap_name/tilt")), 12, 1e-9);
  EXPECT_GT(moved("yaw=25", "cap_name/center"), 0.05);
  EXPECT_LT(moved("yaw=25", "cap_name/height"), 0);  // a plate is seen from the side
  EXPECT_EQ(moved("roll=12", "jersey_number/tilt"), 0);
  // Shoulders follow a yaw by a fifth, and what is on them goes with them.
  EXPECT_GT(moved("yaw=25", "jersey_number/center"), 0);
  EXPECT_LT(moved("yaw=25", "jersey_number/center"), moved("yaw=25", "cap_name/center") / 3);
}

TEST(FaceLetters, ThatAreMissingAreToldInThePartsFile) {
  const auto face = read_face(kLettered + "ole.face.json");
  ASSERT_FALSE(face);
  const std::string said = sentence(face.error());
  EXPECT_NE(said.find(".part.json:"), std::string::npos) << said;
  EXPECT_NE(said.find("needs letters"), std::string::npos) << said;
}

}  // namespace
}  // namespace mien
