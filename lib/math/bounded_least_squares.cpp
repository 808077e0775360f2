#include "lib/math/bounded_least_squares.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace mien {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A with the damping's rows below it.
MatrixXd damped(const BoundedLeastSquares& problem) {
  const auto rows = Eigen::Index(problem.rows), count = Eigen::Index(problem.lo.size());
  const bool more = problem.damping > 0;
  MatrixXd a = MatrixXd::Zero(rows + (more ? count : 0), count);
  a.topRows(rows) = Eigen::Map<const MatrixXd>(problem.columns.data(), rows, count);
  if (more) a.bottomRows(count).diagonal().setConstant(std::sqrt(problem.damping));
  return a;
}

/// Where the free variables would be by themselves, the others staying.
VectorXd solved(const MatrixXd& a, const VectorXd& right, const std::vector<int>& free,
                const VectorXd& x) {
  VectorXd rest = right - a * x;
  MatrixXd part(a.rows(), Eigen::Index(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    part.col(Eigen::Index(i)) = a.col(free[i]);
    rest += a.col(free[i]) * x[free[i]];
  }
  return part.colPivHouseholderQr().solve(rest);
}

}  // namespace

std::vector<double> solve(const BoundedLeastSquares& problem) {
  const int count = int(problem.lo.size());
  const MatrixXd a = damped(problem);
  VectorXd right = VectorXd::Zero(a.rows());
  for (std::size_t i = 0; i < problem.right.size(); ++i) right[Eigen::Index(i)] = problem.right[i];
  VectorXd x(count);
  for (int i = 0; i < count; ++i)
    x[i] = std::clamp(0.0, problem.lo[std::size_t(i)], problem.hi[std::size_t(i)]);
  std::vector<char> is_free(std::size_t(count), 0);
  const double noise = 1e-13 * (1 + right.norm()) * (1 + a.norm());
  int kept_at = -1;  // was set free and went straight back
  for (int turn = 0; turn < 20 * count + 20; ++turn) {
    const VectorXd pull = a.transpose() * (right - a * x);
    int chosen = -1;
    for (int i = 0; i < count; ++i) {
      const auto at = std::size_t(i);
      if (is_free[at] || i == kept_at) continue;
      const bool may_rise = x[i]<problem.hi[at], may_fall = x[i]> problem.lo[at];
      if (((pull[i] > noise && may_rise) || (pull[i] < -noise && may_fall)) &&
          (chosen < 0 || std::abs(pull[i]) > std::abs(pull[chosen])))
        chosen = i;
    }
    if (chosen < 0) break;
    is_free[std::size_t(chosen)] = 1;
    const double before = x[chosen];
    for (bool inside = false; !inside;) {
      std::vector<int> free;
      for (int i = 0; i < count; ++i)
        if (is_free[std::size_t(i)]) free.push_back(i);
      if (free.empty()) break;
      const VectorXd to = solved(a, right, free, x);
      double share = 1;
      int stopped = -1;
      for (std::size_t i = 0; i < free.size(); ++i) {
        const auto at = std::size_t(free[i]);
        const double from = x[free[i]], wanted = to[Eigen::Index(i)];
        const double bound = std::clamp(wanted, problem.lo[at], problem.hi[at]);
        if (bound == wanted) continue;
        const double part = (bound - from) / (wanted - from);
        if (stopped < 0 || part < share) share = part, stopped = free[i];
      }
      for (std::size_t i = 0; i < free.size(); ++i) {
        const auto at = std::size_t(free[i]);
        x[free[i]] = std::clamp(x[free[i]] + share * (to[Eigen::Index(i)] - x[free[i]]),
                                problem.lo[at], problem.hi[at]);
      }
      inside = stopped < 0;
      if (!inside) is_free[std::size_t(stopped)] = 0;
    }
    kept_at = x[chosen] == before && !is_free[std::size_t(chosen)] ? chosen : -1;
  }
  return {x.data(), x.data() + count};
}

}  // namespace mien
