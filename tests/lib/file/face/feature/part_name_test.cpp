#include "lib/file/face/feature/part_name.h"

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

TEST(PartName, IsAKeyAndItsItems) {
  EXPECT_EQ(std::string_view(PartName("points", 3)), "points/3");
  EXPECT_EQ(std::string_view(PartName(PartName("patch", 0), 12)), "patch/0/12");
  EXPECT_EQ(std::string_view(PartName("upper_shift", 2147483647)), "upper_shift/2147483647");
}

TEST(PartName, NeverLeavesItsRoom) {
  EXPECT_EQ(std::string_view(PartName(std::string(400, 'a'), -2147483647)),
            std::string(40, 'a') + "/-2147483647");
}

}  // namespace
}  // namespace mien
