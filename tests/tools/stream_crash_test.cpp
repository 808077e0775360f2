// Streamed pictures under kill −9, under size limits, beside a run that is still at work.
//
// MIEN_KILLS=200 for the long form.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/support/process/end_process.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::ScratchFolder;

std::vector<std::string> words_for(const std::filesystem::path& out) {
  return {"render", face_path("seed0"), "-o", out.string(), "--size", "2200", "--memory", "16M"};
}

int kills() {
  const char* const wanted = std::getenv("MIEN_KILLS");
  return wanted ? std::atoi(wanted) : 8;
}

TEST(Streamed, KilledAtAnyMomentLeavesTheOldFileOrNone) {
  using Clock = std::chrono::steady_clock;
  std::mt19937 dice(20);
  for (const char* name : {"a.png", "a.tif"}) {
    const ScratchFolder folder;
    const auto began = Clock::now();
    ASSERT_EQ(test::run_mien(words_for(folder / name)).code, 0);
    const double whole = std::chrono::duration<double>(Clock::now() - began).count();
    const std::string complete = test::read_text(folder / name);
    int before_the_end = 0;
    for (int i = 0; i < (kills() + 1) / 2; ++i) {
      const bool had_one = i % 2 == 0;
      std::filesystem::remove(folder / name);
      if (had_one) test::write_text(folder / name, "old");
      test::Process process = test::start_mien(words_for(folder / name));
      if (i == 0)  // one is caught for certain: it has only begun
        test::wait_until_handled(process.id(), SIGINT);
      else
        std::this_thread::sleep_for(
            std::chrono::duration<double>(whole * double(dice() % 1000) / 1000));
      test::end_process(process.id(), SIGKILL);
      process.wait();
      const bool there = std::filesystem::exists(folder / name);
      const std::string now = there ? test::read_text(folder / name) : "";
      if (there && now.size() == complete.size()) {
        EXPECT_TRUE(now == complete);  // it was quicker
        continue;
      }
      ++before_the_end;
      EXPECT_EQ(there, had_one);
      EXPECT_TRUE(!had_one || now == "old");
    }
    EXPECT_GT(before_the_end, 0) << "every run was quicker than its killer";
    std::filesystem::remove(folder / name);
    ASSERT_EQ(test::run_mien(
                  {"render", face_path("seed0"), "-o", (folder / name).string(), "--size", "32"})
                  .code,
              0);
    EXPECT_EQ(folder.names(), std::vector<std::string>{name}) << "the next run clears up";
  }
}

TEST(Streamed, ALeftoverWhoseLockIsHeldStays) {
  const ScratchFolder folder;
  const std::string at_work = ".mien-00112233aabbccdd.part";
  test::write_text(folder / at_work, "being written");
  const int held = ::open((folder / at_work).c_str(), O_RDWR);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  const std::vector<std::string> words{
      "render", face_path("seed0"), "-o", (folder / "a.png").string(), "--size", "32"};
  ASSERT_EQ(test::run_mien(words).code, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{at_work, "a.png"}));
  ::close(held);
  ASSERT_EQ(test::run_mien(words).code, 0);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

TEST(Streamed, AFileAtItsLimitIsAClearErrorAndNothingIsLeft) {
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg"}) {
    const ScratchFolder folder;
    const std::string out = (folder / name).string();
    // In blocks of 1024 bytes; files of the test's own are smaller. The tracer of GCC 12's leak sanitizer may crash as
    // the threads of a library that writes pictures end, and would say so here.
    const Ran ran =
        test::Process({"/bin/bash", "-c",
                       "ulimit -f 8; export ASAN_OPTIONS=detect_leaks=0; exec " MIEN_COMMAND
                       " render " +
                           face_path("toon") + " -o " + out + " --size 700"})
            .wait();
    EXPECT_EQ(ran.code, 1) << name;
    EXPECT_EQ(ran.err, "mien: " + out + ": cannot be written: File too large\n");
    EXPECT_TRUE(folder.names().empty()) << name;
  }
}

}  // namespace
}  // namespace mien
