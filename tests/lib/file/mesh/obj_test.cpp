// Item G2: heads from OBJ files.

#include <gtest/gtest.h>

#include <mien/obj.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;

Expected<Mesh> read_text_as_obj(const std::string& text) {
  const ScratchFolder folder;
  test::write_text(folder / "a.obj", text);
  return read_obj(folder / "a.obj");
}

TEST(Obj, PointsKeepTheirOrderAndFacesBecomeTriangles) {
  const auto mesh = read_text_as_obj(
      "# a square\nmtllib none.mtl\nv 0 0 0.5\nv 1e0 0 +2\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n"
      "f 1//1 2//1 3//1 4//1\nf -4 -3 -2\n");
  ASSERT_TRUE(mesh) << sentence(mesh.error());
  ASSERT_EQ(mesh->points.size(), 4u);
  EXPECT_EQ(mesh->points[0], glm::dvec3(0, 0, 0.5));
  EXPECT_EQ(mesh->points[1], glm::dvec3(1, 0, 2));
  EXPECT_EQ(mesh->triangles.size(), 3u);
  EXPECT_EQ(mesh->triangles[2], (std::array<int, 3>{0, 1, 2}));
}

/// Programs write the same faces in many ways.
TEST(Obj, TheSameFacesInOtherWords) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto plain = read_text_as_obj(points + "f 1 2 3 4\n");
  ASSERT_TRUE(plain);
  for (const std::string& text : std::vector<std::string>{
           points + "f -4 -3 -2 -1\n", points + "f 1/1 2/2 3/3 4/4\n",
           points + "f 1//1 2//1 3//1 4//1\n", points + "f 1/1/1 2/-1/1 3/1/-1 4/1/1\n",
           points + "f 1 2 \\\n 3 \\\r\n 4\n",
           "v 0 0 \\\n0\nv 1 0 0 # a corner \\\nv 1 1 0 1.0\nv 0 1 0 .5 .5 .5\nf 1 2 3 4",
           "# a head \\\n" + points + "f 1 2 3 4\n", "\xEF\xBB\xBF" + points + "f 1 2 3 4\n",
           "f 1 2 3 4\n" + points, points + "l 1 2\np 1\nvp 0.1\nmtllib none.mtl\nf 1 2 3 4\n",
           "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"}) {
    const auto mesh = read_text_as_obj(text);
    ASSERT_TRUE(mesh) << text << sentence(mesh.error());
    EXPECT_EQ(mesh->points, plain->points) << text;
    EXPECT_EQ(mesh->triangles, plain->triangles) << text;
  }
}

TEST(Obj, WrongCornersHaveTheirLine) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string corner =
      "expected a corner of a face like 3, 3/1 or 3//2, counted from 1, got ";
  for (const auto& [face, what] : std::vector<std::pair<std::string, std::string>>{
           {"f 0 1 2", corner + "\"0\""},
           {"f 1 2 3.5", corner + "\"3.5\""},
           {"f 1 2 x", corner + "\"x\""},
           {"f 1 2 3/x", corner + "\"3/x\""},
           {"f 1 2 3/1/1/1", corner + "\"3/1/1/1\""},
           {"f 1 2 18446744073709551617", corner + "\"18446744073709551617\""},
           {"f 1 2 4294967297", "a face names point 4294967297, and there are 3"},
           {"f 1 2 4", "a face names point 4, and there are 3"},
           {"f -4 -1 -2", "a face names point -4, and there are 3 before it"},
           {"f 1 2", "a face of 2 points; it has 3 or more"},
           {"f", "a face of 0 points; it has 3 or more"}}) {
    const auto mesh = read_text_as_obj(points + face + "\n");
    ASSERT_FALSE(mesh) << face;
    EXPECT_EQ(mesh.error().what, what);
    EXPECT_TRUE(mesh.error().where.ends_with("a.obj:4")) << mesh.error().where;
  }
}

TEST(Obj, BadFilesAreOneSentenceWithALine) {
  const std::pair<const char*, const char*> bads[] = {
      {"v 0 0 nan\n", "expected three finite numbers, got \"nan\""},
      {"v 0 0 inf\n", "expected three finite numbers, got \"inf\""},
      {"v 0 0\n", "expected three finite numbers, got \"\""},
      {"v 0 0 1x\n", "expected three finite numbers, got \"1x\""},
      {"hello\n", "has no points: it is not an OBJ file"},
      {"", "has no points: it is not an OBJ file"},
      {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "a face names point 9, and there are 3"}};
  for (const auto& [text, what] : bads) {
    const auto mesh = read_text_as_obj(text);
    ASSERT_FALSE(mesh) << text;
    EXPECT_EQ(mesh.error().what, what);
  }
  EXPECT_NE(read_text_as_obj("\n\nv 0 0 nan\n").error().where.find("a.obj:3"), std::string::npos);
  EXPECT_FALSE(read_obj("/none.obj"));
}

TEST(Obj, OtherCountsOfPointsDoNotFit) {
  const Mesh three{{{}, {}, {}}, {}}, two{{{}, {}}, {}};
  EXPECT_TRUE(check_fits(three, three, "a.obj"));
  EXPECT_EQ(sentence(check_fits(three, two, "a.obj").error()),
            "a.obj: has 2 points, but the neutral mesh has 3");
}

}  // namespace
}  // namespace mien
