#include "tools/mien/data/equal_steps.h"

namespace mien::command {
namespace {

constexpr int kHalvings = 16;  // to less than 10⁻⁴ of the way

/// The place beyond `begin` (both as shares of the way) that differs from it by `step`; 1 if even the end does not.
double next_place(double begin, double step, const Difference& difference) {
  if (difference(begin, 1) < step) return 1;
  double lo = begin, hi = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (lo + hi);
    (difference(begin, middle) < step ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

/// Steps from 0 on, as far as `count` places go.
std::vector<double> walk(int count, double step, const Difference& difference) {
  std::vector<double> places{0};
  while (int(places.size()) < count) places.push_back(next_place(places.back(), step, difference));
  return places;
}

}  // namespace

Expected<std::vector<double>> equal_steps(double from, double to, int count,
                                          const Difference& difference) {
  const auto at = [&](double share) { return from + share * (to - from); };
  const Difference between = [&](double a, double b) { return difference(at(a), at(b)); };
  // Too large a step ends the walk early: its last but one place is the end already.
  double lo = 0, hi = 0;
  for (int i = 0; i < count - 1; ++i)
    hi += between(double(i) / (count - 1), double(i + 1) / (count - 1));
  if (!(hi > 0)) return Error{"", "the ends do not differ"};
  std::vector<double> best = walk(count, hi, between);
  for (int i = 0; i < kHalvings; ++i) {
    const double step = 0.5 * (lo + hi);
    std::vector<double> places = walk(count, step, between);
    const bool short_of_end = places.back() < 1;
    (short_of_end ? lo : hi) = step;
    if (!short_of_end || i == 0) best = std::move(places);
  }
  std::vector<double> steps;
  for (const double place : best) steps.push_back(at(place));
  steps.back() = to;
  return steps;
}

}  // namespace mien::command
