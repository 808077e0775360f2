#include "lib/rig/muscle/motion.h"

#include "lib/rig/muscle/equilibrium.h"
#include "settle_private.h"
#include "step_private.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr double kCellsPerSecond = 256;
constexpr double kCell = 1 / kCellsPerSecond;
constexpr double kTolerance = 1e-11;                      ///< of the canvas's longer side, per step
constexpr double kForgotten = 23;                         ///< e^-23 = 1e-10
constexpr double kShortestEpoch = 1, kLongestEpoch = 64;  ///< [s] epochs
constexpr double kLatest = 1e9;                           ///< [s] later than this a face is at rest
constexpr std::size_t kRemembered = 16;
constexpr double kStepRounding = 1e-13;  ///< of the coordinates: no step needs to be more accurate

/// The error that one step may make at a point.
double tolerance_of(const MusclePointLaw& law, double size) {
  double far = std::max(std::abs(law.rest.x), std::abs(law.rest.y));
  for (const MuscleSpring& spring : law.springs)
    far = std::max({far, std::abs(spring.origin.x), std::abs(spring.origin.y)});
  return kTolerance * size + kStepRounding * far;
}

double tolerance_of(const MuscleNumber& number) {
  double stroke = 0;
  for (const MuscleHold& hold : number.holds) stroke = std::max(stroke, std::abs(hold.stroke));
  return kTolerance * stroke;
}

}  // namespace

void muscle_still(const FaceModel& model, const FaceVector& rest, std::span<const double> pulls,
                  MuscleShape& shape, MusclePointLaw& scratch) {
  const MuscleSystem& system = model.muscles;
  shape.points.resize(system.points.size());
  shape.numbers.resize(system.numbers.size());
  for (std::size_t i = 0; i < system.points.size(); ++i) {
    muscle_law(model, rest, system.points[i], pulls, scratch);
    shape.points[i] = muscle_equilibrium(scratch).p;
  }
  for (std::size_t i = 0; i < system.numbers.size(); ++i)
    shape.numbers[i] = muscle_equilibrium(muscle_law(model, system.numbers[i], pulls));
}

/// The slowest decay of a spring of the face's own stiffness is e^(−λt), with λ the smaller root of λ² − d
/// λ + k = 0, or d/2 where the roots are complex.
double muscle_epoch(const MuscleSystem& system) {
  const double d = system.damping, root = d * d - 4 * system.stiffness;
  const double slowest = root < 0 ? 0.5 * d : 2 * system.stiffness / (d + std::sqrt(root));
  const double wanted = kForgotten / slowest;
  double epoch = kShortestEpoch;
  while (epoch < wanted && epoch < kLongestEpoch) epoch *= 2;
  return epoch;
}

MuscleMotion::MuscleMotion(const FaceModel& model, const FaceVector& rest, PullsAt pulls)
    : model_(model), rest_(rest), pulls_(std::move(pulls)), epoch_(muscle_epoch(model.muscles)) {
  const glm::dvec2 extent = model.canvas.box.size();
  size_ = std::max(extent.x, extent.y);
}

/// Keeps the last times asked for, because the stages of all points ask for the same few in a row.
std::span<const double> MuscleMotion::pulls_at(double time) {
  for (const Remembered& r : remembered_)
    if (r.time == time) return r.pulls;
  if (remembered_.size() < kRemembered) remembered_.push_back({});
  Remembered& r = remembered_[oldest_ % remembered_.size()];
  oldest_ = (oldest_ + 1) % kRemembered;
  r.time = time;
  pulls_(time, r.pulls);
  return r.pulls;
}

MuscleMotion::States MuscleMotion::still(double time) {
  MuscleShape shape;
  muscle_still(model_, rest_, pulls_at(time), shape, law_);
  States states;
  for (const glm::dvec2 p : shape.points) states.push_back({p, {0, 0}});
  for (const double number : shape.numbers) states.push_back({{number, 0}, {0, 0}});
  return states;
}

void MuscleMotion::advance(States& states, double from, double to) {
  const MuscleSystem& system = model_.muscles;
  for (std::size_t i = 0; i < system.points.size(); ++i) {
    const auto law_at = [&](double t) -> const MusclePointLaw& {
      muscle_law(model_, rest_, system.points[i], pulls_at(t), law_);
      return law_;
    };
    const auto acceleration = [&](double t, glm::dvec2 p, glm::dvec2 v) {
      return muscle_force(law_at(t), p) - system.damping * v;
    };
    const double reach = kSettleReach * size_;
    const auto settle = [&](double t, MuscleState& s) { settle_on_tip(law_at(t), reach, s); };
    MuscleState s{states[i].p, states[i].v};
    muscle_steps(acceleration, settle, from, to, tolerance_of(law_at(from), size_), s);
    states[i] = {s.p, s.v};
  }
  for (std::size_t i = 0; i < system.numbers.size(); ++i) {
    State& state = states[system.points.size() + i];
    const auto acceleration = [&](double t, glm::dvec2 n, glm::dvec2 v) {
      const MuscleNumberLaw law = muscle_law(model_, system.numbers[i], pulls_at(t));
      return glm::dvec2{law.pull - law.stiffness * n.x - law.damping * v.x, 0};
    };
    MuscleState s{state.p, state.v};
    muscle_steps(
        acceleration, [](double, MuscleState&) {}, from, to, tolerance_of(system.numbers[i]), s);
    state = {s.p, s.v};
  }
}

/// The states at the begin of a cell, integrated from the begin of the epoch before its own.
const MuscleMotion::States& MuscleMotion::at_cell(long long cell) {
  const auto epoch_cells = (long long)(epoch_ * kCellsPerSecond);
  const long long first = std::max(0LL, cell / epoch_cells - 1) * epoch_cells;
  if (cells_.empty() || first_cell_ != first) {
    first_cell_ = first;
    cells_.assign(1, still(double(first) * kCell));
  }
  while (first_cell_ + (long long)cells_.size() <= cell) {
    const double from = double(first_cell_ + (long long)cells_.size() - 1) * kCell;
    States next = cells_.back();
    advance(next, from, from + kCell);
    cells_.push_back(std::move(next));
  }
  return cells_[std::size_t(cell - first_cell_)];
}

void MuscleMotion::at(double time, MuscleShape& shape) {
  if (!(time > 0 && time < kLatest)) return take(still(time), shape);
  const auto cell = (long long)(time * kCellsPerSecond);
  const double begin = double(cell) * kCell;
  if (time == begin) return take(at_cell(cell), shape);
  States states = at_cell(cell);
  advance(states, begin, time);
  take(states, shape);
}

void MuscleMotion::take(const States& states, MuscleShape& shape) const {
  const std::size_t points = model_.muscles.points.size();
  shape.points.clear(), shape.numbers.clear();
  for (std::size_t i = 0; i < states.size(); ++i)
    if (i < points)
      shape.points.push_back(states[i].p);
    else
      shape.numbers.push_back(states[i].p.x);
}

}  // namespace mien
