#include "lib/base/folder_names.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(FolderNames, AreAllButThePlaceItself) {
  const test::ScratchFolder folder;
  test::write_text(folder / ".hidden", "");
  test::write_text(folder / "b", "");
  std::filesystem::create_directory(folder / "a");
  auto names = folder_names(folder.path());
  ASSERT_TRUE(names) << sentence(names.error());
  std::sort(names->begin(), names->end());
  EXPECT_EQ(*names, (std::vector<std::string>{".hidden", "a", "b"}));
}

TEST(FolderNames, AreAnErrorWhereThereIsNoFolder) {
  EXPECT_EQ(sentence(folder_names("/no/such/folder").error()),
            "/no/such/folder: No such file or directory");
}

}  // namespace
}  // namespace mien
