#include "render/image/ordered_pipeline.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace mien {
namespace {

class Pipeline {
 public:
  using Work = std::function<bool(int, int)>;

  Pipeline(int count, int slots, const Work& make, const Work& take)
      : count_(count), slots_(slots), make_(make), take_(take), ready_(std::size_t(slots)) {}

  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      // Waits only for work that another thread is at already: never for one yet to come.
      moved_.wait(lock, [&] { return over() || next_ < taken_ + slots_; });
      if (over()) return;
      const int i = next_++;
      lock.unlock();
      const bool made = tried(make_, i);
      lock.lock();
      ready_[std::size_t(i % slots_)] = made;
      if (!made) stop();
      take_ready(lock);
    }
  }

  /// Whether all was taken; throws what the work threw.
  bool done() const {
    if (thrown_) std::rethrow_exception(thrown_);
    return !stopped_ && taken_ == count_;
  }

 private:
  bool over() const { return stopped_ || next_ == count_; }

  /// An exception must not leave others waiting: it is kept, and everything stops.
  bool tried(const Work& work, int i) {
    try {
      return work(i, i % slots_);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      return false;
    }
  }

  void stop() {
    stopped_ = true;
    moved_.notify_all();
  }

  void take_ready(std::unique_lock<std::mutex>& lock) {
    while (!taking_ && !stopped_ && taken_ < count_ && ready_[std::size_t(taken_ % slots_)]) {
      const int i = taken_, slot = i % slots_;
      taking_ = true;
      lock.unlock();
      const bool took = tried(take_, i);
      lock.lock();
      taking_ = false;
      ready_[std::size_t(slot)] = false;
      ++taken_;
      if (!took) return stop();
      moved_.notify_all();
    }
  }

  const int count_, slots_;
  const Work &make_, &take_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::vector<char> ready_;  // by slot
  int next_ = 0, taken_ = 0;
  bool taking_ = false, stopped_ = false;
  std::exception_ptr thrown_;
};

}  // namespace

int thread_count(const Threads& threads) {
  const int all = int(std::max(1u, std::thread::hardware_concurrency()));
  return threads.executor || threads.count <= 0 ? all : std::min(threads.count, all);
}

bool ordered_pipeline(int count, int slots, const Threads& threads,
                      const std::function<bool(int, int)>& make,
                      const std::function<bool(int, int)>& take) {
  Pipeline pipeline(count, slots, make, take);
  parallel_for(std::min(thread_count(threads), std::max(count, 1)), threads,
               [&](int) { pipeline.work(); });
  return pipeline.done();
}

}  // namespace mien
