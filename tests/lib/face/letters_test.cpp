#include <mien/letters.h>

#include <gtest/gtest.h>

#include "tests/support/faces/box_letters.h"

namespace mien {
namespace {

TEST(Letters, GiveAnOutlineOrSayWhyNot) {
  EXPECT_FALSE(Letters());
  const Letters boxes = test::box_letters();
  EXPECT_EQ(boxes("ab")->loops.size(), 2u);
  EXPECT_EQ(boxes("a?").error().what, "the font has no letter for \"?\" (U+003F)");
}

}  // namespace
}  // namespace mien
