#include <mien/parallel.h>
#include "lib/base/watch.h"

#ifndef MIEN_WITHOUT_THREADS
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include <algorithm>

// oneTBB is not compiled with the thread sanitizer, which therefore reports its hand-overs as races. A rule
// that suppresses those would suppress mien's own races too, since every job runs below oneTBB. So under
// that sanitizer the jobs run on plain threads, and all of mien's own code is checked.
#if defined(__SANITIZE_THREAD__)
#define MIEN_PLAIN_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define MIEN_PLAIN_THREADS 1
#endif
#endif

#ifdef MIEN_PLAIN_THREADS
#include <atomic>
#include <thread>
#include <vector>
#endif

namespace mien {
namespace {

#ifdef MIEN_WITHOUT_THREADS
void run_jobs(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (threads.executor) return threads.executor(count, job);
  for (int i = 0; i < count; ++i) job(i);
}
#elif defined(MIEN_PLAIN_THREADS)
void run_jobs(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (threads.executor) return threads.executor(count, job);
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) job(i);
  };
  std::vector<std::jthread> others;
  const int most = threads.count > 0 ? threads.count : 4;
  for (int i = 1; i < std::min({most, count, 16}); ++i) others.emplace_back(work);
  work();
}
#else
void run_jobs(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (threads.executor) return threads.executor(count, job);
  if (threads.count == 1 || count == 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  const auto all = [&] {
    oneapi::tbb::parallel_for(0, count, job, oneapi::tbb::simple_partitioner{});
  };
  if (threads.count <= 0) return all();
  // Asking for more threads than the process may have makes oneTBB print a warning.
  using oneapi::tbb::global_control;
  const auto most = global_control::active_value(global_control::max_allowed_parallelism);
  oneapi::tbb::task_arena arena(std::min(threads.count, int(most)));
  arena.execute(all);
}
#endif

}  // namespace

/// Jobs are watched as their caller is. Its end is theirs: those not begun are left out.
void parallel_for(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (count <= 0) return;
  Watch* const watch = Watching::current();
  if (!watch) return run_jobs(count, threads, job);
  const auto watched = [&](int i) {
    if (watch->stopped()) return;
    const Watching here(watch);
    try {
      job(i);
      // Short jobs would never ask.
      watch->look(0);
    } catch (const Stopped& stopped) {  // it must not pass through an executor
      watch->stop(stopped.why);
    }
  };
  run_jobs(count, threads, std::ref(watched));
  if (watch->stopped()) throw Stopped{watch->why()};
}

}  // namespace mien
