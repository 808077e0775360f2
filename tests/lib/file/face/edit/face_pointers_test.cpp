#include <mien/face_pointers.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <map>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

using test::face_with;

std::map<std::string, std::string> pointers_of(const std::string& text) {
  const auto face = read_face_text(text);
  const auto pointers = face_pointers(text);
  EXPECT_TRUE(face && pointers);
  std::map<std::string, std::string> found;
  const auto names = settable_names(*face);
  EXPECT_EQ(names.size(), pointers->size());
  for (std::size_t i = 0; i < names.size(); ++i) found[names[i].name] = (*pointers)[i];
  return found;
}

TEST(FacePointers, SayWhereEachValueStands) {
  const auto at = pointers_of(face_with(
      R"({"name": "brow", "kind": "stroke", "side": "left", "spine": [[0, 0], [1, 0], [1, 1]], "half_width": 0.1,
          "right": {"half_width": [0.1, 0.2, 0.3]}},
         {"name": "lash", "kind": "stroke", "side": "left", "spine": ["@brow/spine/0", [0, 1], [1, 1]], "half_width": 0.1},
         {"name": "head", "kind": "path", "points": [[0, 0], [1, 0, "bend"], [1, 1]], "opacity": 0.5,
          "paint": {"gradient": "linear", "from": [0, 0], "to": [0, 1], "stops": [[0, "skin"], [1, "black"]]}})",
      R"(, "groups": {}, "controls": [{"name": "look", "range": [0, 1], "rest": 0}])"));
  EXPECT_EQ(at.at("palette/skin"), "/palette/skin");
  EXPECT_EQ(at.at("brow.left/spine/1"), "/features/0/spine/1");
  EXPECT_EQ(at.at("brow.right/spine/1"), "/features/0/spine/1");  // both sides are written once
  EXPECT_EQ(at.at("brow.left/half_width"), "/features/0/half_width");
  EXPECT_EQ(at.at("brow.right/half_width"), "/features/0/right/half_width");
  EXPECT_EQ(at.count("lash.left/spine/0"), 0u);  // the brow's
  EXPECT_EQ(at.at("lash.left/spine/1"), "/features/1/spine/1");
  EXPECT_EQ(at.at("head/points/1"), "/features/2/points/1");
  EXPECT_EQ(at.at("head/opacity"), "/features/2/opacity");
  EXPECT_EQ(at.at("head/paint/to"), "/features/2/paint/to");
  EXPECT_EQ(at.at("head/paint/places"), "/features/2/paint/stops");
  EXPECT_EQ(at.at("look"), "");
}

TEST(FacePointers, AreEscapedAndWhole) {
  const std::string name = "a~" + std::string(80, 'b');
  std::string text = face_with(R"({"name": "eye", "kind": "disc", "center": [0, 0], "radius": 1})");
  text.replace(text.find("black"), 5, name);
  EXPECT_EQ(pointers_of(text).at("palette/" + name), "/palette/a~0" + std::string(80, 'b'));
}

TEST(FacePointers, OfARecipeAreNone) {
  const std::string text =
      R"({"format": "mien-face", "format_version": 2, "code": "AM9XB-0E85E-9Y"})";
  const auto found = pointers_of(text);
  EXPECT_GT(found.size(), 100u);
  for (const auto& [name, pointer] : found) EXPECT_EQ(pointer, "") << name;
}

TEST(FacePointers, OfNoFaceAreAnError) {
  const auto pointers = face_pointers("{", "a.json");
  ASSERT_FALSE(pointers);
  EXPECT_TRUE(pointers.error().where.starts_with("a.json:1:"));
}

}  // namespace
}  // namespace mien
