#include "lib/rig/muscle/fit.h"

#include "lib/base/watch.h"
#include "lib/math/bounded_least_squares.h"
#include "lib/rig/muscle/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>

namespace mien {
namespace {

/// The differences between a face's points and their targets.
class Residual {
 public:
  Residual(const Face& face, std::span<const PointTarget> targets,
           const std::function<void(double)>& told)
      : face_(face), targets_(targets), told_(told) {
    const auto& points = face.model->muscles.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      point_of_[points[i].slice] = i;
      if (points[i].twin >= 0) point_of_[points[i].twin] = i;
    }
  }

  std::vector<double> at(std::span<const double> pulls) {
    worked(kStepsAMuscle * std::int64_t(pulls.size()));
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

  /// What is told from now on lies between these shares of the work.
  void begin_part(double from, double to) { from_ = from, to_ = to; }
  void tell(double share) const {
    if (told_) told_(from_ + share * (to_ - from_));
  }

 private:
  static constexpr std::int64_t kStepsAMuscle = 1000;

  const Face& face_;
  std::span<const PointTarget> targets_;
  const std::function<void(double)>& told_;
  double from_ = 0, to_ = 1;
  std::map<int, std::size_t> point_of_;
  MuscleShape shape_;
  MusclePointLaw law_;
};

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// Slopes from three points, to the second order, towards the inside of the bounds. Equilibria are exact to
/// 1e-12, so slopes are to about 1e-8.
std::vector<double> slopes(Residual& residual, std::vector<double> pulls,
                           const std::vector<double>& here) {
  constexpr double kWide = 1e-5;
  std::vector<double> columns;
  for (double& pull : pulls) {
    const double was = pull, step = was > 0.5 ? -kWide : kWide;
    pull = was + step;
    const std::vector<double> near = residual.at(pulls);
    pull = was + 2 * step;
    const std::vector<double> far = residual.at(pulls);
    pull = was;
    for (std::size_t i = 0; i < here.size(); ++i)
      columns.push_back((4 * (near[i] - here[i]) - (far[i] - here[i])) / (2 * step));
  }
  return columns;
}

/// The fit from these pulls; muscles that are `idle` stay as they are.
std::vector<double> fitted_from(Residual& residual, std::vector<double> pulls,
                                const std::vector<char>& idle) {
  std::vector<double> here = residual.at(pulls);
  double least = sum_of_squares(here), damping = 1e-3;
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps && damping < 1e12; ++step) {
    residual.tell(double(step) / kMostSteps);
    BoundedLeastSquares problem{.columns = slopes(residual, pulls, here), .rows = here.size()};
    for (const double value : here) problem.right.push_back(-value);
    const double scale = std::max(sum_of_squares(problem.columns) / double(pulls.size()), 1e-300);
    for (std::size_t m = 0; m < pulls.size(); ++m) {
      problem.lo.push_back(idle[m] ? 0 : -pulls[m]);
      problem.hi.push_back(idle[m] ? 0 : 1 - pulls[m]);
    }
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

/// The share of the work that is over when only muscles that need not pull are left.
constexpr double kTwoFits = 0.4;

/// The same fit, but for the last digits, with as few muscles as possible: antagonists can cancel each
/// other at any strength, and a muscle that need not pull should not.
std::vector<double> by_few(Residual& residual, std::vector<double> pulls, double most) {
  std::vector<std::size_t> order(pulls.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return pulls[a] < pulls[b]; });
  std::vector<char> idle(pulls.size(), 0);
  double done = 0;
  for (const std::size_t m : order) {
    const double share = kTwoFits + (1 - kTwoFits) * done++ / double(order.size());
    if (pulls[m] == 0) continue;
    residual.begin_part(share, share + (1 - kTwoFits) / double(order.size()));
    std::vector<double> fewer = pulls;
    fewer[m] = 0, idle[m] = 1;
    fewer = fitted_from(residual, std::move(fewer), idle);
    if (sum_of_squares(residual.at(fewer)) <= most)
      pulls = std::move(fewer);
    else
      idle[m] = 0;
  }
  return pulls;
}

/// Half a pull for every muscle that moves a target, none for the others.
std::vector<double> half_pulled(Residual& residual, std::size_t muscles) {
  std::vector<double> pulls(muscles, 0.5);
  const std::vector<double> here = residual.at(pulls), columns = slopes(residual, pulls, here);
  for (std::size_t m = 0; m < muscles; ++m)
    if (std::all_of(columns.begin() + std::ptrdiff_t(m * here.size()),
                    columns.begin() + std::ptrdiff_t((m + 1) * here.size()),
                    [](double slope) { return slope == 0; }))
      pulls[m] = 0;
  return pulls;
}

}  // namespace

MuscleFit fit_muscles(const Face& face, std::span<const PointTarget> targets,
                      const std::function<void(double)>& told) {
  const std::size_t muscles = face.model->muscles.muscles.size();
  Residual residual(face, targets, told);
  residual.begin_part(0, kTwoFits / 2);
  const std::vector<char> none_idle(muscles, 0);
  MuscleFit best;
  best.pulls = fitted_from(residual, std::vector<double>(muscles, 0.0), none_idle);
  double least = sum_of_squares(residual.at(best.pulls));
  const double digit = 1e-9 * face.model->canvas.box.size().x,
               good = digit * digit * double(targets.size());
  if (least > good) {
    residual.begin_part(kTwoFits / 2, kTwoFits);
    std::vector<double> pulls = fitted_from(residual, half_pulled(residual, muscles), none_idle);
    const double sum = sum_of_squares(residual.at(pulls));
    if (sum < (1 - 1e-9) * least) best.pulls = std::move(pulls), least = sum;
  }
  best.pulls = by_few(residual, std::move(best.pulls), std::max(good, (1 + 1e-9) * least));
  least = sum_of_squares(residual.at(best.pulls));
  const std::vector<double> left = residual.at(best.pulls);
  if (!targets.empty()) best.rms = std::sqrt(least / double(targets.size()));
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (const double off = std::hypot(left[2 * i], left[2 * i + 1]);
        best.farthest < 0 || off > best.largest)
      best.largest = off, best.farthest = targets[i].slice;
  if (told) told(1);
  return best;
}

}  // namespace mien
