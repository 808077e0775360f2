#include "render/image/png/run_matcher.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace mien {
namespace {

constexpr int kBucketBits = 12;
constexpr int kMostTried = 16;  // matches: four times as many find nothing more in flat art

std::size_t bucket(std::uint64_t pixel) {
  return std::size_t(pixel * 0x9e3779b97f4a7c15u >> (64 - kBucketBits));
}

/// The logarithm to base 2 in units of a cost, straight between powers of two: off by 0.086 at most. In
/// whole numbers, since libraries' logarithms differ, and so would the file's bytes.
int log_of(std::uint32_t n) {
  const int whole = int(std::bit_width(n)) - 1;
  return TokenCosts::kBit * (whole - 1) + int(std::uint64_t(n) * TokenCosts::kBit >> whole);
}

}  // namespace

TokenCosts::TokenCosts() {
  counts_.lengths.fill(1);
  counts_.distances.fill(1);
  counts_.lengths[285] = 300, counts_.distances[2] = 300;
  learn();
}

void TokenCosts::learn() {
  const auto bits = [](const auto& counts, auto& to) {
    const std::uint32_t all = std::accumulate(counts.begin(), counts.end(), 0u);
    for (std::size_t i = 0; i < counts.size(); ++i) to[i] = log_of(all) - log_of(counts[i]);
  };
  std::array<int, DeflateCounts::kLengths> symbols;
  bits(counts_.lengths, symbols);
  bits(counts_.distances, distances_);
  std::copy_n(symbols.begin(), 256, literals_.begin());
  for (std::size_t n = 3; n <= kDeflateLongest; ++n) {
    const DeflateSymbol s = length_symbol(n);
    lengths_[n] = symbols[s.symbol] + kBit * s.extra;
  }
  for (std::size_t i = 4; i < distances_.size(); ++i) distances_[i] += kBit * int(i / 2 - 1);
}

std::size_t RunMatcher::memory(std::size_t runs) {
  return runs * (2 * sizeof(PixelRun) + sizeof(Step) + sizeof(int));
}

void RunMatcher::begin() {
  runs_.clear();
  last_.assign(std::size_t(1) << kBucketBits, -1);
  row_ = 0, row_before_ = -1, at_ = 0;
  costs_ = TokenCosts();
}

void RunMatcher::add(std::uint64_t pixel, std::size_t bytes) {
  runs_.push_back({pixel, at_, std::uint32_t(bytes), -1});
  at_ += std::uint32_t(bytes);
}

int RunMatcher::run_cost(std::size_t bytes) const {
  if (bytes == 0) return 0;
  const std::size_t whole = bytes / kDeflateLongest, rest = bytes % kDeflateLongest;
  return int(whole) * costs_.length(kDeflateLongest) +
         int(whole + (rest > 0)) * costs_.distance(pixel_) +
         (rest > 0 ? costs_.length(std::max<std::size_t>(rest, 3)) : 0);
}

/// How far the bytes from a run on are those from an earlier one on.
RunMatcher::Found RunMatcher::match(int here, int there) const {
  const PixelRun *a = &runs_[std::size_t(here)], *b = &runs_[std::size_t(there)];
  const int end = int(runs_.size());
  const std::uint32_t skipped = b->bytes > a->bytes ? b->bytes - a->bytes : 0;
  Found found{std::min(a->bytes, b->bytes), a->at - b->at - skipped};
  bool whole = b->bytes >= a->bytes;
  while (whole && found.length < kDeflateLongest && ++here < end) {
    ++a, ++b;
    if (a->pixel != b->pixel || (a->bytes == 1) != (b->bytes == 1)) break;
    found.length += std::min(a->bytes, b->bytes);
    whole = a->bytes == b->bytes;
  }
  found.length = std::min(found.length, kDeflateLongest);
  return found;
}

