#include "lib/face/standard_names.h"

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

TEST(StandardNames, AreFiveSetsWithoutDoubles) {
  const std::pair<std::string_view, std::size_t> sets[] = {
      {"arkit", 52}, {"facs", 46}, {"vrm", 18}, {"viseme", 15}, {"azure", 22}};
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

TEST(StandardNames, AreFreeOfCaseAndOfSpellingsOfSides) {
  for (const char* name : {"eyeBlinkLeft", "EyeBlinkLeft", "eyeBlink_L", "eyeBlink.L",
                           "EYE_BLINK_LEFT", "eye blink left", "eyeblink-l"})
    EXPECT_EQ(standard_spelling("arkit", name), "eyeBlinkLeft") << name;
  EXPECT_EQ(standard_spelling("arkit", "JawOpen"), "jawOpen");
  EXPECT_EQ(standard_spelling("arkit", "mouth_r"), "mouthRight");
  for (const char* name : {"_neutral", "jawOpenLeft", "", "_l", "l"})
    EXPECT_EQ(standard_spelling("arkit", name), name);
  EXPECT_EQ(standard_spelling("emotion", "Joy"), "Joy");
}

TEST(StandardNames, OfVrmAndVisemesHaveOthers) {
  const std::pair<const char*, const char*> vrm[] = {
      {"joy", "happy"}, {"sorrow", "sad"},        {"Fun", "relaxed"},        {"a", "aa"},
      {"O", "oh"},      {"blink_l", "blinkLeft"}, {"Blink_R", "blinkRight"}, {"lookup", "lookUp"}};
  for (const auto& [other, name] : vrm) EXPECT_EQ(standard_spelling("vrm", other), name) << other;
  const std::pair<const char*, const char*> visemes[] = {
      {"ih", "I"},
      {"oh", "O"},
      {"OU", "U"},
      {"KK", "kk"},
      {"viseme_PP", "PP"},
      {"XR_FACE_TRACKING_VISEME_SIL_META", "sil"},
      {"XR_FACE_TRACKING_VISEME_E_META", "E"}};
  for (const auto& [other, name] : visemes)
    EXPECT_EQ(standard_spelling("viseme", other), name) << other;
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
