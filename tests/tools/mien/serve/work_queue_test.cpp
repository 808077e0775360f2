#include "tools/mien/serve/work_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>

namespace mien::command {
namespace {

TEST(WorkQueue, DoesAllThatItTakes) {
  std::atomic<int> done = 0;
  std::latch all(200);
  WorkQueue queue(3, 200);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(queue.take([&] { ++done, all.count_down(); }));
  all.wait();
  EXPECT_EQ(done, 200);
}

TEST(WorkQueue, RefusesWhatIsTooMuch) {
  std::latch begun(1), go(1);
  std::atomic<int> done = 0;
  {
    WorkQueue queue(1, 2);
    EXPECT_TRUE(queue.take([&] { begun.count_down(), go.wait(), ++done; }));
    begun.wait();  // it waits no more
    EXPECT_TRUE(queue.take([&] { ++done; }));
    EXPECT_TRUE(queue.take([&] { ++done; }));
    EXPECT_FALSE(queue.take([&] { ++done; }));
    go.count_down();
  }
  EXPECT_GE(done, 1) << "what was begun is waited for";
}

TEST(WorkQueue, ForgetsWhatWaitsAtItsEnd) {
  std::latch begun(1), go(1);
  std::atomic<int> done = 0;
  std::thread end;
  {
    auto queue = std::make_unique<WorkQueue>(1, 10);
    EXPECT_TRUE(queue->take([&] { begun.count_down(), go.wait(), ++done; }));
    begun.wait();
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(queue->take([&] { done += 100; }));
    end = std::thread([gone = std::move(queue)]() mutable { gone.reset(); });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  go.count_down();
  end.join();
  EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace mien::command
