// Item G2: heads from OBJ files.

#include <gtest/gtest.h>

#include <mien/obj.h>

#include "tests/support/scratch_folder.h"

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
