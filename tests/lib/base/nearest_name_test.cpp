#include "lib/base/nearest_name.h"

#include <gtest/gtest.h>

#include <string>

namespace mien {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("brow", "brow", 8), 0);
  EXPECT_EQ(edit_distance("brow", "brows", 8), 1);
  EXPECT_EQ(edit_distance("brow", "bow", 8), 1);
  EXPECT_EQ(edit_distance("brow", "brew", 8), 1);
  EXPECT_EQ(edit_distance("brow", "borw", 8), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting", 8), 3);
  EXPECT_EQ(edit_distance("", "abc", 8), 3);
}

TEST(EditDistance, StopsAboveTheMostAsked) {
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 2), 3);
  EXPECT_EQ(edit_distance("a", "abcdefgh", 3), 4);
}

TEST(NearestName, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("gaze.z", {"blink", "gaze.x", "gaze.y"}),
            "gaze.x");  // the first of equals
  EXPECT_EQ(nearest_name("blnk", {"gaze.x", "blink"}), "blink");
  EXPECT_EQ(nearest_name("elephant", {"gaze.x", "blink"}), "");
  EXPECT_EQ(nearest_name("", {"gaze.x"}), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'x'), {"gaze.x"}), "");
}

TEST(UnknownName, IsASentence) {
  EXPECT_EQ(unknown_name("control", "blnk", {"blink"}),
            "no control named \"blnk\"; did you mean \"blink\"?");
  EXPECT_EQ(unknown_name("control", "what", {"blink"}), "no control named \"what\"");
}

}  // namespace
}  // namespace mien
