// Parts of a plan: what they draw, and how they go on after everything that may end them.

#include <sys/mount.h>

#include <chrono>
#include <thread>

#include "tests/support/process/end_process.h"
#include "tests/tools/mien/batch/batch_fixture.h"

namespace mien {
namespace {

namespace fs = std::filesystem;

TEST_F(BatchTest, PartsTogetherAreTheWhole) {
  plan(people(7));
  EXPECT_EQ(batch("whole").out, "7 items: 7 drawn, 0 there already\n");
  for (const char* part : {"3/3", "1/3", "2/3"}) {
    const Ran ran = batch("out", part);
    EXPECT_EQ(ran.code, 0) << ran.err;
  }
  EXPECT_EQ(files(), files("whole"));
  EXPECT_EQ(join().out, "7 items, all whole; 0 joined\n");
}

// Anybody may draw one of them by hand.
TEST_F(BatchTest, APersonIsThatOfTheWordAndItsPlace) {
  plan(people(3));
  ASSERT_EQ(batch().code, 0);
  for (const char* word : {"ada/0", "ada/1", "ada/2"}) {
    std::string code = run_mien({"new", "--seed", word}).out;
    code.pop_back();
    ASSERT_EQ(run_mien({"render", code, "--size", "24", "-o", path("a.png")}).code, 0);
    EXPECT_EQ(read_text(path("a.png")), read_text(path("out/crowd/" + code + ".png"))) << word;
  }
}

TEST_F(BatchTest, WhatIsThereAndWholeIsLeftAlone) {
  plan(people(5));
  ASSERT_EQ(batch().code, 0);
  const auto all = files("out", true);
  EXPECT_EQ(batch().out, "5 items: 0 drawn, 5 there already\n");
  auto one = std::next(all.begin(), 2);
  write_text(folder_ / "out" / one->first, "damaged");
  fs::remove(folder_ / "out" / all.begin()->first);
  EXPECT_EQ(batch().out, "5 items: 2 drawn, 3 there already\n");
  EXPECT_EQ(files("out", true), all);
}

TEST_F(BatchTest, AnotherSplitGoesOnWithWhatIsThere) {
  plan(people(6));
  ASSERT_EQ(batch("out", "1/2").code, 0);
  EXPECT_EQ(batch("out", "1/3").out, "2 items: 0 drawn, 2 there already\n");
  EXPECT_EQ(batch("out", "2/3").out, "2 items: 1 drawn, 1 there already\n");
  EXPECT_EQ(batch("out", "3/3").code, 0);
  EXPECT_EQ(join().code, 0);
}

class KilledTest : public BatchTest {
 protected:
  int pictures() const {
    if (!fs::exists(path("out/crowd"))) return 0;
    return int(
        std::ranges::count_if(fs::directory_iterator(path("out/crowd")),
                              [](const auto& one) { return one.path().extension() == ".png"; }));
  }
};

// Killed wherever it is, again and again, it comes to the same files.
TEST_F(KilledTest, AKilledPartGoesOn) {
  plan(people(60, "160"));
  ASSERT_EQ(batch("whole").code, 0);
  for (int kill = 0; kill < 4; ++kill) {
    test::Process process = test::start_mien(batch_words("out", {}));
    for (int i = 0; i < 12'000 && pictures() < 3 * kill + 2; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    test::end_process(process.id(), SIGKILL);
    process.wait();
    EXPECT_EQ(join().code, 1) << "no part has ended";
  }
  const Ran ran = batch();
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out, "60 items: 60 drawn, 0 there already\n")
      << "nothing was left of what was done";
  EXPECT_EQ(files(), files("whole")) << "no journal, no temporary, the same bytes";
  EXPECT_EQ(read_text(manifest("1-of-1")), read_text(manifest("1-of-1", "whole")));
}

// A queue that takes a worker for dead starts a second one.
TEST_F(BatchTest, TwoRunsOfOnePartDoNotDisturbEachOther) {
  plan(people(20));
  ASSERT_EQ(batch("whole").code, 0);
  test::Process one = test::start_mien(batch_words("out", {})),
                other = test::start_mien(batch_words("out", {}));
  EXPECT_EQ(one.wait().code, 0);
  EXPECT_EQ(other.wait().code, 0);
  EXPECT_EQ(files("out", true), files("whole", true));
}

TEST_F(BatchTest, AJournalsCutLineCountsForNothing) {
  plan(people(3));
  ASSERT_EQ(batch().code, 0);
  const auto all = files("out", true);
  const std::string lines = read_text(manifest("1-of-1"));
  fs::remove(manifest("1-of-1"));
  const std::size_t second = lines.find('\n', lines.find('\n') + 1) + 1;  // a header and an item
  write_text(path("out/.mien-journal-1-of-1-0123456789abcdef.jsonl"), lines.substr(0, second + 40));
  EXPECT_EQ(batch().out, "3 items: 2 drawn, 1 there already\n");
  EXPECT_EQ(files("out", true), all);
}

TEST_F(BatchTest, CtrlCStopsItAndSaysSo) {
  plan(people(5) + R"(, {"run": ["render", ")" + test::face_path("toon") +
       R"(", "--size", "30000"], "output": "toon.png"})");
  test::Process process = test::start_mien(batch_words("out", {}));
  for (int i = 0; i < 6000; ++i) {  // until the large one is begun
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (!fs::exists(path("out"))) continue;
    bool begun = false;
    for (const auto& one : fs::directory_iterator(folder_ / "out"))
      begun = begun || one.path().extension() == ".part";
    if (begun) break;
  }
  test::end_process(process.id(), SIGINT);
  const auto asked = std::chrono::steady_clock::now();
  const Ran ran = process.wait();
  EXPECT_EQ(ran.signal, SIGINT);
  EXPECT_EQ(ran.err, "mien: interrupted\n");
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(10));
  EXPECT_FALSE(fs::exists(path("out/toon.png")));
  for (const auto& [name, text] : files()) EXPECT_FALSE(name.ends_with(".part")) << name;
  plan(people(5));
}

