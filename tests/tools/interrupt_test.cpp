// Ctrl-C and worse.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/end_process.h"
#include "tests/support/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Process;
using test::Ran;
using test::ScratchFolder;
using test::start_mien;

void wait_a_little() {
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

using Words = std::vector<std::string>;

/// Work that takes far longer than it takes to be stopped.
Process start_long_render(const ScratchFolder& folder, const Words& kind = {"--size", "30000"}) {
  Words words{"render", face_path("toon"), "-o", (folder / "a.png").string()};
  words.insert(words.end(), kind.begin(), kind.end());
  return start_mien(words);
}

// What ignores a signal ends with a picture, some time or other.
TEST(Interrupt, LeavesNothingBehindAndSaysSo) {
  for (const Words& kind :
       {Words{"--size", "30000"}, Words{"--size", "12000", "--effect", "mosaic:40"},
        Words{"--size", "1500", "--debug", "distance"},
        Words{"--size", "12000", "--debug", "looks"}})
    for (const int signal : {SIGINT, SIGTERM}) {
      const ScratchFolder folder;
      test::write_text(folder / "a.png", "old");
      Process process = start_long_render(folder, kind);
      test::wait_until_handled(process.id(), signal);
      test::end_process(process.id(), signal);
      const Ran ran = process.wait();
      EXPECT_EQ(ran.signal, signal) << kind.back() << ": shells must see what ended it";
      EXPECT_EQ(ran.err, "mien: interrupted\n") << kind.back();
      EXPECT_TRUE(test::read_text(folder / "a.png") == "old") << kind.back();
      EXPECT_EQ(folder.names(), Words{"a.png"}) << kind.back();
    }
}

// Commands that draw many faces end, too, and leave what was there.
TEST(Interrupt, StopsCrowdsAndExperiments) {
  const ScratchFolder folder;
  test::write_text(folder / "a.png", "old");
  const std::string out = (folder / "a.png").string();
  for (const Words& words :
       {Words{"sheet", "--people", "5000", "-o", out}, Words{"check", "--nonsense", "5000"},
        Words{"morph", "between", "A66CB-AA5S0-14", "A66CB-AA5S0-14", "-o", out, "--steps",
              "1000"}}) {
    Process process = start_mien(words);
    test::wait_until_handled(process.id(), SIGINT);
    test::end_process(process.id(), SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.signal, SIGINT) << words[0];
    EXPECT_EQ(ran.err, "mien: interrupted\n") << words[0];
    EXPECT_EQ(test::read_text(folder / "a.png"), "old") << words[0];
  }
}

// The picture itself is there by then: it is drawn before its errors.
TEST(Interrupt, StopsAnErrorMap) {
  const ScratchFolder folder;
  Process process =
      start_long_render(folder, {"--size", "12000", "--error-map", (folder / "e.png").string()});
  const auto picture = folder / "a.png";
  while (!std::filesystem::exists(picture)) wait_a_little();
  test::end_process(process.id(), SIGINT);
  const Ran ran = process.wait();
  EXPECT_EQ(ran.signal, SIGINT);
  EXPECT_EQ(ran.err, "mien: interrupted\n");
  EXPECT_EQ(folder.names(), Words{"a.png"});
}

TEST(Killed, LeavesTheOldPictureAndTheNextRunCleansUp) {
  const ScratchFolder folder;
  test::write_text(folder / "a.png", "old");
  for (const bool begun : {false, true}) {
    Process process = start_long_render(folder);
    while (begun && folder.names().size() < 2) wait_a_little();
    test::end_process(process.id(), SIGKILL);
    EXPECT_EQ(process.wait().signal, SIGKILL);
    EXPECT_EQ(test::read_text(folder / "a.png"), "old");
  }
  EXPECT_EQ(test::run_mien(
                {"render", face_path("toon"), "-o", (folder / "a.png").string(), "--size", "32"})
                .code,
            0);
  EXPECT_EQ(folder.names(), Words{"a.png"});
}

}  // namespace
}  // namespace mien
