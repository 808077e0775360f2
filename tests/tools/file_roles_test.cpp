// No command destroys what it reads, or writes two things into one file.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::run_mien;
using test::ScratchFolder;
namespace fs = std::filesystem;

class FileRoles : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// The words are wrong use of which one line tells, and the file stays.
  void refused(const std::vector<std::string>& words, const std::string& kept,
               const std::string& sentence) const {
    const std::string before = text(kept);
    const auto ran = run_mien(words);
    EXPECT_EQ(ran.code, 2) << testing::PrintToString(words) << ran.err;
    EXPECT_NE(ran.err.find(sentence), std::string::npos) << ran.err;
    EXPECT_EQ(text(kept), before) << testing::PrintToString(words);
  }

  ScratchFolder folder_;
};

TEST_F(FileRoles, KeepWhatIsReadUnderEveryName) {
  const std::string table = file("c.csv", "who,size\na,1\nb,2\n");
  fs::create_symlink("c.csv", path("link.csv"));
  fs::create_hard_link(table, path("hard.csv"));
  fs::create_directory_symlink(".", path("same"));
  for (const std::string& name :
       {std::string("c.csv"), std::string("./c.csv"), std::string("link.csv"),
        std::string("hard.csv"), std::string("same/c.csv")})
    refused({"chernoff", table, "-o", path("c.png"), "--manifest", path(name)}, table,
            "--manifest");
  refused({"chernoff", path("link.csv"), "-o", table}, table, "TABLE reads it");
  EXPECT_FALSE(fs::exists(path("c.png")));
}

TEST_F(FileRoles, AreTheSameForAllCommands) {
  const std::string face = file("f.json", text(face_path("seed0")));
  const std::string obj = file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string plan = file("manifest.json", "{}");
  refused({"render", face, "-o", face}, face, "FACE reads it");
  refused({"animate", face, "-o", face, "--frames", "0-1"}, face, "FACE reads it");
  refused({"sheet", face, "-o", face}, face, "FACE reads it");
  refused({"mesh", obj, "-o", obj}, obj, "NEUTRAL reads it");
  refused({"import", "facemotion", face, "-o", face}, face, "FILES reads it");
  refused({"morph", "make", face, face, "-o", face}, face, "REST reads it");
  refused({"pca", "fit", face, "-o", face, "--components", "1"}, face, "FRAMES reads it");
  refused({"stimuli", plan, "-o", path("")}, plan, "PLAN reads it");
}

TEST_F(FileRoles, NeverAreTwoOutputs) {
  const std::string table = file("c.csv", "who,size\na,1\nb,2\n");
  refused({"chernoff", table, "-o", path("x.png"), "--legend", path("x.png")}, table,
          "--output writes it");
  refused({"chernoff", table, "-o", "-", "--manifest", "-"}, table, "standard output");
  fs::create_symlink("new.png", path("dangling.png"));
  refused(
      {"render", face_path("seed0"), "-o", path("new.png"), "--error-map", path("dangling.png")},
      table, "--output writes it");
  EXPECT_FALSE(fs::exists(path("new.png")));
}

/// Pictures that no file could hold, and places where none could be: told before hours of drawing.
TEST_F(FileRoles, AreToldOfBeforeTheWork) {
  const std::string table = file("c.csv", "who,size\na,1\nb,2\n");
  const std::string obj = file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string face = face_path("seed0");
  const std::vector<std::vector<std::string>> commands{
      {"render", face},
      {"sheet", "--people", "100000"},
      {"check", "--nonsense", "5000"},
      {"parts", "mouth"},
      {"parts", "check", "nobody.part.json"},
      {"chernoff", table},
      {"mesh", obj},
      {"morph", "between", "nobody.json", "nobody.json"},
      {"pca", "sheet", "nobody.npz"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"-o", path("a.gif")});
    const auto no_format = run_mien(words);
    words.back() = path("none/a.png");
    const auto no_folder = run_mien(words);
    const std::string where = path("none/a.png") + ": its folder " + path("none");
    EXPECT_NE(no_folder.err.find(where), std::string::npos) << no_folder.err;
    EXPECT_EQ(no_folder.code, 1) << words[0];
    if (words[1] == "between") continue;  // a GIF is a film
    EXPECT_NE(no_format.err.find("unknown extension .gif"), std::string::npos) << no_format.err;
    EXPECT_EQ(no_format.code, 2) << words[0];
  }
  const auto manifest =
      run_mien({"chernoff", table, "-o", path("c.png"), "--manifest", path("none/m.csv")});
  EXPECT_EQ(manifest.code, 1);
  EXPECT_FALSE(fs::exists(path("c.png")));
}

/// mien set writes FACE itself: that is what it is for. Devices take everything.
TEST_F(FileRoles, DoNotForbidWhatIsMeant) {
  const std::string face = file("f.json", text(face_path("seed0")));
  EXPECT_EQ(run_mien({"set", face, "palette/skin=#88aa66", "-o", face}).code, 0);
  const auto ran = run_mien({"chernoff", file("c.csv", "who,size\na,1\nb,2\n"), "-o", path("c.png"),
                             "--manifest", "/dev/null", "--cell", "16"});
  EXPECT_EQ(ran.code, 0) << ran.err;
}

}  // namespace
}  // namespace mien
