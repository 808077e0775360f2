#include "bench/whole/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace mien::bench {
namespace {

constexpr int kFewestRounds = 3;

int rounds_by_size(std::size_t pixels) {
  return pixels < 500'000 ? 201 : pixels < 5'000'000 ? 41 : pixels < 70'000'000 ? 15 : 7;
}

}  // namespace

double now_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double ms_of(const std::function<void()>& work) {
  const double began = now_ms();
  work();
  return now_ms() - began;
}

double median(std::vector<double> times) {
  if (times.empty()) return 0;
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

std::string ratio_text(double a, double b) {
  return a > 0 && b > 0 ? fmt::format("{:.3f}", a / b) : "-";
}

std::string json_number(double value) {
  return value > 0 ? fmt::format("{:.5f}", value) : "null";
}

Pixels::Pixels(std::size_t bytes)
    : data_(static_cast<std::uint32_t*>(std::aligned_alloc(64, (bytes + 63) / 64 * 64))) {
  std::memset(data_.get(), 1, bytes);
}

Rounds::Rounds(int asked, double seconds, std::size_t pixels)
    : most_(asked ? asked : rounds_by_size(pixels)),
      asked_(asked != 0),
      end_ms_(now_ms() + 1000 * seconds) {}

bool Rounds::go_on(int index) const {
  return index < most_ && (asked_ || index < kFewestRounds || now_ms() < end_ms_);
}

}  // namespace mien::bench
