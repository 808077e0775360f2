#include "lib/file/json/read_bytes.h"

#include <gtest/gtest.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(ReadBytes, GivesAllOfThemAsTheyAre) {
  const test::ScratchFolder folder;
  std::string bytes;
  for (int i = 0; i < 200'000; ++i) bytes += char(i * 7);
  test::write_text(folder / "a", bytes);
  const auto read = read_bytes(folder / "a", bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, bytes);
  test::write_text(folder / "empty", "");
  EXPECT_EQ(*read_bytes(folder / "empty", 0), "");
}

TEST(ReadBytes, StopsWhereThereAreTooMany) {
  const auto endless = read_bytes("/dev/zero", 1000);
  ASSERT_FALSE(endless);
  EXPECT_EQ(sentence(endless.error()), "/dev/zero: longer than 1000 bytes (limit: bytes)");
}

TEST(ReadBytes, SaysWhyItCannot) {
  EXPECT_EQ(sentence(read_bytes("/no/such\nfile", 9).error()),
            "/no/such\\x0Afile: cannot be read: No such file or directory");
  EXPECT_EQ(sentence(read_bytes("/tmp", 9).error()), "/tmp: is a directory");
}

}  // namespace
}  // namespace mien
