#include "tools/mien/data/equal_steps.h"

#include <algorithm>
#include <cmath>

namespace mien::command {
namespace {

constexpr int kLeastPieces = 64;
constexpr int kMostRounds = 8;
constexpr double kEvenEnough = 0.01;  // of a step

/// A point of the way, as a share of it, and how long the way is up to there.
struct Mark {
  double share, length;
};

/// The place at which the way has that length.
double share_at(const std::vector<Mark>& way, double length) {
  const auto after = std::lower_bound(way.begin() + 1, way.end() - 1, length,
                                      [](const Mark& m, double l) { return m.length < l; });
  const Mark &a = *(after - 1), &b = *after;
  if (!(b.length > a.length)) return a.share;
  return a.share + (b.share - a.share) * (length - a.length) / (b.length - a.length);
}

double length_at(const std::vector<Mark>& way, double share) {
  const auto after = std::lower_bound(way.begin() + 1, way.end() - 1, share,
                                      [](const Mark& m, double s) { return m.share < s; });
  const Mark &a = *(after - 1), &b = *after;
  return a.length + (b.length - a.length) * (share - a.share) / (b.share - a.share);
}

std::vector<double> divided(const std::vector<Mark>& way, int count) {
  std::vector<double> shares;
  for (int i = 0; i < count; ++i)
    shares.push_back(share_at(way, way.back().length * i / (count - 1)));
  shares.front() = 0, shares.back() = 1;
  return shares;
}

/// The way as it was between two of these places, but as long there as they differ.
std::vector<Mark> rescaled(const std::vector<Mark>& way, const std::vector<double>& shares,
                           const std::vector<double>& steps) {
  std::vector<Mark> made{{0, 0}};
  auto mark = way.begin();
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    if (!(shares[i + 1] > shares[i])) continue;
    const double begin = length_at(way, shares[i]), end = length_at(way, shares[i + 1]);
    const double so_far = made.back().length, scale = end > begin ? steps[i] / (end - begin) : 0;
    for (; mark != way.end() && mark->share < shares[i + 1]; ++mark)
      if (mark->share > shares[i])
        made.push_back({mark->share, so_far + scale * (mark->length - begin)});
    made.push_back({shares[i + 1], so_far + steps[i]});
  }
  return made;
}

/// By what share of the mean step the worst step is off.
double unevenness(const std::vector<double>& steps) {
  double sum = 0, worst = 0;
  for (const double step : steps) sum += step;
  const double mean = sum / double(steps.size());
  for (const double step : steps) worst = std::max(worst, std::abs(step - mean));
  return mean > 0 ? worst / mean : 1;
}

}  // namespace

Expected<std::vector<double>> equal_steps(double from, double to, int count, const Ruler& ruler) {
  const auto values = [&](const std::vector<double>& shares) {
    std::vector<double> at;
    for (const double share : shares) at.push_back(share == 1 ? to : from + share * (to - from));
    return at;
  };
  const int pieces = std::max(kLeastPieces, 2 * (count - 1));
  std::vector<double> shares;
  for (int i = 0; i <= pieces; ++i) shares.push_back(double(i) / pieces);
  std::vector<Mark> way{{0, 0}};
  const std::vector<double> lengths = ruler(values(shares));
  for (int i = 0; i < pieces; ++i)
    way.push_back({shares[std::size_t(i) + 1], way.back().length + lengths[std::size_t(i)]});
  if (!(way.back().length > 0)) return Error{"", "nothing differs between its ends"};
  std::vector<double> best;
  double least = INFINITY;
  for (int round = 0; round < kMostRounds; ++round) {
    shares = divided(way, count);
    const std::vector<double> steps = ruler(values(shares));
    const double now = unevenness(steps);
    if (now < least) best = shares, least = now;
    if (least <= kEvenEnough || count == 2 || now == 1) break;
    way = rescaled(way, shares, steps);
  }
  return values(best.empty() ? shares : best);
}

}  // namespace mien::command
