#include "tools/mien/terminal/watched_work.h"
#include "lib/base/watch.h"
#include "tools/mien/terminal/interrupt.h"

#include <algorithm>
#include <mutex>

namespace mien::command {

WatchedWork::WatchedWork(const std::string& phase, std::size_t steps)
    : progress_(display_.watch(phase)), steps_(std::max<std::size_t>(steps, 1)) {
  watch_interrupts();
}

void WatchedWork::at(double share) {
  if (!progress_(share)) throw Stopped{Stopped::Why::cancelled};
}

void watched_for(const std::string& phase, int count, const Threads& threads,
                 const std::function<void(int)>& job) {
  if (count < 1) return;
  watch_interrupts();
  ProgressDisplay display;
  const Progress progress = display.watch(phase);
  std::mutex mutex;
  int done = 0;
  parallel_for(count, threads, [&](int i) {
    if (interrupted()) return;
    job(i);
    const std::lock_guard lock(mutex);
    progress(double(++done) / double(count));
  });
  if (interrupted()) throw Stopped{Stopped::Why::cancelled};
}

}  // namespace mien::command
