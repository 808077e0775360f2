#include <mien/parallel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace mien {
namespace {

TEST(ParallelFor, RunsEveryJobOnceForAnyThreads) {
  for (int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> runs(1000);
    parallel_for(1000, {.count = threads}, [&](int i) { ++runs[std::size_t(i)]; });
    for (const auto& r : runs) ASSERT_EQ(r.load(), 1) << threads << " threads";
  }
}

TEST(ParallelFor, PrintsNothingWhenAskedForMoreThreadsThanThereAre) {
  testing::internal::CaptureStderr();
  for (int threads : {7, 1000}) parallel_for(1000, {.count = threads}, [](int) {});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ParallelFor, UsesTheCallersExecutor) {
  int asked = 0, ran = 0;
  const Executor mine = [&](int count, const std::function<void(int)>& job) {
    asked = count;
    for (int i = count; i-- > 0;) job(i);
  };
  parallel_for(5, {.count = 0, .executor = mine}, [&](int) { ++ran; });
  EXPECT_EQ(asked, 5);
  EXPECT_EQ(ran, 5);
}

}  // namespace
}  // namespace mien