// Clocks of nodes differ: nothing asks them.
TEST_F(BatchTest, AClockADayOffChangesNothing) {
  plan(people(4));
  ASSERT_EQ(batch("out", "1/2").code, 0);
  for (const auto& one : fs::recursive_directory_iterator(folder_ / "out"))
    fs::last_write_time(one, fs::file_time_type::clock::now() + std::chrono::hours(24));
  fs::last_write_time(path("plan.json"), fs::file_time_type::clock::now() - std::chrono::hours(24));
  EXPECT_EQ(batch("out", "1/2").out, "2 items: 0 drawn, 2 there already\n");
  EXPECT_EQ(batch("out", "2/2").code, 0);
  EXPECT_EQ(join().code, 0);
}

TEST_F(BatchTest, TellsWhereAnItemWentWrong) {
  plan(R"({"run": ["render", "toon", "--size", "24", "--emotion", "{feeling}"],
           "each": {"feeling": ["joy", "joyy", "fear"]}, "output": "{feeling}.png"})");
  const Ran ran = batch();
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, "mien: " + path("plan.json") +
                         ":1:56: /jobs/0: joyy.png: --emotion joyy: no emotion named \"joyy\"; did "
                         "you mean \"joy\"?\n");
  EXPECT_TRUE(fs::exists(path("out/joy.png")));
}

/// A disk of so many bytes under the folder "out"; none where it may not be mounted.
class SmallDisk {
 public:
  SmallDisk(std::string path, const char* size) : path_(std::move(path)) {
    fs::create_directories(path_);
    mounted_ = ::mount("none", path_.c_str(), "tmpfs", 0, size) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount(path_.c_str());
  }
  bool mounted() const { return mounted_; }
  bool protect(bool on) const {
    return ::mount("none", path_.c_str(), "tmpfs", MS_REMOUNT | (on ? unsigned(MS_RDONLY) : 0u),
                   nullptr) == 0;
  }

 private:
  std::string path_;
  bool mounted_ = false;
};

TEST_F(BatchTest, ADiskThatIsFullHalfWayIsOneSentence) {
  const SmallDisk disk(path("out"), "size=300k");
  if (!disk.mounted()) GTEST_SKIP() << "may not mount a small disk";
  plan(people(60, "200"));
  const Ran ran = batch();
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_NE(ran.err.find("No space left on device"), std::string::npos) << ran.err;
  ASSERT_EQ(batch("whole").code, 0);
  const auto whole = files("whole");
  EXPECT_GT(files().size(), 3u);
  for (const auto& [name, bytes] : files()) {
    if (name.starts_with(".mien-journal-")) continue;
    ASSERT_EQ(whole.count(name), 1u) << name;
    EXPECT_TRUE(whole.at(name) == bytes) << name << " is half a file";
  }
}

TEST_F(BatchTest, AFolderThatIsReadOnlyIsOneSentenceUnlessAllIsThere) {
  const SmallDisk disk(path("out"), "size=3m");
  if (!disk.mounted()) GTEST_SKIP() << "may not mount a small disk";
  plan(people(4));
  ASSERT_EQ(batch("out", "1/2").code, 0);
  ASSERT_TRUE(disk.protect(true));
  EXPECT_EQ(batch("out", "1/2").out, "2 items: 0 drawn, 2 there already\n");
  const Ran ran = batch("out", "2/2");
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err, "mien: " + path("out") + ": cannot be written in: Read-only file system\n");
}

TEST_F(BatchTest, PartsAreKOfN) {
  plan(people(2));
  for (const char* part :
       {"0/2", "3/2", "1", "1/0", "/", "1/2/3", "one/two", "-1/2", "1/2000000"}) {
    const Ran ran = batch("out", part);
    EXPECT_EQ(ran.code, 2) << part;
    EXPECT_EQ(ran.err, "mien: --part " + std::string(part) +
                           ": expected K/N, the K-th of N parts, 1/4 to 4/4\n");
  }
  EXPECT_EQ(batch("out", "3/5").out, "1 items: 1 drawn, 0 there already\n");
  EXPECT_EQ(batch("out", "1/5").out, "0 items: 0 drawn, 0 there already\n");
}

TEST_F(BatchTest, ProgressGoesFromNothingToAllOnce) {
  plan(people(10));
  auto words = batch_words("out", {});
  words.insert(words.end(), {"--progress", "json"});
  const Ran ran = run_mien(words);
  double last = -1;
  std::size_t at = 0;
  while ((at = ran.err.find("\"done\": ", at)) != std::string::npos) {
    const double done = std::stod(ran.err.substr(at += 8));
    EXPECT_GE(done, last);
    last = done;
  }
  EXPECT_EQ(last, 1) << ran.err;
}

}  // namespace
}  // namespace mien
