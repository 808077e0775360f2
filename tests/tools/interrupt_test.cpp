// Ctrl-C and worse.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

#include "tests/support/process/effort.h"
#include "tests/support/process/end_process.h"
#include "tests/support/process/run_command.h"

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
  for (const Words& words : {Words{"sheet", "--people", "5000", "--cell", "128", "-o", out},
                             Words{"check", "--nonsense", "5000"},
                             Words{"morph", "between", "A66CB-AA5S0-14", "A66CB-AA5S0-14", "-o",
                                   out, "--steps", "1000"}}) {
    Process process = start_mien(words);
    test::wait_until_handled(process.id(), SIGINT);
    test::end_process(process.id(), SIGINT);
    const Ran ran = process.wait();
    EXPECT_EQ(ran.signal, SIGINT) << words[0];
    EXPECT_EQ(ran.err, "mien: interrupted\n") << words[0];
    EXPECT_EQ(test::read_text(folder / "a.png"), "old") << words[0];
  }
}

/// [s] Computing time of the process after the signal, of all its threads: a busy machine does not lengthen it.
double work_after(const Words& words, int signal) {
  const auto of_children = [] {
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    return double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * double(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  };
  const double before = of_children();
  Process process = start_mien(words);
  test::wait_until_handled(process.id(), signal);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  clockid_t clock{};
  timespec at_signal{};
  EXPECT_EQ(::clock_getcpuclockid(process.id(), &clock), 0);
  ::clock_gettime(clock, &at_signal);
  test::end_process(process.id(), signal);
  const Ran ran = process.wait();
  EXPECT_EQ(ran.signal, signal) << words.back();
  EXPECT_EQ(ran.err, "mien: interrupted\n") << words.back();
  return of_children() - before - double(at_signal.tv_sec) - 1e-9 * double(at_signal.tv_nsec);
}

// Many people, whose recipes take long to give back; and a face whose outlines have many points.
TEST(Interrupt, EndsTestsOfFaces) {
  constexpr double kMost = (test::kSanitized ? 4 : 1) * 0.1;  // [s] 50 ms of two threads
  EXPECT_LT(work_after({"check", "--nonsense", "20000"}, SIGTERM), kMost);
  const ScratchFolder folder;
  const auto face = folder / "long.face.json";
  std::string points;
  for (int i = 0; i < 50'000; ++i)
    points += (i ? ",[" : "[") + std::to_string(0.7 * std::cos(i * 2e-5 * 6.2831853)) + "," +
              std::to_string(0.7 * std::sin(i * 2e-5 * 6.2831853)) + "]";
  std::string features;
  for (const char* name : {"head", "hair", "mouth"})
    features += (features.empty() ? "" : ",") + std::string(R"({"kind": "path", "name": ")") +
                name + R"(", "paint": ")" + name + R"(", "points": [)" + points + "]}";
  test::write_text(face, R"({"format": "mien-face", "format_version": 1,
    "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "background": "mouth",
    "palette": {"head": "#204080", "hair": "#fff7e0", "mouth": "#800000"}, "features": [)" +
                             features + "]}");
  EXPECT_LT(work_after({"check", "--nonsense", face.string()}, SIGINT), kMost);
}

// Many small pictures, and one large one that is read, put together and written.
TEST(Interrupt, EndsBatchesAndJoins) {
  constexpr double kMost = (test::kSanitized ? 4 : 1) * 0.1;  // [s] 50 ms of two threads
  const ScratchFolder folder;
  const auto plan = (folder / "plan.json").string(), out = (folder / "out").string();
  const auto write_plan = [&](const std::string& job) {
    test::write_text(plan,
                     R"({"format": "mien-batch", "format_version": 1, "jobs": [)" + job + "]}");
  };
  write_plan(R"({"run": ["render", "{who}", "--size", "64"], "each": {"who": {"people": 5000}},
                 "output": "{who}.png"})");
  EXPECT_LT(work_after({"batch", plan, "-o", (folder / "people").string()}, SIGINT), kMost);
  write_plan(R"({"run": ["render", "toon", "--size", "16000"], "each": {"at": {"regions": [2, 2]}},
                 "output": "{at}.tif", "join": "toon.tif"})");
  ASSERT_EQ(test::run_mien({"batch", plan, "-o", out}).code, 0);
  EXPECT_LT(work_after({"join", plan, out}, SIGTERM), kMost);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "toon.tif"));
}

// Work between rows: outlines, their order, distances.
TEST(Interrupt, IsHeardInEveryStage) {
  const ScratchFolder folder;
  const auto face = folder / "spikes.face.json";
  std::string points;
  for (int i = 0; i < 6000; ++i)
    points += (i ? ",[" : "[") + std::to_string((i * 7919 % 2000) / 1000.0 - 1) + "," +
              std::to_string((i * 104729 % 1999) / 1000.0 - 1) + "]";
  test::write_text(face, R"({"format": "mien-face", "format_version": 1, "name": "spikes",
    "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"}, "palette": {"a": "#204080", "b": "#fff7e0"},
    "background": "b", "features": [{"name": "p", "kind": "path", "paint": "a", "points": [)" +
                             points + "]}]}");
  test::write_text(folder / "a.png", "old");
  Process process =
      start_mien({"render", face.string(), "-o", (folder / "a.png").string(), "--size", "256"});
  test::wait_until_handled(process.id(), SIGTERM);
  wait_a_little();
  const auto sent = std::chrono::steady_clock::now();
  test::end_process(process.id(), SIGTERM);
  const Ran ran = process.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - sent, std::chrono::milliseconds(500));
  EXPECT_EQ(ran.signal, SIGTERM);
  EXPECT_EQ(ran.err, "mien: interrupted\n");
  EXPECT_TRUE(test::read_text(folder / "a.png") == "old");
}

TEST(Interrupt, IsNotNeededForPipesWithoutAnotherEnd) {
  const ScratchFolder folder;
  const auto pipe = (folder / "pipe.png").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Ran read = test::run_mien({"check", pipe});
  EXPECT_EQ(read.code, 1);
  EXPECT_NE(read.err.find("is a pipe that nothing is written to"), std::string::npos) << read.err;
  const Ran written = test::run_mien({"render", face_path("seed0"), "-o", pipe, "--size", "32"});
  EXPECT_EQ(written.code, 1);
  EXPECT_NE(written.err.find("is a pipe that nobody reads"), std::string::npos) << written.err;
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
