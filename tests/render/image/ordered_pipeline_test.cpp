#include "render/image/ordered_pipeline.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mien {
namespace {

Threads of(int count) {
  Threads threads;
  threads.count = count;
  return threads;
}

/// Real threads, one for each piece of work, as a caller might bring them.
Threads many_threads() {
  Threads threads;
  threads.executor = [](int count, const std::function<void(int)>& job) {
    std::vector<std::thread> all;
    for (int i = 0; i < count; ++i) all.emplace_back(job, i);
    for (std::thread& thread : all) thread.join();
  };
  return threads;
}

TEST(OrderedPipeline, TakesAllInOrderAndHoldsNoMoreThanTheSlots) {
  for (const Threads& threads : {of(1), of(2), of(7), many_threads()}) {
    for (int slots : {1, 2, 5}) {
      std::vector<int> taken;
      std::vector<std::atomic<int>> held(std::size_t(slots) + 0);
      std::atomic<bool> shared = false;
      const bool all = ordered_pipeline(
          100, slots, threads,
          [&](int i, int slot) {
            if (held[std::size_t(slot)].exchange(i + 1) != 0) shared = true;
            std::this_thread::sleep_for(std::chrono::microseconds(i * 37 % 200));
            return true;
          },
          [&](int i, int slot) {
            if (held[std::size_t(slot)].exchange(0) != i + 1) shared = true;
            taken.push_back(i);
            return true;
          });
      std::vector<int> wanted(100);
      std::iota(wanted.begin(), wanted.end(), 0);
      EXPECT_TRUE(all);
      EXPECT_EQ(taken, wanted);
      EXPECT_FALSE(shared);
    }
  }
}

TEST(OrderedPipeline, IsRightOneAfterTheOther) {
  Threads threads;
  threads.executor = [](int count, const std::function<void(int)>& job) {
    for (int i = count - 1; i >= 0; --i) job(i);
  };
  int taken = 0;
  EXPECT_TRUE(ordered_pipeline(
      9, 2, threads, [](int, int) { return true; }, [&](int i, int) { return i == taken++; }));
  EXPECT_EQ(taken, 9);
}

TEST(OrderedPipeline, StopsWhereEitherSaysSo) {
  for (const Threads& threads : {of(1), many_threads()}) {
    int taken = 0;
    EXPECT_FALSE(ordered_pipeline(
        1000, 3, threads, [](int i, int) { return i < 10; },
        [&](int, int) { return ++taken > 0; }));
    EXPECT_LE(taken, 10);
    std::atomic<int> made = 0;
    EXPECT_FALSE(ordered_pipeline(
        1000, 3, threads, [&](int, int) { return ++made > 0; }, [](int i, int) { return i < 5; }));
    EXPECT_LE(made, 5 + 3 + 1);
  }
}

TEST(OrderedPipeline, AnExceptionEndsItAndComesOut) {
  EXPECT_THROW(
      ordered_pipeline(
          100, 2, many_threads(),
          [](int i, int) -> bool { return i == 20 ? throw std::runtime_error("x") : true; },
          [](int, int) { return true; }),
      std::runtime_error);
}

TEST(OrderedPipeline, NothingIsDone) {
  EXPECT_TRUE(ordered_pipeline(
      0, 1, of(0), [](int, int) { return false; }, [](int, int) { return false; }));
}

TEST(ThreadCount, IsNoMoreThanTheMachines) {
  EXPECT_EQ(thread_count(of(1)), 1);
  EXPECT_EQ(thread_count(of(0)), int(std::thread::hardware_concurrency()));
  EXPECT_LE(thread_count(of(1000)), int(std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace mien
