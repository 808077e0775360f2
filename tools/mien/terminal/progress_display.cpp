#include "tools/mien/terminal/progress_display.h"
#include "lib/file/json/json_text.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/outer_work.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace mien::command {
namespace {

constexpr double kSilence = 1.0;   // [s] work shorter than this shows no bar
constexpr double kInterval = 0.1;  // [s] between two looks
constexpr int kBarWidth = 30;      // at most

ProgressStyle style_of_all = ProgressStyle::automatic;

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

int terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void put(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

std::string duration_text(double length) {
  const long whole = std::lround(std::clamp(length, 0.0, 1e8));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

void use_progress(ProgressStyle style) {
  style_of_all = style;
}

ProgressDisplay::ProgressDisplay() : style_(style_of_all) {
  if (style_ == ProgressStyle::automatic && !::isatty(STDERR_FILENO)) style_ = ProgressStyle::none;
}

ProgressDisplay::~ProgressDisplay() {
  if (bar_shown_) put("\r\x1b[K");
}

Progress ProgressDisplay::watch(std::string phase) {
  if (const OuterWork* const outer = OuterWork::present())
    return [outer](double done) { return outer->tell(done); };
  return [this, phase = std::move(phase), phase_began = Clock::now()](double done) {
    if (style_ != ProgressStyle::none) show(phase, done, phase_began);
    return !interrupted();
  };
}

void ProgressDisplay::show(const std::string& phase, double done, Clock::time_point phase_began) {
  const Clock::time_point now = Clock::now();
  const bool last = done >= 1;
  if (!last && seconds(now - shown_) < kInterval) return;
  const double elapsed = seconds(now - phase_began);
  const double left = done > 0 ? elapsed * (1 - done) / done : NAN;
  if (style_ == ProgressStyle::json) {
    put(fmt::format("{{\"phase\": {}, \"done\": {:.4f}, \"elapsed\": {:.3f}, \"left\": {}}}\n",
                    json_string(phase), done, elapsed,
                    std::isfinite(left) ? fmt::format("{:.3f}", left) : "null"));
  } else {
    if (seconds(now - began_) < kSilence) return;
    show_bar(phase, done, left);
  }
  shown_ = now;
}

void ProgressDisplay::show_bar(const std::string& phase, double done, double left) {
  const int width = std::clamp(terminal_width() - 34, 5, kBarWidth);
  const int full = int(std::clamp(done, 0.0, 1.0) * width);
  const std::string time = std::isfinite(left) ? duration_text(left) + " left" : "";
  put(fmt::format("\r{:5} [{}{}] {:3.0f} % {}\x1b[K", phase, std::string(std::size_t(full), '#'),
                  std::string(std::size_t(width - full), '.'), 100 * done, time));
  bar_shown_ = true;
}

}  // namespace mien::command
