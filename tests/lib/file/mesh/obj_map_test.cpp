// Item G2: targets of a 3D head move the named points of a face.

#include <gtest/gtest.h>

#include <mien/face_model.h>
#include <mien/morph_file.h>
#include <mien/obj_map.h>

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

const char kMap[] = R"({"format": "mien-map", "format_version": 1, "points": {
  "mouth.left/points/0": 0, "mouth.left/points/2": [1, 2]}})";

glm::dvec2 point(const Face& face, const char* name) {
  const auto at = std::size_t(face.model->layout[face.model->layout.find(name)].begin);
  return {face.vector[at], face.vector[at + 1]};
}

// A face of y down, 60 units between the bound points; a head of y up, 3 units between.
TEST(ObjMap, ATargetMovesBoundPointsToScale) {
  const Face face = test::face_named("male");
  const auto map = read_obj_map_text(face, kMap);
  ASSERT_TRUE(map) << sentence(map.error());
  const Mesh neutral{{{0, 0, 0}, {2, 0, 5}, {4, 0, 5}}, {}};
  Mesh smile = neutral;
  smile.points[1].y += 1;  // the middle of 1 and 2 rises by a half
  const auto text = morph_text_from_meshes(face, *map, neutral, {{"smile", smile}});
  ASSERT_TRUE(text) << text.error().what;
  const auto with = read_morphs_text(face, *text);
  ASSERT_TRUE(with) << sentence(with.error());
  const Face at = test::posed(*with, {"smile=1"});
  EXPECT_EQ(point(at, "mouth.left/points/0"), point(face, "mouth.left/points/0"));
  const glm::dvec2 moved = point(at, "mouth.left/points/2") - point(face, "mouth.left/points/2");
  EXPECT_NEAR(moved.x, 0, 1e-9);
  EXPECT_NEAR(moved.y, -0.5 * 60 / 3, 1e-9);
}

TEST(ObjMap, RefusesWhatDoesNotFit) {
  const Face face = test::face_named("male");
  const auto unknown = read_obj_map_text(
      face, R"({"format": "mien-map", "format_version": 1, "points": {"mouth.left/point/0": 0}})");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().what.find("did you mean \"mouth.left/points/0\"?"), std::string::npos);
  for (
      const char* bad :
      {"", "{}", R"({"format": "mien-map", "format_version": 1, "points": {}})",
       R"({"format": "mien-map", "format_version": 1, "points": {"mouth.left/points/0": -1}})",
       R"({"format": "mien-map", "format_version": 1, "points": {"mouth.left/points/0": 0.5}})",
       R"({"format": "mien-map", "format_version": 1, "scale": 0, "points": {"mouth.left/points/0": 0}})",
       R"({"format": "mien-map", "format_version": 1, "points": {"palette/ink": 0}})"})
    EXPECT_FALSE(read_obj_map_text(face, bad)) << bad;
  const auto map = read_obj_map_text(face, kMap);
  ASSERT_TRUE(map);
  const Mesh two{{{0, 0, 0}, {1, 0, 0}}, {}}, three{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {}};
  EXPECT_EQ(morph_text_from_meshes(face, *map, two, {}).error().what,
            "\"mouth.left/points/2\" is bound to vertex 2, and the mesh has 2");
  EXPECT_FALSE(morph_text_from_meshes(face, *map, three, {{"a", two}}));
  EXPECT_EQ(morph_text_from_meshes(face, *map, three, {{"a", three}}).error().what,
            "the bound points lie in one place: say a \"scale\" in the map");
}

}  // namespace
}  // namespace mien
