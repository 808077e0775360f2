#pragma once
// Signals to processes that a test started.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/types.h>

namespace mien::test {

/// kill(2) for a process that was started: where starting failed its id is −1, which kill(2) takes
/// for every process there is.
inline void end_process(pid_t process, int signal) {
  if (process > 0) {
    ::kill(process, signal);
  } else {
    ADD_FAILURE() << "there is no process to end: it was not started";
  }
}

}  // namespace mien::test
