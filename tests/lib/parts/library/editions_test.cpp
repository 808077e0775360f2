#include <mien/editions.h>

#include <mien/recipe.h>
#include "lib/parts/library/part_library.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mien {
namespace {

TEST(Editions, AllAreThere) {
  ASSERT_FALSE(editions().empty());
  EXPECT_EQ(editions().back(), kTrialEdition);
  EXPECT_TRUE(std::ranges::is_sorted(editions()));
  for (const char sign : editions()) {
    ASSERT_TRUE(PartLibrary::shipped(sign)) << sign;
    EXPECT_EQ(PartLibrary::shipped(sign), PartLibrary::shipped(sign));
    EXPECT_EQ(read_edition({&sign, 1}).value(), sign);
    // A code of it is read as itself, and makes a recipe of it.
    const FaceCode code{.edition = sign, .seed = 5};
    EXPECT_EQ(recipe_from_code(read_face_code(face_code_text(code)).value())->edition, sign);
  }
  EXPECT_EQ(PartLibrary::shipped(newest_edition()), &PartLibrary::shipped());
  EXPECT_EQ(FaceCode{}.edition, newest_edition());
}

TEST(Editions, UnknownOnesAreRefusedInASentenceThatNamesTheKnown) {
  EXPECT_FALSE(PartLibrary::shipped('?'));
  EXPECT_FALSE(PartLibrary::shipped('z'));
  for (const char* text : {"", "?", "z", "ZZ", "\n"}) {
    const auto read = read_edition(text);
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().what.find("is not known to this version, which has"), std::string::npos);
    EXPECT_TRUE(read.error().what.ends_with("A")) << read.error().what;
    EXPECT_EQ(read.error().what.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace mien
