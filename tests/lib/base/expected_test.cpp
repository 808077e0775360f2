#include <gtest/gtest.h>
#include <mien/expected.h>

#include <memory>

namespace mien {
namespace {

TEST(Expected, HoldsAValueOrAnError) {
  const Expected<int> value = 7;
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 7);

  const Expected<int> error = Error{"a.json", "is empty"};
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().what, "is empty");
}

TEST(Expected, GivesAwayWhatItHolds) {
  Expected<std::unique_ptr<int>> held = std::make_unique<int>(7);
  ASSERT_TRUE(held);
  const std::unique_ptr<int> taken = *std::move(held);
  EXPECT_EQ(*taken, 7);
  EXPECT_EQ(*held, nullptr);
}

TEST(Expected, ASentenceNamesThePlaceIfThereIsOne) {
  EXPECT_EQ(sentence({"a.json:3:1", "expected a number"}), "a.json:3:1: expected a number");
  EXPECT_EQ(sentence({"", "expected a number"}), "expected a number");
}

}  // namespace
}  // namespace mien
