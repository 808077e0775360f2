#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <string>

#include "tests/support/faces/box_letters.h"

namespace mien {
namespace {

std::string lettered_face(const std::string& features) {
  return R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"ink": "#000000"}, "background": "ink", "features": [
)" + features +
         "]}";
}

std::string badge(const std::string& text, const std::string& more = "") {
  return R"({"name": "badge", "kind": "text", "paint": "ink", "center": [0.4, -0.5], "height": 0.1, "text": )" +
         text + more + "}";
}

std::string text_said(const std::string& features, const Letters& letters = test::box_letters()) {
  const auto face = read_face_text(lettered_face(features), "f", {}, nullptr, letters);
  return face ? "a face" : sentence(face.error());
}

TEST(TextReader, MakesAnOutlineAndNamedNumbers) {
  const auto face = read_face_text(
      lettered_face(badge("\"mien\"", R"(, "side": "left", "tilt": 8, "right": {"text": "R"})")),
      "f", {}, nullptr, test::box_letters());
  ASSERT_TRUE(face) << sentence(face.error());
  const auto value = [&](const char* name) {
    return face->vector[std::size_t(face->model->layout[face->model->layout.find(name)].begin)];
  };
  EXPECT_EQ(value("badge.left/center"), 0.4);
  EXPECT_EQ(value("badge.right/center"), -0.4);
  EXPECT_EQ(value("badge.right/tilt"), -8);
  EXPECT_EQ(value("badge.right/height"), 0.1);
  const auto& left = std::get<TextFigure>(face->model->features[0].figure);
  EXPECT_EQ(left.text, "mien");
  EXPECT_EQ(left.outline->loops.size(), 4u);
  EXPECT_EQ(std::get<TextFigure>(face->model->features[1].figure).text, "R");
}

TEST(TextReader, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(text_said(badge("\"mien\""), {}),
            "f:3:97: /features/0/text: the text \"mien\" needs letters, which the reader was not "
            "given: mien::text has them");
  EXPECT_EQ(text_said(badge("\"why?\"")),
            "f:3:97: /features/0/text: the font has no letter for \"?\" (U+003F)");
  EXPECT_EQ(text_said(badge("\"\"")), "f:3:97: /features/0/text: a text has 1 to 60 signs, got 0");
  EXPECT_EQ(text_said(badge('"' + std::string(61, 'a') + '"')),
            "f:3:97: /features/0/text: a text has 1 to 60 signs, got 61");
  EXPECT_EQ(text_said(badge('"' + std::string(60, 'a') + '"')), "a face");
  EXPECT_EQ(text_said(badge("5")), "f:3:97: /features/0/text: expected a string, got a number");
  std::string many;
  for (int i = 0; i < 34; ++i) {
    std::string one = badge('"' + std::string(60, 'a') + '"');
    one.replace(one.find("badge"), 5, "b" + std::to_string(i));
    many += (i ? ",\n" : "") + one;
  }
  EXPECT_NE(
      text_said(many).find("the texts of a face have at most 2000 signs in all, left and right "
                           "counted; with this one it is 2040"),
      std::string::npos)
      << text_said(many);
}

}  // namespace
}  // namespace mien
