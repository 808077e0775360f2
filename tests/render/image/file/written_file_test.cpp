#include "render/image/file/written_file.h"

#include <gtest/gtest.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

Expected<Done> hello(const PutBytes& put) {
  if (auto done = put("hello ", 6); !done) return done;
  return put("world", 5);
}

TEST(WrittenFile, HasWhatWasPut) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(write_file(folder / "a", hello));
  EXPECT_EQ(test::read_text(folder / "a"), "hello world");
}

TEST(WrittenFile, IsAsBeforeWhereWritingFails) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(write_file(folder / "a", hello));
  const auto done = write_file(folder / "a", [](const PutBytes& put) -> Expected<Done> {
    (void)put("half", 4);
    return Error{"", "went wrong"};
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, (folder / "a").string());
  EXPECT_EQ(done.error().what, "went wrong");
  EXPECT_EQ(test::read_text(folder / "a"), "hello world");
}

TEST(WrittenFile, SaysWhatStandsInTheWay) {
  const test::ScratchFolder folder;
  EXPECT_EQ(write_file("/dev/full", hello).error().what,
            "cannot be written: No space left on device");
  const auto done = write_file(folder / "none" / "a", hello);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().where, (folder / "none" / "a").string());
}

}  // namespace
}  // namespace mien
