#pragma once
// Signals to processes that a test started.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

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

/// Waits until the process has a handler of its own for the signal: a loaded machine or a sanitizer
/// may take its time to start a program, and before that the signal ends it without a word.
inline void wait_until_handled(pid_t process, int signal) {
  for (int i = 0; i < 6000; ++i) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:") &&
          std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1)
        return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "after a minute signal " << signal << " is not handled";
}

}  // namespace mien::test
