// Progress: lines for programs, a bar for people, nothing for pipes.

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <sstream>

#include "tests/support/end_process.h"
#include "tests/support/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::ScratchFolder;

TEST(Progress, JsonIsALineEach) {
  const ScratchFolder folder;
  const test::Ran ran =
      test::run_mien({"render", face_path("toon"), "-o", (folder / "a.png").string(), "--size",
                      "300", "--progress=json"});
  EXPECT_EQ(ran.code, 0);
  std::istringstream lines(ran.err);
  double done = -1;
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(json["phase"], "render");
    EXPECT_GE(json["done"].get<double>(), done) << "progress never falls";
    done = json["done"];
    EXPECT_GE(json["elapsed"].get<double>(), 0);
    EXPECT_TRUE(json["left"].is_number() || json["left"].is_null());
  }
  EXPECT_EQ(done, 1);
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
  EXPECT_EQ(on_a_terminal({MIEN_COMMAND, "render", face_path("seed0"), "-o", "-"}, "never said"),
            "mien: -o -: will not write a picture to a terminal; redirect it or name a file\r\n");
}

}  // namespace
}  // namespace mien
