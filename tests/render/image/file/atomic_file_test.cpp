#include "render/image/file/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <random>
#include <thread>

#include "tests/support/process/end_process.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::read_text;
using test::ScratchFolder;
using test::write_text;

void put(const AtomicFile& file, const std::string& text) {
  ASSERT_EQ(::write(file.descriptor(), text.data(), text.size()), ssize_t(text.size()));
}

TEST(AtomicFile, AppearsWhenCommitted) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "old");
  auto file = AtomicFile::begin(folder / "a.txt");
  ASSERT_TRUE(file) << sentence(file.error());
  put(*file, "new");
  EXPECT_EQ(file->temporary().parent_path(), folder.path());
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_TRUE(file->commit());
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, GoesWhenNotCommitted) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", "old");
  {
    auto file = AtomicFile::begin(folder / "a.txt");
    put(*file, "half");
    EXPECT_EQ(folder.names().size(), 2u);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, PermissionsAreAsTheUmaskSays) {
  const ScratchFolder folder;
  const mode_t before = ::umask(027);
  EXPECT_TRUE(AtomicFile::begin(folder / "a.txt")->commit());
  ::umask(before);
  struct stat info;
  ASSERT_EQ(::stat((folder / "a.txt").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST(AtomicFile, RefusesAFolderThatIsNot) {
  const auto file = AtomicFile::begin("/nowhere/at/all.txt");
  EXPECT_EQ(sentence(file.error()),
            "/nowhere/at/all.txt: cannot write in /nowhere/at: No such file or directory");
}

TEST(AtomicFile, AFailedRenameLeavesNothing) {
  const ScratchFolder folder;
  auto file = AtomicFile::begin(folder / "a.txt");
  std::filesystem::create_directory(folder / "a.txt");
  write_text(folder / "a.txt/inside", "");
  EXPECT_EQ(file->commit().error().what, "cannot be written: Is a directory");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(Leftovers, GoUnlessSomebodyHoldsThem) {
  const ScratchFolder folder;
  const std::string dead = ".mien-0123456789abcdef.part", held = ".mien-fedcba9876543210.part";
  const std::vector<std::string> strangers = {
      ".mien-0123456789abcde.part", ".mien-0123456789abcdeX.part", "mien-0123456789abcdef.part",
      ".mien-0123456789abcdef.par"};
  for (const auto& name : strangers) write_text(folder / name, "");
  write_text(folder / dead, "half a picture");
  write_text(folder / held, "somebody is at it");
  const int holder = ::open((folder / held).c_str(), O_RDWR);
  ASSERT_EQ(::flock(holder, LOCK_EX), 0);

  EXPECT_TRUE(AtomicFile::begin(folder / "a.txt")->commit());
  EXPECT_FALSE(std::filesystem::exists(folder / dead));
  EXPECT_TRUE(std::filesystem::exists(folder / held));
  for (const auto& name : strangers) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;

  ::close(holder);
  remove_leftovers(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / held));
}

TEST(Leftovers, AFifoByThatNameBlocksNobody) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / ".mien-0123456789abcdef.part").c_str(), 0600), 0);
  remove_leftovers(folder.path());
  EXPECT_EQ(folder.names().size(), 1u);
}

/// Runs `work` in a process of its own.
template <class Work>
pid_t start(Work&& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  return child;
}

/// Writes one file after another, all "a" or all "b", a megabyte each, for ever.
[[noreturn]] void keep_writing(const std::filesystem::path& path) {
  for (char letter = 'a';; letter = letter == 'a' ? 'b' : 'a') {
    auto file = AtomicFile::begin(path);
    if (!file) ::_exit(1);
    const std::string piece(1 << 16, letter);
    for (int i = 0; i < 16; ++i) {
      if (::write(file->descriptor(), piece.data(), piece.size()) < 0) ::_exit(1);
    }
    if (!file->commit()) ::_exit(1);
  }
}

TEST(AtomicFile, KilledAtAnyMomentLeavesTheOldOrTheNew) {
  const ScratchFolder folder;
  write_text(folder / "a.txt", std::string(1 << 20, 'a'));
  std::mt19937 dice(7);
  int leftovers = 0;
  for (int run = 0; run < 40; ++run) {
    const pid_t child = start([&] { keep_writing(folder / "a.txt"); });
    std::this_thread::sleep_for(std::chrono::microseconds(dice() % 15'000));
    // One is caught for certain while it writes.
    while (run == 0 && folder.names().size() < 2) {
      test::end_process(child, SIGCONT);
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      test::end_process(child, SIGSTOP);
      int stopped = 0;
      ::waitpid(child, &stopped, WUNTRACED);
    }
    test::end_process(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the writer failed by itself";
    const std::string text = read_text(folder / "a.txt");
    ASSERT_EQ(text.size(), std::size_t(1) << 20) << "run " << run;
    ASSERT_EQ(text.find_first_not_of(text[0]), std::string::npos) << "run " << run;
    leftovers += folder.names().size() > 1;
  }
  EXPECT_GT(leftovers, 0) << "no kill came while writing: the test tests nothing";
  EXPECT_TRUE(AtomicFile::begin(folder / "a.txt")->commit());
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, WritersOfOneFileDoNotMeet) {
  const ScratchFolder folder;
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    children.push_back(start([&] {
      for (int run = 0; run < 25; ++run) {
        auto file = AtomicFile::begin(folder / "a.txt");
        if (!file || ::write(file->descriptor(), "0123456789", 10) != 10 || !file->commit())
          ::_exit(1);
      }
    }));
  }
  for (pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(read_text(folder / "a.txt"), "0123456789");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

}  // namespace
}  // namespace mien
