#include "lib/base/from_chars.h"

#include <gtest/gtest.h>

#include <string_view>

namespace mien {
namespace {

std::errc read(std::string_view text, double& value) {
  return from_chars(text.data(), text.data() + text.size(), value).ec;
}

TEST(FromChars, RoundsToTheNearestDouble) {
  double value = 0;
  EXPECT_EQ(read("0.1", value), std::errc{});
  EXPECT_EQ(value, 0.1);
  EXPECT_EQ(read("9007199254740993", value), std::errc{});
  EXPECT_EQ(value, 9007199254740992.0);
  EXPECT_EQ(read("-4.9406564584124654e-324", value), std::errc{});
  EXPECT_EQ(value, -4.9406564584124654e-324);
}

TEST(FromChars, SaysWhatIsTooLargeOrTooSmall) {
  double value = 7;
  EXPECT_EQ(read("1e999", value), std::errc::result_out_of_range);
  EXPECT_EQ(read("-1e-999", value), std::errc::result_out_of_range);
  EXPECT_EQ(value, 7);
  EXPECT_EQ(read("0e999", value), std::errc{});
  EXPECT_EQ(value, 0);
}

TEST(FromChars, RefusesWhatIsNoNumber) {
  double value = 7;
  EXPECT_EQ(read("x", value), std::errc::invalid_argument);
  EXPECT_EQ(read("", value), std::errc::invalid_argument);
  EXPECT_EQ(value, 7);
}

}  // namespace
}  // namespace mien
