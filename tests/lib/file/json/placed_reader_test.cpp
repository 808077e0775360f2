#include "lib/file/json/placed_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;
using test::write_text;

TEST(PlacedReader, GivesBytesOfAnyPlace) {
  const ScratchFolder folder;
  write_text(folder / "a", "0123456789");
  const auto file = PlacedReader::open(folder / "a");
  ASSERT_TRUE(file) << sentence(file.error());
  EXPECT_EQ(file->size(), 10u);
  char bytes[3] = {};
  EXPECT_TRUE(file->read(7, 3, bytes));
  EXPECT_EQ(std::string(bytes, 3), "789");
  EXPECT_TRUE(file->read(0, 1, bytes));
  EXPECT_EQ(bytes[0], '0');
  EXPECT_TRUE(file->read(10, 0, bytes));
}

TEST(PlacedReader, AFileThatHasBecomeShorterIsAnError) {
  const ScratchFolder folder;
  write_text(folder / "a", "0123456789");
  const auto file = PlacedReader::open(folder / "a");
  std::filesystem::resize_file(folder / "a", 4);
  char bytes[8] = {};
  EXPECT_EQ(file->read(0, 8, bytes).error().what,
            "cannot be read to its end: it has changed meanwhile");
  EXPECT_TRUE(file->read(0, 4, bytes));
}

TEST(PlacedReader, AFailedReadIsAnErrorWithItsReason) {
  const auto memory = PlacedReader::open("/proc/self/mem");  // nothing is at its beginning
  ASSERT_TRUE(memory) << sentence(memory.error());
  char bytes[8] = {};
  EXPECT_EQ(sentence(memory->read(0, 8, bytes).error()),
            "/proc/self/mem: cannot be read: Input/output error");
}

TEST(PlacedReader, RefusesWhatIsNoFile) {
  const ScratchFolder folder;
  EXPECT_EQ(PlacedReader::open(folder.path()).error().what, "is a directory");
  EXPECT_EQ(PlacedReader::open(folder / "none").error().what,
            "cannot be read: No such file or directory");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(PlacedReader::open(folder / "pipe").error().what, "is not a file");
}

}  // namespace
}  // namespace mien
