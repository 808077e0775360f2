#include "lib/base/synonyms.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Synonyms, AreAskedByWholeWords) {
  ASSERT_FALSE(meanings("happiness").empty());
  EXPECT_EQ(meanings("happiness")[0], "joy");
  EXPECT_EQ(meanings("turn")[0], "yaw");
  EXPECT_TRUE(meanings("happ").empty());
  EXPECT_TRUE(meanings("happy happiness").empty());
  EXPECT_TRUE(meanings("").empty());
}

TEST(Synonyms, HaveNoEmptyMeaning) {
  for (const std::string_view word : {"vrm", "smile", "experiment"}) {
    EXPECT_FALSE(meanings(word).empty()) << word;
    for (const std::string_view meaning : meanings(word)) EXPECT_FALSE(meaning.empty()) << word;
  }
}

}  // namespace
}  // namespace mien
