#include "lib/base/watch.h"
#include "lib/base/monotonic_seconds.h"

#include <utility>

namespace mien {

Watch::Watch(std::function<bool()> go_on, const RenderLimits& limits, std::int64_t pixels)
    : go_on_(std::move(go_on)),
      limits_{limits.steps ? limits.steps : default_steps(pixels), limits.memory},
      outer_(Watching::current()),
      asked_(monotonic_seconds()) {}

void Watch::stop(Stopped::Why why) {
  if (!stopped_.exchange(true)) why_ = why;
}

void Watch::ask() {
  if (!go_on_ || monotonic_seconds() - asked_ < kPause || !asking_.try_lock()) return;
  const std::lock_guard lock(asking_, std::adopt_lock);
  if (!stopped() && !go_on_()) stop(Stopped::Why::cancelled);
  asked_ = monotonic_seconds();
}

void Watch::count(std::int64_t steps) {
  if (steps_.fetch_add(steps) + steps > limits_.steps) stop(Stopped::Why::steps);
  if (outer_) outer_->count(steps);
}

void Watch::go_on_or_end() {
  ask();
  if (outer_) outer_->go_on_or_end();
  if (stopped()) throw Stopped{why()};
}

void Watch::look(std::int64_t steps) {
  count(steps);
  go_on_or_end();
}

void Watch::hold(std::uint64_t bytes) {
  std::uint64_t most = memory_.load(std::memory_order_relaxed);
  while (most < bytes && !memory_.compare_exchange_weak(most, bytes)) {
  }
  if (!may_hold(bytes)) stop(Stopped::Why::memory);
  if (stopped()) throw Stopped{why()};
}

void Watch::foresee(std::uint64_t bytes) {
  if (may_hold(bytes)) return;
  foreseen_ = bytes;
  stop(Stopped::Why::foreseen);
  throw Stopped{why()};
}

namespace {

/// Tells this thread's watch what was done since it was looked at: nothing may be thrown where a watch ends.
void tell_rest() {
  detail::Pace& pace = detail::pace;
  const std::int64_t steps = detail::kStepsBetweenLooks - pace.left;
  pace.left = detail::kStepsBetweenLooks;
  if (pace.watch) pace.watch->count(steps);
}

}  // namespace

Watching::Watching(Watch* watch) : before_(detail::pace.watch) {
  tell_rest();
  detail::pace.watch = watch;
}

Watching::~Watching() {
  tell_rest();
  detail::pace.watch = before_;
}

Watch* Watching::current() {
  return detail::pace.watch;
}

void detail::look_up() {
  const std::int64_t steps = kStepsBetweenLooks - pace.left;
  pace.left = kStepsBetweenLooks;
  if (pace.watch) pace.watch->look(steps);
}

void end_if_stopped() {
  if (Watch* const watch = Watching::current()) watch->look(0);
}

}  // namespace mien
