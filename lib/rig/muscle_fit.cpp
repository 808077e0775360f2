#include <mien/lib/rig/muscle_fit.h>

#include <mien/lib/math/bounded_least_squares.h>
#include <mien/lib/rig/muscle_motion.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace mien {
namespace {

/// What is left between a face's points and its targets.
class Residual {
 public:
  Residual(const Face& face, std::span<const PointTarget> targets)
      : face_(face), targets_(targets) {
    const auto& points = face.model->muscles.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      point_of_[points[i].slice] = i;
      if (points[i].twin >= 0) point_of_[points[i].twin] = i;
    }
  }

  std::vector<double> at(std::span<const double> pulls) {
    muscle_still(*face_.model, face_.vector, pulls, shape_, law_);
    std::vector<double> left;
    for (const PointTarget& target : targets_) {
      const auto found = point_of_.find(target.slice);
      const auto begin = std::size_t(face_.model->layout[target.slice].begin);
      const glm::dvec2 p = found != point_of_.end()
                               ? shape_.points[found->second]
                               : glm::dvec2{face_.vector[begin], face_.vector[begin + 1]};
      left.push_back(p.x - target.wanted.x), left.push_back(p.y - target.wanted.y);
    }
    return left;
  }

 private:
  const Face& face_;
  std::span<const PointTarget> targets_;
  std::map<int, std::size_t> point_of_;
  MuscleShape shape_;
  MusclePointLaw law_;
};

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// One-sided differences inward, 1e-6 wide: equilibria are good to 1e-12.
std::vector<double> slopes(Residual& residual, std::vector<double> pulls,
                           const std::vector<double>& here) {
  constexpr double kWide = 1e-6;
  std::vector<double> columns;
  for (double& pull : pulls) {
    const double was = pull, step = was > 0.5 ? -kWide : kWide;
    pull = was + step;
    const std::vector<double> there = residual.at(pulls);
    pull = was;
    for (std::size_t i = 0; i < here.size(); ++i) columns.push_back((there[i] - here[i]) / step);
  }
  return columns;
}

std::vector<double> fitted_from(Residual& residual, std::vector<double> pulls) {
  std::vector<double> here = residual.at(pulls);
  double least = sum_of_squares(here), damping = 1e-3;
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps && damping < 1e12; ++step) {
    BoundedLeastSquares problem{.columns = slopes(residual, pulls, here), .rows = here.size()};
    for (const double value : here) problem.right.push_back(-value);
    const double scale = std::max(sum_of_squares(problem.columns) / double(pulls.size()), 1e-300);
    for (const double pull : pulls) problem.lo.push_back(-pull), problem.hi.push_back(1 - pull);
    bool nearer = false;
    double gained = 0;
    for (; !nearer && damping < 1e12; damping *= nearer ? 1 : 10) {
      problem.damping = damping * scale;
      const std::vector<double> by = solve(problem);
      std::vector<double> next = pulls;
      for (std::size_t i = 0; i < next.size(); ++i) next[i] = std::clamp(next[i] + by[i], 0., 1.);
      const std::vector<double> there = residual.at(next);
      const double sum = sum_of_squares(there);
      nearer = sum < least;
      if (!nearer) continue;
      gained = least - sum;
      pulls = next, here = there, least = sum;
    }
    if (!nearer || gained <= 1e-14 * least) break;
    damping = std::max(0.1 * damping, 1e-12);
  }
  return pulls;
}

}  // namespace

MuscleFit fit_muscles(const Face& face, std::span<const PointTarget> targets) {
  const std::size_t muscles = face.model->muscles.muscles.size();
  Residual residual(face, targets);
  MuscleFit best;
  double least = 0;
  for (const double start : {0.0, 0.5}) {
    std::vector<double> pulls = fitted_from(residual, std::vector<double>(muscles, start));
    const double sum = sum_of_squares(residual.at(pulls));
    if (best.pulls.empty() || sum < least) best.pulls = std::move(pulls), least = sum;
  }
  const std::vector<double> left = residual.at(best.pulls);
  if (!targets.empty()) best.rms = std::sqrt(least / double(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (const double off = std::hypot(left[2 * i], left[2 * i + 1]);
        best.farthest < 0 || off > best.largest)
      best.largest = off, best.farthest = targets[i].slice;
  return best;
}

}  // namespace mien
