#include "tools/mien/terminal/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace mien::command {
namespace {

std::atomic<int> came{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may set it");

extern "C" void remember_signal(int signal) {
  came = signal;
}

}  // namespace

void watch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  action.sa_flags = int(SA_RESETHAND) | SA_RESTART;
  for (int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before;
    // Ignored by the caller (nohup, a background job): that stays so.
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
}

bool interrupted() {
  return came != 0;
}

void die_of_interrupt() {
  std::signal(came, SIG_DFL);
  std::raise(came);
  std::_Exit(128 + came);
}

}  // namespace mien::command
