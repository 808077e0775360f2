#include <mien/lib/base/parallel.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace mien {

void parallel_for(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (count <= 0) return;
  if (threads.executor) return threads.executor(count, job);
  if (threads.count == 1 || count == 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  // What the caller wrote is seen by every job, and what the jobs wrote by the caller: oneTBB takes
  // care of that in code a thread sanitizer does not see, so it is said here once more.
  std::atomic<int> done;
  done.store(0, std::memory_order_release);
  const auto seen = [&](int i) {
    done.load(std::memory_order_acquire);
    job(i);
    done.fetch_add(1, std::memory_order_release);
  };
  const auto all = [&] {
    oneapi::tbb::parallel_for(0, count, seen, oneapi::tbb::simple_partitioner{});
    done.load(std::memory_order_acquire);
  };
  if (threads.count <= 0) return all();
  // Asking for more threads than the process may have makes oneTBB print a warning.
  using oneapi::tbb::global_control;
  const auto most = global_control::active_value(global_control::max_allowed_parallelism);
  oneapi::tbb::task_arena arena(std::min(threads.count, int(most)));
  arena.execute(all);
}

}  // namespace mien
