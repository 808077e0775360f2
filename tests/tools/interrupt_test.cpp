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

Process start_long_render(const ScratchFolder& folder) {
  return start_mien(
      {"render", face_path("toon"), "-o", (folder / "a.png").string(), "--size", "30000"});
}

void wait_ms(int ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

TEST(Interrupt, LeavesNothingBehindAndSaysSo) {
  for (int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder folder;
    test::write_text(folder / "a.png", "old");
    Process process = start_long_render(folder);
    test::wait_until_handled(process.id(), signal);
    wait_ms(300);
    const auto sent = std::chrono::steady_clock::now();
    test::end_process(process.id(), signal);
    const Ran ran = process.wait();
    EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::seconds(5));
    EXPECT_EQ(ran.signal, signal) << "shells must see what ended it";
    EXPECT_EQ(ran.err, "mien: interrupted\n");
    EXPECT_EQ(test::read_text(folder / "a.png"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
  }
}

TEST(Killed, LeavesTheOldPictureAndTheNextRunCleansUp) {
  const ScratchFolder folder;
  test::write_text(folder / "a.png", "old");
  for (int ms : {20, 200, 500}) {
    Process process = start_long_render(folder);
    wait_ms(ms);
    test::end_process(process.id(), SIGKILL);
    EXPECT_EQ(process.wait().signal, SIGKILL);
    EXPECT_EQ(test::read_text(folder / "a.png"), "old");
  }
  EXPECT_EQ(test::run_mien(
                {"render", face_path("toon"), "-o", (folder / "a.png").string(), "--size", "32"})
                .code,
            0);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

}  // namespace
}  // namespace mien
