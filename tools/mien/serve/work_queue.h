#pragma once
// Work for a few threads, of which so much may wait and no more.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mien::command {

class WorkQueue {
 public:
  using Work = std::function<void()>;  ///< throws nothing

  WorkQueue(int threads, std::size_t most_waiting);
  /// What waits is forgotten; what is being done is waited for.
  ~WorkQueue();
  WorkQueue(const WorkQueue&) = delete;

  /// False: too much waits already.
  bool take(Work work);

 private:
  void do_all();

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<Work> waiting_;
  bool ends_ = false;
  std::vector<std::thread> threads_;  // the last member: they use the others
};

}  // namespace mien::command
