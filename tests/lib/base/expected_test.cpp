#include <gtest/gtest.h>
#include <mien/expected.h>

#include <memory>
#include <string>

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

TEST(Expected, HasTheNamesOfTheStandardsOwn) {
  const Expected<int> value = 7, error = Error{"a.json", "is empty"};
  EXPECT_TRUE(value.has_value());
  EXPECT_EQ(value.value(), 7);
  EXPECT_EQ(value.value_or(3), 7);
  EXPECT_EQ(error.value_or(3), 3);
  EXPECT_EQ(*Expected<std::unique_ptr<int>>(Error{}).value_or(std::make_unique<int>(5)), 5);
}

TEST(Expected, PassesItsValueOnAndItsErrorThrough) {
  const auto half = [](int v) -> Expected<int> {
    if (v % 2) return Error{"", "odd"};
    return v / 2;
  };
  const Expected<int> six = 6, error = Error{"a.json", "is empty"};
  EXPECT_EQ(*six.and_then(half), 3);
  EXPECT_EQ(six.and_then(half).and_then(half).error().what, "odd");
  EXPECT_EQ(error.and_then(half).error().where, "a.json");
  EXPECT_EQ(*six.transform([](int v) { return std::to_string(v); }), "6");
  EXPECT_EQ(error.transform([](int v) { return v + 1; }).error().what, "is empty");
  EXPECT_EQ(*error.or_else([](const Error&) -> Expected<int> { return 1; }), 1);
  EXPECT_EQ(*six.or_else([](const Error&) -> Expected<int> { return 1; }), 6);
  const auto taken =
      Expected(std::make_unique<int>(7)).transform([](std::unique_ptr<int> p) { return *p + 1; });
  EXPECT_EQ(*taken, 8);
}

#ifndef NDEBUG
TEST(ExpectedDeathTest, AssertsThatItHoldsWhatItIsAskedFor) {
  const Expected<int> error = Error{"a.json", "is empty"};
  EXPECT_DEATH((void)*error, "what it does not hold");
}
#endif

TEST(Expected, ASentenceNamesThePlaceIfThereIsOne) {
  EXPECT_EQ(sentence({"a.json:3:1", "expected a number"}), "a.json:3:1: expected a number");
  EXPECT_EQ(sentence({"", "expected a number"}), "expected a number");
}

}  // namespace
}  // namespace mien
