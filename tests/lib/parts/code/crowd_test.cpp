#include <mien/crowd.h>
#include <mien/recipe.h>
#include "lib/parts/code/appearance.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mien {
namespace {

TEST(Crowd, NoTwoOfAHundredLookAlike) {
  for (const char* word : {"1", "2", "hello"}) {
    const std::vector<FaceCode> people = crowd(word, 100);
    ASSERT_EQ(people.size(), 100u);
    std::vector<Appearance> seen;
    for (const FaceCode& code : people)
      seen.push_back(appearance_of(recipe_from_code(code).value()));
    double least = difference(seen[0], seen[1]);
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) least = std::min(least, difference(seen[i], seen[j]));
    EXPECT_GE(least, 3.5) << word;
    RecordProperty(std::string("least_") + word, std::to_string(least));
  }
}

TEST(Crowd, BeginsAlikeWhateverItsSize) {
  const std::vector<FaceCode> few = crowd("hello", 5), more = crowd("hello", 9);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].seed, more[i].seed);
  EXPECT_NE(crowd("other", 1)[0].seed, few[0].seed);
  EXPECT_TRUE(crowd("hello", 0).empty());
}

}  // namespace
}  // namespace mien
