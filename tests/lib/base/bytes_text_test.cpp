#include "lib/base/bytes_text.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(BytesText, HasThreeDigits) {
  EXPECT_EQ(bytes_text(1), "1 byte");
  EXPECT_EQ(bytes_text(999), "999 bytes");
  EXPECT_EQ(bytes_text(39 << 10), "39 KiB");
  EXPECT_EQ(bytes_text(4ull << 30), "4 GiB");
  EXPECT_EQ(bytes_text(1500ull << 20), "1.46 GiB");
}

}  // namespace
}  // namespace mien
