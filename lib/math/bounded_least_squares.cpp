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

/// The free variables' best values without bounds, the others fixed.
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

class ActiveSet {
 public:
  explicit ActiveSet(const BoundedLeastSquares& problem)
      : problem_(problem),
        count_(int(problem.lo.size())),
        a_(damped(problem)),
        right_(VectorXd::Zero(a_.rows())),
        x_(count_),
        is_free_(std::size_t(count_), 0) {
    for (std::size_t i = 0; i < problem.right.size(); ++i)
      right_[Eigen::Index(i)] = problem.right[i];
    for (int i = 0; i < count_; ++i) x_[i] = bounded(i, 0.0);
    noise_ = 1e-13 * (1 + right_.norm()) * (1 + a_.norm());
  }

  std::vector<double> solve() {
    int kept_at = -1;  // the variable that was freed and went straight back to its bound
    for (int turn = 0; turn < 20 * count_ + 20; ++turn) {
      const int chosen = most_pulled(kept_at);
      if (chosen < 0) break;
      const double before = x_[chosen];
      is_free_[std::size_t(chosen)] = 1;
      while (!settle()) {
      }
      kept_at = x_[chosen] == before && !is_free_[std::size_t(chosen)] ? chosen : -1;
    }
    return {x_.data(), x_.data() + count_};
  }

 private:
  double bounded(int i, double value) const {
    return std::clamp(value, problem_.lo[std::size_t(i)], problem_.hi[std::size_t(i)]);
  }

  /// The variable at a bound whose gradient pulls it off most strongly, except `but`; −1: none.
  int most_pulled(int but) const {
    const VectorXd pull = a_.transpose() * (right_ - a_ * x_);
    int chosen = -1;
    for (int i = 0; i < count_; ++i) {
      const auto at = std::size_t(i);
      if (is_free_[at] || i == but) continue;
      const bool rises = pull[i] > noise_ && x_[i] < problem_.hi[at];
      const bool falls = pull[i] < -noise_ && x_[i] > problem_.lo[at];
      if ((rises || falls) && (chosen < 0 || std::abs(pull[i]) > std::abs(pull[chosen])))
        chosen = i;
    }
    return chosen;
  }

  /// Moves the free variables towards their best values without bounds until the first of them meets a
  /// bound, where it is then fixed. Returns whether none did.
  bool settle() {
    std::vector<int> free;
    for (int i = 0; i < count_; ++i)
      if (is_free_[std::size_t(i)]) free.push_back(i);
    if (free.empty()) return true;
    const VectorXd to = solved(a_, right_, free, x_);
    double share = 1;
    int stopped = -1;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const double from = x_[free[i]], wanted = to[Eigen::Index(i)];
      const double bound = bounded(free[i], wanted);
      if (bound == wanted) continue;
      const double part = (bound - from) / (wanted - from);
      if (stopped < 0 || part < share) share = part, stopped = free[i];
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
      double& x = x_[free[i]];
      x = bounded(free[i], x + share * (to[Eigen::Index(i)] - x));
    }
    if (stopped >= 0) is_free_[std::size_t(stopped)] = 0;
    return stopped < 0;
  }

  const BoundedLeastSquares& problem_;
  int count_;
  MatrixXd a_;
  VectorXd right_, x_;
  std::vector<char> is_free_;
  double noise_ = 0;
};

}  // namespace

std::vector<double> solve(const BoundedLeastSquares& problem) {
  return ActiveSet(problem).solve();
}

}  // namespace mien
