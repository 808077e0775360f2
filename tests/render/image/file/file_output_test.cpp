#include "render/image/file/file_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(FileOutput, WritesOneBehindTheOther) {
  const test::ScratchFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  FileOutput out(file, false);
  EXPECT_TRUE(out.write("hello ", 6));
  EXPECT_TRUE(out.write("world", 5));
  EXPECT_EQ(out.failure(), 0);
  ::close(file);
  EXPECT_EQ(test::read_text(folder / "a"), "hello world");
}

TEST(FileOutput, KeepsTheFirstFailure) {
  const int full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  FileOutput out(full, true);
  EXPECT_FALSE(out.write("abc", 3));
  EXPECT_EQ(out.failure(), ENOSPC);
  ::close(full);
  EXPECT_FALSE(out.write("abc", 3));
  out.fail(EIO);
  EXPECT_EQ(out.failure(), ENOSPC);
}

}  // namespace
}  // namespace mien
