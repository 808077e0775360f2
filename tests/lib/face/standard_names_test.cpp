#include "lib/face/standard_names.h"

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

TEST(StandardNames, AreFourSetsWithoutDoubles) {
  const std::pair<std::string_view, std::size_t> sets[] = {
      {"arkit", 52}, {"facs", 42}, {"vrm", 18}, {"viseme", 15}};
  for (const auto& [set, count] : sets) {
    const auto names = standard_names(set);
    EXPECT_EQ(names.size(), count) << set;
    EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), count) << set;
  }
  EXPECT_TRUE(standard_names("emotion").empty());
}

TEST(StandardNames, OfActionUnitsAreSpeltInManyWays) {
  for (const char* name : {"AU1", "AU01", "au1", "Au01_r", "AU01_c", "AU001"})
    EXPECT_EQ(standard_spelling("facs", name), "AU1") << name;
  EXPECT_EQ(standard_spelling("facs", "left.au12_r"), "left.AU12");
  for (const char* name : {"AU3", "AU0", "AU", "AUx", "AU1_x", "", "1", "jawOpen"})
    EXPECT_EQ(standard_spelling("facs", name), name);
  EXPECT_EQ(standard_spelling("arkit", "AU01"), "AU01");
}

TEST(StandardNames, HaveManySpellingsOfCaseAndSide) {
  const auto spelt = [](const char* set, const char* name) { return standard_spelling(set, name); };
  for (const char* name : {"eyeBlinkLeft", "EyeBlinkLeft", "eyeBlink_L", "eyeBlink.l",
                           "EYEBLINK_LEFT", "eye_blink_left"})
    EXPECT_EQ(spelt("arkit", name), "eyeBlinkLeft") << name;
  EXPECT_EQ(spelt("arkit", "MouthSmile_R"), "mouthSmileRight");
  EXPECT_EQ(spelt("arkit", "jaw_L"), "jawLeft");
  EXPECT_EQ(spelt("arkit", "JawOpen"), "jawOpen");
  EXPECT_EQ(spelt("arkit", "eyeBlink"), "eyeBlink") << "of no side";
  EXPECT_EQ(spelt("viseme", "ih"), "I");
  EXPECT_EQ(spelt("viseme", "oh"), "O");
  EXPECT_EQ(spelt("viseme", "ou"), "U");
  EXPECT_EQ(spelt("viseme", "viseme_PP"), "PP");
  EXPECT_EQ(spelt("viseme", "sil"), "sil");
  EXPECT_EQ(spelt("vrm", "Joy"), "happy");
  EXPECT_EQ(spelt("vrm", "blink_l"), "blinkLeft");
  EXPECT_EQ(spelt("vrm", "lookup"), "lookUp");
  EXPECT_EQ(spelt("emotion", "JOY"), "JOY") << "a face's own names stay";
  // No two names of a set are one.
  for (const char* set : {"arkit", "facs", "vrm", "viseme"})
    for (const std::string_view name : standard_names(set))
      EXPECT_EQ(standard_spelling(set, name), name);
}

TEST(StandardNames, SayTheirSideOrHaveHalves) {
  EXPECT_TRUE(names_have_sides("arkit"));
  EXPECT_FALSE(names_have_sides("facs"));
  EXPECT_FALSE(names_have_sides("emotion"));
  // For every Left there is a Right.
  for (const char* set : {"arkit", "vrm"})
    for (const std::string_view name : standard_names(set))
      if (name.ends_with("Left")) {
        const std::string right = std::string{name.substr(0, name.size() - 4)} + "Right";
        const auto names = standard_names(set);
        EXPECT_NE(std::find(names.begin(), names.end(), right), names.end()) << name;
      }
}

}  // namespace
}  // namespace mien
