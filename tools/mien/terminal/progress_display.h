#pragma once
// How far the work is, on standard error.

#include <mien/progress.h>

#include <chrono>
#include <string>

namespace mien::command {

enum class ProgressStyle {
  automatic,  ///< a bar with the time left, on a terminal, from the first second on; else nothing
  json,  ///< {"phase": "render", "done": 0.25, "elapsed": 1.5, "left": 4.5}, a line each, always
  none
};

/// How all displays of this process look that are made from now on; automatic before.
void use_progress(ProgressStyle style);

class ProgressDisplay {
 public:
  ProgressDisplay();
  ~ProgressDisplay();  ///< wipes the bar

  /// Watches one phase ("render"); stops it when the command was interrupted. The display
  /// outlives it.
  Progress watch(std::string phase);

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& phase, double done, Clock::time_point phase_began);
  void show_bar(const std::string& phase, double done, double left);

  ProgressStyle style_;
  bool bar_shown_ = false;
  Clock::time_point began_ = Clock::now(), shown_{};
};

/// "12 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace mien::command
