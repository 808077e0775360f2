#include "render/image/file/output_path.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace fs = std::filesystem;

namespace {

TEST(FindTarget, NewAndOldFilesAreThemselves) {
  const test::ScratchFolder folder;
  test::write_text(folder / "old.png", "old");
  for (const char* name : {"new.png", "old.png"}) {
    const auto target = find_output_path(folder / name);
    ASSERT_TRUE(target) << sentence(target.error());
    EXPECT_EQ(target->path, folder / name);
    EXPECT_FALSE(target->stream);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"old.png"}) << "asking changes nothing";
}

TEST(FindTarget, FollowsLinksToTheirEnd) {
  const test::ScratchFolder folder;
  fs::create_directory(folder / "deep");
  test::write_text(folder / "deep/real.png", "old");
  fs::create_symlink("deep/real.png", folder / "one");
  fs::create_symlink(folder / "one", folder / "two");
  fs::create_symlink("deep/future.png", folder / "dangling");
  fs::create_symlink("circle", folder / "circle");
  EXPECT_EQ(find_output_path(folder / "two")->path, folder / "deep/real.png");
  EXPECT_EQ(find_output_path(folder / "dangling")->path, folder / "deep/future.png");
  EXPECT_EQ(find_output_path(folder / "circle").error().what,
            "cannot be written: Too many levels of symbolic links");
}

TEST(FindTarget, DevicesAndPipesAreStreams) {
  const test::ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  EXPECT_TRUE(find_output_path(folder / "pipe.png")->stream);
  EXPECT_TRUE(find_output_path("/dev/null")->stream);
}

TEST(FindTarget, SaysWhatIsInTheWay) {
  const test::ScratchFolder folder;
  test::write_text(folder / "file", "");
  const std::string here = folder.path().string();
  EXPECT_EQ(sentence(find_output_path("").error()), "the output's name is empty");
  EXPECT_EQ(sentence(find_output_path(folder.path()).error()),
            here + ": is a directory, not a file");
  EXPECT_EQ(sentence(find_output_path(folder / "none/a.png").error()),
            here + "/none/a.png: its folder " + here + "/none: No such file or directory");
  EXPECT_EQ(sentence(find_output_path(folder / "file/a.png").error()),
            here + "/file/a.png: cannot be written: Not a directory");
  EXPECT_EQ(sentence(find_output_path(folder / (std::string(300, 'x') + ".png")).error()),
            here + "/" + std::string(300, 'x') + ".png: cannot be written: File name too long");
  EXPECT_EQ(sentence(find_output_path(folder / "none/").error()),
            here + "/none/: names a directory, not a file");
}

TEST(FindTarget, KnowsWhatMayNotBeWritten) {
  const test::ScratchFolder folder;
  fs::create_directory(folder / "closed");
  test::write_text(folder / "protected.png", "old");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  fs::permissions(folder / "protected.png", fs::perms::owner_read);
  if (::faccessat(AT_FDCWD, (folder / "closed").c_str(), W_OK, AT_EACCESS) == 0) {
    // Root may write anywhere: ask as somebody else.
    ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
    fs::permissions(folder / "closed", fs::perms(0555));
    fs::permissions(folder / "protected.png", fs::perms(0444));
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const auto closed = find_output_path(folder / "closed/a.png"),
             kept = find_output_path(folder / "protected.png");
  EXPECT_EQ(::seteuid(::getuid()), 0);
  EXPECT_EQ(closed.error().what,
            "its folder " + (folder / "closed").string() + " cannot be written: Permission denied");
  EXPECT_EQ(kept.error().what, "is write-protected: Permission denied");
}

}  // namespace
}  // namespace mien
