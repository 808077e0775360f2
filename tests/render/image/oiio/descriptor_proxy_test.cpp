#include "render/image/oiio/descriptor_proxy.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(DescriptorProxy, WritesAndReadsAnywhereInAFile) {
  const test::ScratchFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  DescriptorProxy proxy(file, false);
  EXPECT_EQ(proxy.write("hello world", 11), 11u);
  EXPECT_TRUE(proxy.seek(6));
  EXPECT_EQ(proxy.write("W", 1), 1u);
  EXPECT_EQ(proxy.tell(), 7);
  EXPECT_EQ(proxy.pwrite("H", 1, 0), 1u);
  EXPECT_EQ(proxy.size(), 11u);
  char word[6] = {};
  EXPECT_EQ(proxy.pread(word, 5, 6), 5u);
  EXPECT_STREQ(word, "World");
  EXPECT_EQ(proxy.failure(), 0);
  ::close(file);
  EXPECT_EQ(test::read_text(folder / "a"), "Hello World");
}

TEST(DescriptorProxy, APipeTakesBytesInOrderOnly) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  DescriptorProxy proxy(ends[1], true);
  EXPECT_EQ(proxy.write("abc", 3), 3u);
  EXPECT_TRUE(proxy.seek(3));
  EXPECT_FALSE(proxy.seek(0));
  EXPECT_EQ(proxy.failure(), ESPIPE);
  char got[4] = {};
  EXPECT_EQ(::read(ends[0], got, 3), 3);
  EXPECT_STREQ(got, "abc");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(DescriptorProxy, KeepsTheFirstFailure) {
  const int full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  DescriptorProxy proxy(full, false);
  EXPECT_EQ(proxy.write("abc", 3), 0u);
  EXPECT_EQ(proxy.failure(), ENOSPC);
  ::close(full);
  EXPECT_EQ(proxy.write("abc", 3), 0u);
  EXPECT_EQ(proxy.failure(), ENOSPC);
}

}  // namespace
}  // namespace mien
