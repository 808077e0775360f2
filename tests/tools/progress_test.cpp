// Progress: lines for programs, a bar for people, nothing for pipes.

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <sstream>

#include "tests/support/process/end_process.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::ScratchFolder;

/// Phases of a command in the order in which they ended, each of which rose from nothing to one.
std::vector<std::string> phases_of_command(std::vector<std::string> words) {
  words.push_back("--progress=json");
  const test::Ran ran = test::run_mien(words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  std::istringstream lines(ran.err);
  std::vector<std::string> phases;
  double done = -1;
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    EXPECT_GE(json["done"].get<double>(), done) << "progress never falls";
    done = json["done"];
    EXPECT_GE(json["elapsed"].get<double>(), 0);
    EXPECT_TRUE(json["left"].is_number() || json["left"].is_null());
    if (done == 1) phases.push_back(json["phase"]), done = -1;
  }
  EXPECT_EQ(done, -1) << "a phase did not end";
  return phases;
}

/// The same of drawing a face.
std::vector<std::string> phases_of(const std::vector<std::string>& more) {
  const ScratchFolder folder;
  std::vector<std::string> words{
      "render", face_path("toon"), "-o", (folder / "a.png").string(), "--size", "300"};
  words.insert(words.end(), more.begin(), more.end());
  if (more == std::vector<std::string>{"--error-map"}) words.push_back((folder / "e.png").string());
  return phases_of_command(words);
}

/// Every command whose work may take long.
TEST(Progress, IsOfAllCommands) {
  const ScratchFolder folder;
  const std::string out = (folder / "a.png").string(), code = "A66CB-AA5S0-14";
  const auto file = [&](const char* name, const std::string& text) {
    test::write_text(folder / name, text);
    return (folder / name).string();
  };
  const std::string obj = file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> all{
      {{"check", face_path("seed0"), face_path("toon")}, {"faces"}},
      {{"check", "--nonsense", "1"}, {"faces"}},
      {{"animate", face_path("seed0"), "-o", (folder / "%d.png").string(), "--frames", "0-1",
        "--size", "16"},
       {"frames"}},
      {{"morph", "between", code, code, "-o", out, "--steps", "2", "--size", "16"}, {"steps"}},
      {{"mesh", obj, "-o", out, "--size", "16"}, {"heads"}},
      {{"sheet", "--people", "3", "-o", out, "--cell", "16"}, {"people"}},
      {{"sheet", "--parts", "iris", "-o", out, "--cell", "16"}, {"parts"}},
      {{"chernoff", file("t.csv", "a,b\nx,1\ny,2\n"), "-o", out, "--cell", "16", "--legend",
        (folder / "l.png").string()},
       {"faces", "legend"}},
      {{"stimuli", file("p.json", R"({"format": "mien-stimuli", "format_version": 1, "size": 16,
                           "factors": [{"emotion": "joy", "steps": 3}]})"),
        "-o", (folder / "shown").string()},
       {"pictures"}}};
  const std::string basis = (folder / "a.basis").string(), toon = face_path("toon");
  ASSERT_EQ(
      test::run_mien({"pca", "fit", toon, "-o", basis, "--frames", "0-9", "--components", "2"})
          .code,
      0);
  all.push_back({{"pca", "fit", toon, "-o", basis, "--frames", "0-39", "--components", "2"},
                 {"pose", "fit"}});
  all.push_back(
      {{"pca", "encode", basis, toon, "-o", (folder / "w.npy").string()}, {"pose", "encode"}});
  all.push_back(
      {{"pca", "compare", basis, toon, "-o", out, "--size", "32"}, {"pose", "encode", "compare"}});
  all.push_back({{"pca", "sheet", basis, "--face", toon, "-o", out, "--size", "32"}, {"pictures"}});
  const std::string arkit = file("f.json", R"({"jawOpen": 0.4, "mouthSmileLeft": 0.3})");
  all.push_back({{"fit", code, arkit}, {"fit"}});
  all.push_back({{"pca", "decode", basis, "-o", (folder / "f.npy").string()}, {"decode"}});
  for (const auto& [words, phases] : all) EXPECT_EQ(phases_of_command(words), phases) << words[0];
  for (const char* command :
       {"render", "check", "animate", "sheet", "fit", "chernoff", "stimuli", "mesh"})
    EXPECT_NE(test::run_mien({command, "-h"}).out.find("--progress"), std::string::npos) << command;
}

TEST(Progress, JsonIsALineEach) {
  const std::vector<std::string> render{"render"};
  EXPECT_EQ(phases_of({}), render);
  EXPECT_EQ(phases_of({"--effect", "mosaic:1"}), render);
  EXPECT_EQ(phases_of({"--debug", "distance"}), render);
  EXPECT_EQ(phases_of({"--error-map"}), (std::vector<std::string>{"render", "error map"}));
}

/// A bare root has no /dev/pts to make terminals in.
bool terminals_can_be_made() {
  int ours = -1, theirs = -1;
  if (::openpty(&ours, &theirs, nullptr, nullptr, nullptr) != 0) return false;
  ::close(ours);
  ::close(theirs);
  return true;
}

/// Runs the command on a terminal of its own until `wanted` appears or it ends; gives all it said.
std::string on_a_terminal(const std::vector<std::string>& words, const std::string& wanted) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  std::string said;
  char piece[4096];
  for (ssize_t got; said.find(wanted) == std::string::npos &&
                    (got = ::read(terminal, piece, sizeof piece)) > 0;) {
    said.append(piece, std::size_t(got));
  }
  test::end_process(child, SIGTERM);
  int status;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  return said;
}

TEST(Progress, ATerminalSeesABarWithTheTimeLeft) {
  if (!terminals_can_be_made()) GTEST_SKIP() << "no terminals can be made here";
  const ScratchFolder folder;
  const std::string said =
      on_a_terminal({MIEN_COMMAND, "render", face_path("clay"), "-o", (folder / "a.png").string(),
                     "--size", "30000", "--threads", "1"},
                    " left");
  EXPECT_NE(said.find(" left"), std::string::npos) << said;
  EXPECT_NE(said.find(" % "), std::string::npos) << said;
}

TEST(Progress, QuickWorkShowsNothing) {
  if (!terminals_can_be_made()) GTEST_SKIP() << "no terminals can be made here";
  const ScratchFolder folder;
  EXPECT_EQ(on_a_terminal({MIEN_COMMAND, "render", face_path("seed0"), "-o",
                           (folder / "a.png").string(), "--size", "16"},
                          "never said"),
            "");
}

TEST(Progress, APictureDoesNotGoToATerminal) {
  if (!terminals_can_be_made()) GTEST_SKIP() << "no terminals can be made here";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{MIEN_COMMAND, "render", face_path("seed0"), "-o", "-"},
        {MIEN_COMMAND, "sheet", "--people", "3", "-o", "-"}})
    EXPECT_EQ(
        on_a_terminal(words, "never said"),
        "mien: --output -: will not write a picture to a terminal; redirect it or name a file\r\n");
}

}  // namespace
}  // namespace mien
