#pragma once
// Muscles in motion: where the law (muscle_law.h) has brought a face at a moment, when pulls change in
// time. A pure function of the face, the pulls as a function of time, and the moment: frames may be
// posed at any rate, in any order, in parallel, again.
//
// Up to time 0 the face is in the equilibrium of the pulls at that moment. From 0 on, time is cut into
// cells of 1/256 s (exact in binary) and into epochs of whole cells. Each cell is integrated to order 5
// with its error kept below 1e-11 of the canvas's longer side, in as many steps as that takes; the
// moment itself lies in a cell, which is integrated as far as it. To know epoch n, the one before it is
// run first, from the equilibrium of the pulls at its begin: whatever happened before that is forgotten
// by then. An epoch is so long that damping takes what is left of it below e^−23 = 1e-10 (1 to 64
// seconds; male: 8), so no moment is dear, however late.
//
// Error: measured against tiny steps of another method, 1e-9 of the canvas's longer side
// (tests/lib/rig/muscle/motion_test.cpp). Damping below 0.4/s is not forgotten within 64 s: such faces
// jump between epochs, by what is left. Any time step between frames is fine: nothing is integrated
// over it.

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

/// The equilibrium of these pulls; `scratch` is kept by who wants no allocations.
void muscle_still(const FaceModel& model, const FaceVector& rest, std::span<const double> pulls,
                  MuscleShape& shape, MusclePointLaw& scratch);

/// How long an epoch is [s].
double muscle_epoch(const MuscleSystem& system);

/// The motion of one face under one course of pulls. Remembers the cells it has been through, which
/// changes the time that answers take and not a bit of them; so for one thread at a time.
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
  long long first_cell_ = 0;   ///< of the epoch that was run first
  std::vector<States> cells_;  ///< states at the cells from first_cell_ on
  struct Remembered {
    double time;
    std::vector<double> pulls;
  };
  std::vector<Remembered> remembered_;
  std::size_t oldest_ = 0;
};

}  // namespace mien