void RunMatcher::relax(int from, int to, int cost, const Found& found, std::size_t rest) {
  Step& step = steps_[std::size_t(to - row_)];
  if (cost >= step.cost) return;
  step = {cost, from, std::uint32_t(found.length), std::uint32_t(found.distance),
          std::uint32_t(rest)};
}

/// A match may end behind any run it holds, or in the run where it breaks off.
void RunMatcher::try_match(int here, const Found& found) {
  const int cost = steps_[std::size_t(here - row_)].cost + costs_.distance(found.distance);
  const std::uint32_t at = runs_[std::size_t(here)].at;
  for (int i = here; i < int(runs_.size()); ++i) {
    const PixelRun& run = runs_[std::size_t(i)];
    const std::size_t before = run.at - at, behind = before + run.bytes;
    if (behind <= found.length) {
      if (behind >= 3)
        relax(here, i + 1, cost + costs_.length(behind), {behind, found.distance}, 0);
      continue;
    }
    const std::size_t length = std::min(found.length, behind - 3);  // what is left can be a match
    if (length >= 3 && length >= before + pixel_)
      relax(here, i + 1, cost + costs_.length(length) + run_cost(behind - length),
            {length, found.distance}, behind - length);
    return;
  }
}

void RunMatcher::step_from(int here) {
  PixelRun& run = runs_[std::size_t(here)];
  int cost = steps_[std::size_t(here - row_)].cost;
  const std::size_t own = std::min<std::size_t>(run.bytes, pixel_);
  for (std::size_t k = 0; k < own; ++k) cost += costs_.literal(run.pixel >> 8 * k);
  relax(here, here + 1, cost + run_cost(run.bytes - own), {0, 0}, run.bytes - own);
  if (run.bytes == 1) {
    if (row_before_ >= 0 && runs_[std::size_t(row_before_)].pixel == run.pixel) {
      const Found found = match(here, row_before_);
      if (found.distance <= kDeflateWindow) try_match(here, found);
    }
    return;
  }
  int& last = last_[bucket(run.pixel)];
  int left = kMostTried;
  for (int there = last; there >= 0 && left > 0; there = runs_[std::size_t(there)].before, --left) {
    if (runs_[std::size_t(there)].pixel != run.pixel) continue;
    const Found found = match(here, there);
    if (found.distance > kDeflateWindow) break;
    try_match(here, found);
  }
  run.before = last, last = here;
}

void RunMatcher::put(const Step& step, int run, std::vector<DeflateToken>& to) {
  const std::size_t begin = to.size();
  const PixelRun& first = runs_[std::size_t(run)];
  if (step.distance != 0) {
    to.push_back(deflate_match(step.length, step.distance));
  } else {
    for (std::size_t k = 0; k < std::min<std::size_t>(first.bytes, pixel_); ++k)
      to.push_back(DeflateToken(first.pixel >> 8 * k & 255));
  }
  for (std::size_t rest = step.rest; rest > 0;) {
    std::size_t now = std::min(rest, kDeflateLongest);
    if (rest > now && rest - now < 3) now -= 3;
    to.push_back(deflate_match(now, pixel_));
    rest -= now;
  }
  for (std::size_t i = begin; i < to.size(); ++i) costs_.count(to[i]);
}

void RunMatcher::end_row(std::vector<DeflateToken>& to) {
  const int end = int(runs_.size());
  steps_.assign(std::size_t(end - row_) + 1, {std::numeric_limits<int>::max(), 0, 0, 0, 0});
  steps_[0].cost = 0;
  for (int run = row_; run < end; ++run) step_from(run);
  path_.clear();
  for (int to_run = end; to_run > row_; to_run = steps_[std::size_t(to_run - row_)].from)
    path_.push_back(to_run);
  int from = row_;
  for (std::size_t i = path_.size(); i-- > 0; from = path_[i])
    put(steps_[std::size_t(path_[i] - row_)], from, to);
  row_before_ = row_, row_ = end;
  costs_.learn();
}

}  // namespace mien
