// mien mesh and mien import obj-targets: heads of triangles drawn, and as movers of a face (items G1,
// G2, G6); what is wrong with them is one line, and nothing is written.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/faces/head_mesh.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::head_mesh;
using test::HeadShape;
using test::Ran;
using test::read_text;
using test::run_mien;
using test::ScratchFolder;

using Words = std::vector<std::string>;

class MeshTest : public testing::Test {
 protected:
  void SetUp() override {
    test::write_obj(path("neutral.obj"), head_mesh(10, HeadShape::neutral));
    test::write_obj(path("smile.obj"), head_mesh(10, HeadShape::smile));
    test::write_obj(path("ah.obj"), head_mesh(10, HeadShape::ah));
    // Ring 7 of 10 is the mouth's; columns run from −½ to ½ turn, 10 is in front.
    test::write_text(folder_ / "map.json",
                     R"({"format": "mien-map", "format_version": 1,
                         "points": {"mouth/spine/0": 149, "mouth/spine/1": [150], "mouth/spine/2": 151}})");
  }
  std::string path(const char* name) const { return (folder_ / name).string(); }
  Ran mesh(Words words) const {
    words.insert(words.begin(), {"mesh", path("neutral.obj")});
    words.insert(words.end(), {"--size", "64", "-o", path("out.png")});
    return run_mien(words);
  }
  /// The picture's file.
  std::string drawn(const Words& words) const {
    const Ran ran = mesh(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return read_text(folder_ / "out.png");
  }
  /// Writes a head whose points are `place(i)`.
  template <class Place>
  void write_head(const char* name, const Place& place) const {
    Mesh head = head_mesh(10, HeadShape::neutral);
    for (std::size_t i = 0; i < head.points.size(); ++i) head.points[i] = place(i);
    test::write_obj(path(name), head);
  }
  ScratchFolder folder_;
};

TEST_F(MeshTest, DrawsNeutralTargetsAndMixes) {
  const Words heads{path("smile.obj"), "open=" + path("ah.obj")};
  const auto with = [&](Words more) {
    more.insert(more.begin(), heads.begin(), heads.end());
    return drawn(more);
  };
  EXPECT_TRUE(with({}) != drawn({}));
  EXPECT_TRUE(with({"--weight", "smile=0.5"}) !=
              with({"--weight", "smile=0.5", "--weight", "open"}));
  // A target at 0 and one that is the neutral: nothing moves.
  EXPECT_TRUE(with({"--weight", "smile=0"}) ==
              drawn({"smile=" + path("neutral.obj"), "--weight", "smile=0.7"}));
}

/// Mixed and turned by the command or by this test: the same pictures.
TEST_F(MeshTest, DrawsTheHeadThatTheWeightsAndTheTurnMean) {
  const Mesh neutral = head_mesh(10, HeadShape::neutral), smile = head_mesh(10, HeadShape::smile),
             ah = head_mesh(10, HeadShape::ah);
  write_head("mixed.obj", [&](std::size_t i) {
    return 0.25 * neutral.points[i] + 0.5 * smile.points[i] + 0.25 * ah.points[i];
  });
  EXPECT_TRUE(
      drawn({path("mixed.obj"), "--weight", "mixed"}) ==
      drawn({path("smile.obj"), path("ah.obj"), "--weight", "smile=0.5", "--weight", "ah=0.25"}));
  const std::string turned = drawn({"--yaw", "30"});
  write_head("neutral.obj", [&](std::size_t i) {
    const glm::dvec3 p = neutral.points[i];
    const double c = std::sqrt(0.75), s = 0.5;
    return glm::dvec3{c * p.x + s * p.z, p.y, c * p.z - s * p.x};
  });
  EXPECT_TRUE(drawn({}) == turned);
}

