#include "lib/base/one_line.h"
#include "take_builder_private.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

constexpr double kMostTime = 1e19;  ///< in any unit: nanoseconds since 1970 are fewer

/// How many units of a clock make a second, by the step between rows: nobody films fewer than one frame in five seconds.
double units_in_second(double step) {
  for (const double units : {1e9, 1e6, 1e3})
    if (step >= 5e-3 * units) return units;
  return 1;
}

float single(double number) {
  constexpr double kMost = 1e30;
  return float(std::clamp(number, -kMost, kMost));
}

/// A number's range, by its unit.
std::pair<float, float> unit_range(TakeUnit unit) {
  if (unit == TakeUnit::degrees) return {-180.0f, 180.0f};
  return {0.0f, 1.0f};
}

}  // namespace

TakeBuilder::TakeBuilder(std::string name, const MotionLimits& limits)
    : name_(std::move(name)), limits_(limits), table_(std::make_shared<SampleTable>()) {}

std::size_t TakeBuilder::column(const TakeTarget& target) {
  for (std::size_t i = 0; i < targets_.size(); ++i)
    if (targets_[i].channel == target.channel) return i;
  SampleTable& table = *table_;
  const std::size_t before = table.columns;
  targets_.push_back(target);
  table.columns = before + 1;
  if (!table.times.empty()) {
    std::vector<float> wider(table.times.size() * table.columns, 0.0f);
    for (std::size_t row = 0; row < table.times.size(); ++row)
      std::copy_n(table.values.begin() + std::ptrdiff_t(row * before), before,
                  wider.begin() + std::ptrdiff_t(row * table.columns));
    table.values = std::move(wider);
  }
  return before;
}

Expected<Done> TakeBuilder::begin_row(double time, const Place& where) {
  SampleTable& table = *table_;
  if (clock == TakeClock::milliseconds) time /= 1000;
  if (!(std::abs(time) <= kMostTime)) return Error{where(), fmt::format("{} is no moment", time)};
  const bool same = !table.times.empty() && time == table.times.back();
  if (!table.times.empty() && time < table.times.back())
    return Error{where(), fmt::format("time goes back, from {} to {}", table.times.back(), time)};
  if (table.times.size() >= limits_.rows)
    return Error{where(), fmt::format("more than {} rows (limit: rows)", limits_.rows)};
  if (table.values.size() + table.columns > limits_.numbers)
    return Error{where(), fmt::format("more than {} numbers (limit: numbers)", limits_.numbers)};
  if (same) {
    ++replaced_;
    std::fill(table.values.end() - std::ptrdiff_t(table.columns), table.values.end(), 0.0f);
    return Done{};
  }
  table.times.push_back(time);
  table.values.resize(table.values.size() + table.columns, 0.0f);
  return Done{};
}

void TakeBuilder::set(std::size_t column, double written, const TakeTarget& target) {
  const double value = target.factor * written;
  table_->values[table_->values.size() - table_->columns + column] =
      single(target.one_sided ? std::max(value, 0.0) : value);
}

/// Sets times to begin at 0 where they are a clock's.
void TakeBuilder::tell_time_units(std::vector<Error>& told) {
  std::vector<double>& times = table_->times;
  const double first = times.front();
  if (clock == TakeClock::seconds && std::abs(first) < 1e6) return;
  std::vector<double> steps;
  for (std::size_t row = 1; row < std::min<std::size_t>(times.size(), 1000); ++row)
    steps.push_back(times[row] - times[row - 1]);
  std::sort(steps.begin(), steps.end());
  const bool guess = clock != TakeClock::milliseconds && !steps.empty();
  const double units = guess ? units_in_second(steps[steps.size() / 2]) : 1;
  for (double& time : times) time = (time - first) / units;
  if (units > 1)
    told.push_back({name_, fmt::format("times are read as {}seconds: rows are {:.4g} of them apart",
                                       units == 1e3   ? "milli"
                                       : units == 1e6 ? "micro"
                                                      : "nano",
                                       steps[steps.size() / 2])});
}

/// Programs that write shares from 0 to 100 do so in all columns. Of shares from 0 to 1 few are above 1, if any.
void TakeBuilder::scale_percent(std::vector<Error>& told) {
  SampleTable& table = *table_;
  const auto is_share = [&](std::size_t c) {
    return targets_[c].unit == TakeUnit::share && !targets_[c].scaled;
  };
  std::size_t moved = 0, above = 0;
  float largest = 0;
  for (std::size_t i = 0; i < table.values.size(); ++i)
    if (is_share(i % table.columns) && table.values[i] > 0) {
      ++moved, above += table.values[i] > 1;
      largest = std::max(largest, table.values[i]);
    }
  if (!(largest > 5 && largest < 101 && 2 * above > moved)) return;
  for (std::size_t i = 0; i < table.values.size(); ++i)
    if (is_share(i % table.columns)) table.values[i] /= 100;
  told.push_back({name_, fmt::format("shares are read as 0 to 100: the largest is {}", largest)});
}

void TakeBuilder::clamp(std::vector<Error>& told) {
  SampleTable& table = *table_;
  std::size_t count = 0, worst = 0;
  float farthest = 0;
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const auto [lo, hi] = unit_range(targets_[i % table.columns].unit);
    const float value = table.values[i], held = std::clamp(value, lo, hi);
    if (held == value) continue;
    ++count;
    if (const float off = std::abs(value - held) / (hi - lo); off > farthest)
      farthest = off, worst = i;
  }
  if (count == 0) return;
  const TakeTarget& target = targets_[worst % table.columns];
  const auto [lo, hi] = unit_range(target.unit);
  told.push_back(
      {name_, fmt::format("{} of {} values lay out of range and were clamped, the farthest {} = {} "
                          "at {:.3f} s, which goes from {} to {}",
                          count, table.values.size(), one_line(target.channel, 60),
                          table.values[worst], table.times[worst / table.columns], lo, hi)});
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const auto [least, most] = unit_range(targets_[i % table.columns].unit);
    table.values[i] = std::clamp(table.values[i], least, most);
  }
}

Expected<Motion> TakeBuilder::finish(std::vector<Error>& told) {
  if (table_->times.empty())
    return Error{name_,
                 bridged_ > 0 ? "no face is seen in it: all rows are without one" : "has no rows"};
  if (targets_.empty())
    return Error{name_, "holds nothing that moves a face: expected names like \"jawOpen\""};
  tell_time_units(told);
  scale_percent(told);
  clamp(told);
  if (bridged_ > 0)
    told.push_back({name_, fmt::format("{} rows in which no face was seen are bridged", bridged_)});
  if (replaced_ > 0)
    told.push_back(
        {name_, fmt::format("{} rows have the time of the row before and replace it", replaced_)});
  table_->values.shrink_to_fit();
  Motion motion{.name = name_, .channels = {}, .settled = true};
  const std::shared_ptr<const SampleTable> table = std::move(table_);
  for (std::size_t c = 0; c < targets_.size(); ++c)
    motion.channels.push_back({targets_[c].channel, {SampledCurve{table, c}}});
  return motion;
}

}  // namespace mien
