#include "lib/base/watch.h"

#include <mien/parallel.h>

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

namespace mien::test {
namespace {

/// Works until it is stopped, or for ten seconds; says why it was.
std::optional<Stopped::Why> work_under(Watch& watch) {
  const Watching here(&watch);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  try {
    while (std::chrono::steady_clock::now() < end) worked(100);
  } catch (const Stopped& stopped) {
    return stopped.why;
  }
  return {};
}

TEST(Watch, EndsWorkWhenTheCallerAsks) {
  int asked = 0;
  Watch watch([&] { return ++asked < 5; });
  EXPECT_EQ(work_under(watch), Stopped::Why::cancelled);
  EXPECT_EQ(asked, 5);
  EXPECT_TRUE(watch.stopped());
}

TEST(Watch, EndsWorkThatTakesTooManySteps) {
  Watch watch({}, {.steps = 1'000'000});
  EXPECT_EQ(work_under(watch), Stopped::Why::steps);
  EXPECT_GT(watch.steps(), 1'000'000);
  EXPECT_LT(watch.steps(), 1'300'000);
}

TEST(Watch, AllowsMoreStepsForMorePixels) {
  EXPECT_EQ(Watch().limits().steps, default_steps(0));
  EXPECT_EQ(Watch({}, {}, 1'000'000).limits().steps, default_steps(1'000'000));
  EXPECT_EQ(Watch({}, {.steps = 7}, 1'000'000).limits().steps, 7);
  EXPECT_EQ(default_steps(1'000'000), default_steps(0) + 1'000'000'000);
}

TEST(Watch, CountsFewStepsBeforeAndAfterWorkOfItsOwnInside) {
  Watch watch;
  {
    const Watching here(&watch);
    worked(3);
    parallel_for(4, {.count = 1}, [](int) { worked(10); });
    worked(5);
  }
  EXPECT_EQ(watch.steps(), 48);
}

TEST(Watch, EndsWorkThatHoldsTooMuch) {
  Watch watch({}, {.memory = 1000});
  const Watching here(&watch);
  holds(1000);
  EXPECT_THROW(holds(1001), Stopped);
  EXPECT_EQ(watch.why(), Stopped::Why::memory);
  EXPECT_EQ(watch.memory(), 1001u);
}

TEST(Watch, OfOuterWorkEndsTheInnerToo) {
  int asked = 0;
  Watch outer([&] { return ++asked < 3; });
  const Watching here(&outer);
  Watch inner([] { return true; });
  EXPECT_EQ(work_under(inner), Stopped::Why::cancelled);
}

/// What the caller throws when asked would end the process where a watch ends: there nobody is asked.
TEST(Watch, AsksNobodyWhereItEnds) {
  int asked = 0;
  Watch outer([&]() -> bool { throw ++asked; });
  {
    const Watching here(&outer);
    Watch inner([&]() -> bool { throw ++asked; });
    const Watching inside(&inner);
    std::this_thread::sleep_for(std::chrono::duration<double>(2 * Watch::kPause));
    worked(100);
  }
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(outer.steps(), 100);
  EXPECT_FALSE(outer.stopped());
}

TEST(Watch, AsksAfterShortJobs) {
  int asked = 0;
  Watch watch([&] { return ++asked < 3; });
  const Watching here(&watch);
  const auto pause = std::chrono::duration<double>(1.5 * Watch::kPause);
  int done = 0;
  const auto job = [&](int) { std::this_thread::sleep_for(pause), ++done; };
  EXPECT_THROW(parallel_for(64, {.count = 1}, job), Stopped);
  EXPECT_EQ(done, 3);
}

TEST(Watch, GoesWithJobsToTheirThreads) {
  for (const int threads : {1, 2, 4}) {
    Watch watch({}, {.steps = 1'000'000});
    const Watching here(&watch);
    EXPECT_THROW(parallel_for(64, {.count = threads},
                              [&](int) {
                                EXPECT_EQ(Watching::current(), &watch);
                                for (int k = 0; k < 1'000'000; ++k) worked(100);
                              }),
                 Stopped);
    EXPECT_LT(watch.steps(), 3'000'000);
  }
}

TEST(Watch, CountsAllOfItsThreads) {
  Watch watch;
  {
    const Watching here(&watch);
    parallel_for(8, {.count = 4}, [&](int) { worked(1000); });
  }
  EXPECT_EQ(watch.steps(), 8000);
}

TEST(Watch, IsNeededByNobody) {
  EXPECT_EQ(Watching::current(), nullptr);
  for (int k = 0; k < 1000; ++k) worked(1'000'000), holds(1u << 30);
}

}  // namespace
}  // namespace mien::test
