#pragma once
// Long work that is counted, and can be ended from outside, wherever it is.
//
//   Watch watch(go_on, limits);           // where work begins
//   const Watching here(&watch);          // on this thread; parallel_for passes it on to its own
//   …                                     // anywhere inside: worked(1) for every step
//
// Loops that may be long tell their steps. Every few thousand the watch is looked at: it asks the caller whether to go
// on and compares what was done with the limits. If the work must end, `Stopped` is thrown, and the verb that set
// the watch turns it into an error. A thread that nobody watches only counts.

#include <mien/limits.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>

namespace mien {

/// Thrown through the work that a watch ends.
struct Stopped {
  enum class Why {
    cancelled,
    steps,
    memory,
    foreseen,  ///< more memory than it may hold, before it held any
  } why;
};

class Watch {
 public:
  /// `go_on`: asked every kPause or so, by one thread at a time; none: always. Work inside of other watched work
  /// ends with that.
  /// Drawing so many `pixels`, if it does.
  explicit Watch(std::function<bool()> go_on = {}, const RenderLimits& limits = {},
                 std::int64_t pixels = 0);
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  static constexpr double kPause = 0.01;  // [s] between two questions

  /// So many more steps were done. Throws Stopped, or what the caller throws when asked.
  void look(std::int64_t steps);
  /// Likewise where nothing may be thrown: nobody is asked. If the work must end, the next look finds it.
  void count(std::int64_t steps);
  /// So much is held now, by one drawing. Throws Stopped.
  void hold(std::uint64_t bytes);
  /// Whether one drawing may hold so much.
  bool may_hold(std::uint64_t bytes) const { return bytes <= limits_.memory; }
  /// One drawing is certain to hold so much, or more, if it goes on. Throws Stopped.
  void foresee(std::uint64_t bytes);
  /// Ends the work as soon as its threads look here again.
  void stop(Stopped::Why why);

  bool stopped() const { return stopped_.load(std::memory_order_relaxed); }
  Stopped::Why why() const { return why_.load(std::memory_order_relaxed); }
  std::int64_t steps() const { return steps_.load(std::memory_order_relaxed); }
  std::uint64_t memory() const { return memory_.load(std::memory_order_relaxed); }
  const RenderLimits& limits() const { return limits_; }
  /// What ended the work if that is Why::foreseen [bytes].
  std::uint64_t foreseen() const { return foreseen_.load(std::memory_order_relaxed); }

 private:
  void ask();
  /// Of this watch and those around it.
  void go_on_or_end();

  const std::function<bool()> go_on_;
  const RenderLimits limits_;
  Watch* const outer_;
  std::atomic<std::int64_t> steps_{0};
  std::atomic<std::uint64_t> memory_{0}, foreseen_{0};
  std::atomic<double> asked_;
  std::atomic<bool> stopped_{false};
  std::atomic<Stopped::Why> why_{Stopped::Why::cancelled};
  std::mutex asking_;
};

/// The watch of this thread, as long as this lives.
class Watching {
 public:
  explicit Watching(Watch* watch);
  ~Watching();
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;

  /// The one at work on this thread; null: none.
  static Watch* current();

 private:
  Watch* const before_;
};

namespace detail {
inline constexpr std::int64_t kStepsBetweenLooks = 1 << 18;
struct Pace {
  std::int64_t left = kStepsBetweenLooks;
  Watch* watch = nullptr;
};
#if defined(__GNUC__) && !defined(__EMSCRIPTEN__)
__attribute__((tls_model("initial-exec")))  // no call to find it
#endif
inline thread_local constinit Pace pace;
void look_up();
}  // namespace detail

/// Steps of work, each about a nanosecond's. Throws Stopped.
inline void worked(std::int64_t steps) {
  if ((detail::pace.left -= steps) < 0) detail::look_up();
}

/// What one drawing holds by now [bytes]. Throws Stopped.
inline void holds(std::uint64_t bytes) {
  if (detail::pace.watch) detail::pace.watch->hold(bytes);
}

/// Whether one drawing may hold so much [bytes].
inline bool may_hold(std::uint64_t bytes) {
  return !detail::pace.watch || detail::pace.watch->may_hold(bytes);
}

/// What one drawing is certain to hold if it goes on [bytes]. Throws Stopped.
inline void foresees(std::uint64_t bytes) {
  if (detail::pace.watch) detail::pace.watch->foresee(bytes);
}

}  // namespace mien
