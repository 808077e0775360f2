#include "lib/rig/speech/viseme.h"

#include "lib/face/standard_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace mien {
namespace {

TEST(Viseme, NamesAreThoseOfTheStandardSet) {
  const auto names = standard_names("viseme");
  EXPECT_TRUE(
      std::equal(names.begin(), names.end(), std::begin(kVisemeNames), std::end(kVisemeNames)));
}

TEST(Viseme, TellsVowelsAndContacts) {
  EXPECT_TRUE(is_vowel(Viseme::aa) && is_vowel(Viseme::U) && !is_vowel(Viseme::RR));
  EXPECT_TRUE(is_contact(Viseme::PP) && is_contact(Viseme::FF) && !is_contact(Viseme::sil));
}

}  // namespace
}  // namespace mien
