#include "tools/mien/http/percent_text.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

TEST(PercentText, IsDecodedOnce) {
  EXPECT_EQ(percent_decoded("a%20b%2F%41%c3%a9+"), "a b/A\xc3\xa9+");
  EXPECT_EQ(percent_decoded("%252e"), "%2e");
  EXPECT_EQ(percent_decoded("%00"), std::string(1, '\0'));
  EXPECT_EQ(percent_decoded("a+b", true), "a b");
  EXPECT_EQ(percent_decoded("%2B", true), "+");
  EXPECT_EQ(percent_decoded(""), "");
}

TEST(PercentText, NeedsTwoDigits) {
  for (const char* text : {"%", "%4", "a%", "%g0", "%0g", "%%41", "%-1", "% 1"})
    EXPECT_FALSE(percent_decoded(text)) << text;
}

TEST(PercentText, TargetsHaveTwoParts) {
  const auto parts = [](std::string_view target) {
    const TargetParts two = target_parts(target);
    return std::string(two.path) + "|" + std::string(two.query);
  };
  EXPECT_EQ(parts("/a?b=c?d#e?f"), "/a|b=c?d");
  EXPECT_EQ(parts("/a#?b"), "/a|");
  EXPECT_EQ(parts("?"), "|");
  EXPECT_EQ(parts(""), "|");
}

}  // namespace
}  // namespace mien::command
