#pragma once
// Muscles in motion: where the law (law.h) has brought a face at a moment, when pulls change in time. This
// is a pure function of the face, the pulls as a function of time, and the moment: frames may be posed at
// any rate, in any order, in parallel, and again.
//
// Up to time 0 the face is in the equilibrium of the pulls at that moment. From 0 on, time is cut into
// cells of 1/256 s (exact in binary) and into epochs of whole cells. Each cell is integrated to order 5
// with its error kept below 1e-11 of the canvas's longer side, in as many steps as that takes; the cell of
// the moment itself is integrated up to the moment. For epoch n, the epoch before it is integrated first,
// starting in the equilibrium of the pulls at its begin: whatever happened before that is forgotten by
// then. An epoch is so long that damping reduces its traces below e^−23 = 1e-10 (1 to 64 seconds; male: 8).
// So a late moment costs no more than an early one.
//
// Error: 1e-9 of the canvas's longer side, measured against tiny steps of another method
// (tests/lib/rig/muscle/motion_test.cpp). With damping below 0.4/s, the past is not forgotten within 64 s:
// such faces jump between epochs by what is left of it. The time step between frames does not matter:
// nothing is integrated over it.

#include "lib/rig/muscle/law.h"

#include <functional>
#include <span>
#include <vector>

namespace mien {

/// The pulls of all muscles at a time [s].
using PullsAt = std::function<void(double time, std::vector<double>& pulls)>;

/// Where all muscle points and numbers of a face are: each point's place, and how far each number is
/// from rest, in the order of the model's muscle system.
struct MuscleShape {
  std::vector<glm::dvec2> points;
  std::vector<double> numbers;
};

/// The equilibrium of these pulls. A caller that keeps `scratch` saves allocations.
void muscle_still(const FaceModel& model, const FaceVector& rest, std::span<const double> pulls,
                  MuscleShape& shape, MusclePointLaw& scratch);

/// How long an epoch is [s].
double muscle_epoch(const MuscleSystem& system);

/// The motion of one face under one course of pulls. It remembers the cells that it has integrated. That
/// makes answers faster and changes no bit of them, but allows one thread at a time only.
class MuscleMotion {
 public:
  /// `model` and `rest` must outlive it.
  MuscleMotion(const FaceModel& model, const FaceVector& rest, PullsAt pulls);

  void at(double time, MuscleShape& shape);

 private:
  struct State {
    glm::dvec2 p, v;
  };
  using States = std::vector<State>;  ///< points, then numbers (x only)

  States still(double time);
  void advance(States& states, double from, double to);
  const States& at_cell(long long cell);
  void take(const States& states, MuscleShape& shape) const;
  std::span<const double> pulls_at(double time);

  const FaceModel& model_;
  const FaceVector& rest_;
  PullsAt pulls_;
  double size_, epoch_;
  MusclePointLaw law_;
  long long first_cell_ = 0;   ///< of the epoch that was integrated first
  std::vector<States> cells_;  ///< states at the cells from first_cell_ on
  struct Remembered {
    double time;
    std::vector<double> pulls;
  };
  std::vector<Remembered> remembered_;
  std::size_t oldest_ = 0;
};

}  // namespace mien
