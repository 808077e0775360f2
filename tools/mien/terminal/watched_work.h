#pragma once
// The one way in which commands do what may take long: people see how far it is, and Ctrl-C ends it.

#include <mien/parallel.h>
#include "tools/mien/terminal/progress_display.h"

#include <cstddef>
#include <functional>
#include <string>

namespace mien::command {

/// Work of so many steps, one after the other, or told by its share.
class WatchedWork {
 public:
  explicit WatchedWork(const std::string& phase, std::size_t steps = 1);
  /// One more is done. Throws Stopped (lib/base/watch.h).
  void step() { at(double(++done_) / double(steps_)); }
  /// This share is done. Throws Stopped.
  void at(double share);

 private:
  ProgressDisplay display_;
  Progress progress_;
  std::size_t steps_, done_ = 0;
};

/// parallel_for, watched. After an interrupt no job begins; then it throws Stopped.
void watched_for(const std::string& phase, int count, const Threads& threads,
                 const std::function<void(int)>& job);

}  // namespace mien::command
