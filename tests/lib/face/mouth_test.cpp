#include <mien/mouth.h>

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace mien {
namespace {

TEST(Mouth, HasAControlForEachActOfItsOwn) {
  std::set<std::string_view> names;
  for (const MouthControl& control : kMouthControls) {
    names.insert(control.name);
    EXPECT_TRUE(control.least == 0 || control.least == -1) << control.name;
    EXPECT_FALSE(control.sided && control.least != 0) << control.name;
  }
  EXPECT_EQ(names.size(), kMouthActs);
  EXPECT_EQ(kMouthControls[std::size_t(MouthAct::close)].name, "mouth.close");
  EXPECT_EQ(kMouthControls[std::size_t(MouthAct::dimple)].name, "mouth.dimple");
  EXPECT_EQ(kMouthControls[std::size_t(MouthAct::tongue_back)].name, "tongue.back");
}

}  // namespace
}  // namespace mien