TEST_F(MeshTest, WhatIsWrongIsOneLineAndLeavesNothing) {
  std::string text = read_text(folder_ / "smile.obj");
  test::write_text(folder_ / "nan.obj", "v nan 0 0\n" + text.substr(text.find('\n') + 1));
  test::write_text(folder_ / "less.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  test::write_text(folder_ / "far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  const std::pair<Words, const char*> wrongs[] = {
      {{path("nan.obj")}, "nan.obj:1: expected three finite numbers, got \"nan\""},
      {{path("less.obj")}, "less.obj: "},
      {{path("far.obj")}, "far.obj:4: a face names point 4, and there are 3"},
      {{path("none.obj")}, "none.obj: cannot be read: No such file or directory"},
      {{path("ah.obj"), "--weight", "aah=1"}, "--weight aah=1: no target named \"aah\""},
      {{path("ah.obj"), "--weight", "ah=x"}, "--weight x: expected a number from -100 to 100"},
      {{"--yaw", "400"}, "--yaw 400: expected a number from -180 to 180"}};
  for (const auto& [words, what] : wrongs) {
    const Ran ran = mesh(words);
    EXPECT_NE(ran.code, 0);
    EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.png"));
  }
}

TEST_F(MeshTest, ImportedTargetsMoveTheFace) {
  const std::string face = face_path("toon");
  const Words files{face, path("map.json"), path("neutral.obj"), "grin=" + path("smile.obj"),
                    "open=" + path("ah.obj")};
  const auto made = [&](Words words, const char* out) {
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), {"-o", path(out)});
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return read_text(folder_ / out);
  };
  EXPECT_EQ(made({"import", "obj-targets"}, "a.json"), made({"morph", "from-obj"}, "b.json"));
  const auto scene = [&](const char* morph) {
    return run_mien({"scene", face, "--morphs", path("a.json"), "--morph", morph}).out;
  };
  EXPECT_EQ(scene("open=0"), run_mien({"scene", face}).out);
  EXPECT_NE(scene("open=1"), scene("open=0"));
  test::write_text(folder_ / "far.json", R"({"format": "mien-map", "format_version": 1,
                                             "points": {"mouth/spine/0": 9999}})");
  const Ran far = run_mien({"import", "obj-targets", face, path("far.json"), path("neutral.obj"),
                            path("ah.obj"), "-o", path("c")});
  EXPECT_EQ(far.code, 1);
  EXPECT_EQ(far.err, "mien: " + path("far.json") +
                         ": \"mouth/spine/0\" is bound to vertex 9999, and the mesh has 220\n");
  EXPECT_EQ(run_mien({"import", "obj-targets", face, path("map.json"), "-o", path("c")}).code, 2);
  EXPECT_EQ(run_mien({"import", "facemotion", face, face, "-o", path("c")}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "c"));
}

// Items P5, P6: a vertex stream's components and its reconstruction, drawn as the mesh.
TEST_F(MeshTest, AStreamsComponentsAreDrawnAsTheMesh) {
  const std::string stream = path("a.npy"), basis = path("a.basis");
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 220, 3), }";
  header.resize(117, ' ');
  header += '\n';
  std::string bytes = std::string("\x93NUMPY\x01", 7) + '\0' + char(118) + '\0' + header;
  for (const HeadShape shape : {HeadShape::neutral, HeadShape::smile, HeadShape::ah})
    for (const glm::dvec3& p : head_mesh(10, shape).points)
      bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
  test::write_text(folder_ / "a.npy", bytes);
  ASSERT_EQ(run_mien({"pca", "fit", stream, "--components", "2", "-o", basis}).code, 0);
  const Ran compared = run_mien({"pca", "compare", basis, stream, "--mesh", path("neutral.obj"),
                                 "--size", "64", "-o", path("compare.png")});
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_EQ(compared.out.find("rms error "), 0u) << compared.out;
  const auto sheet = [&](Words more) {
    more.insert(more.begin(), {"pca", "sheet", basis, "--size", "64", "-o", path("sheet.png")});
    EXPECT_EQ(run_mien(more).code, 0);
    return read_text(folder_ / "sheet.png");
  };
  // Which numbers the components have is judged where they are found: here, that the mesh is drawn by them.
  const std::string as_mesh = sheet({"--mesh", path("neutral.obj")});
  EXPECT_TRUE(as_mesh != sheet({}));
  EXPECT_TRUE(as_mesh != sheet({"--mesh", path("neutral.obj"), "--spread", "0"}));
}

}  // namespace
}  // namespace mien
