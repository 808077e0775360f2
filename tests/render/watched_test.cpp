#include "render/watched.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

constexpr std::int64_t kMuch = 4'000'000'000'000;

/// Works in small steps, for as long as it may.
int work_on(std::int64_t steps) {
  for (std::int64_t i = 0; i < steps; i += 1000) worked(1000);
  return 7;
}

TEST(Watched, GivesWhatWasMade) {
  const auto made = watched(
      {}, {}, 0, [] { return work_on(1000); }, [] { return 0.0; });
  ASSERT_TRUE(made);
  EXPECT_EQ(*made, 7);
}

TEST(Watched, TellsTheShareAndEndsWhenTold) {
  int asked = 0;
  double told = 0.0, done = 0.25;
  const auto made = watched(
      [&](double share) {
        told = share, done = 0.5;
        return ++asked < 2;
      },
      kWithoutLimits, 0, [] { return work_on(kMuch); }, [&] { return done; });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what, "cancelled");
  EXPECT_EQ(told, 0.5);
}

TEST(Watched, NamesTheLimitEvenOfTheLastSteps) {
  for (const std::int64_t steps : {std::int64_t(2000), kMuch}) {
    const auto made = watched(
        {}, {.steps = 1000}, 0, [&] { return work_on(steps); }, [] { return 0.0; });
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().what, "drawing takes more than 1000 steps of work (limit `steps`)");
  }
}

TEST(Watched, LetsThroughWhatEndsTheWorkAround) {
  Watch around([] { return false; });
  const Watching here(&around);
  EXPECT_THROW((void)watched(
                   {}, kWithoutLimits, 0, [] { return work_on(kMuch); }, [] { return 0.0; }),
               Stopped);
}

}  // namespace
}  // namespace mien
