#include <mien/lib/base/parallel.h>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace mien {

void parallel_for(int count, const Threads& threads, const std::function<void(int)>& job) {
  if (count <= 0) return;
  if (threads.executor) return threads.executor(count, job);
  if (threads.count == 1 || count == 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  const auto all = [&] {
    oneapi::tbb::parallel_for(0, count, job, oneapi::tbb::simple_partitioner{});
  };
  if (threads.count <= 0) return all();
  oneapi::tbb::task_arena arena(threads.count);
  arena.execute(all);
}

}  // namespace mien
