#include <mien/face_file.h>
#include <mien/face_letters.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

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

}  // namespace
}  // namespace mien
