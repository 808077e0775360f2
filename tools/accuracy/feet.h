#pragma once
// Solvers of feet (sdf/distance/feet/nearest_feet.h), judged: is it the right branch, the right runner-up, and how
// right are distance and normal?

#include <mien/feet.h>

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "tools/accuracy/families.h"
#include "tools/accuracy/quad.h"

namespace mien::accuracy {

/// What feet are sought on.
using FeetFigure =
    std::variant<std::vector<QuadBezier>, std::vector<Line>, std::vector<TaperedStroke>, Ellipse>;

struct FeetCase {
  FeetFigure figure;
  glm::dvec2 p;
};

struct FeetFamily {
  std::string name;
  std::function<FeetCase(Random&)> draw;
};

/// Families of distances.h where a branch is in question, of quadratic curves, strokes and ellipses, and more: joints,
/// closed chains, coincident branches, strokes whose width outruns the spine.
const std::vector<FeetFamily>& feet_families();

std::vector<FeetCase> feet_cases_of(const FeetFamily& family, size_t count, uint64_t seed);

/// A true minimum of the distance along the figure.
struct TrueFoot {
  Foot foot;            ///< rounded
  Quad key;             ///< |q| − w; of an ellipse |q|
  Quad barrier;         ///< how far the distance rises before another minimum is reached
  Quad x, y;            ///< the way from the place to it
  double reach, speed;  ///< |q|, √(B'² − w'²)
  double from_end;      ///< how far an end or a joint is: there the bend jumps
  glm::dvec2 mirrored;  ///< the normal on the curve's other side
};

/// In binary128, the lowest first.
std::vector<TrueFoot> true_feet(const FeetCase& k);

/// Whether the distance's slope at this parameter is so small that moving the place by `by` makes it a minimum.
bool is_nearly_foot(const FeetCase& k, int piece, double t, double by);

/// How far the figure is at this parameter from a true foot.
double apart_from(const FeetCase& k, int piece, double t, const TrueFoot& foot);

/// 2⁻⁵² S of FeetContract.
double feet_unit(const FeetCase& k);

struct FeetSolver {
  std::string name, instruction_set;
  std::function<Feet(const FeetCase&)> solve;
  bool only_one_curve = false;  ///< of others: a single quadratic curve
  std::function<void()> prepare = [] {};
};

/// mien's scalar form, and the batch on every instruction set.
std::vector<FeetSolver> own_feet_solvers();

/// A foreign one, from a shared library with the function
///
///   /* From (x[i], y[i]) to the quadratic Bézier curve {x0, y0, x1, y1, x2, y2}: feet[10 i …] = t, distance, normal x,
///      normal y and bend of the nearest foot, then of the next one, whose distance is infinite if there is none. */
///   extern "C" void mien_accuracy_feet(const double* curve, const double* x, const double* y, double* feet,
///                                      size_t count);
///
/// Throws std::runtime_error with a sentence.
FeetSolver foreign_feet_solver(const std::string& path);

/// What one solver did on one family. A branch is wrong where it is none, or not the nearest (the next) and the gap to
/// that exceeds the error bound of distances.
struct FeetTally {
  std::string family, solver, instruction_set;
  size_t cases = 0, wrong = 0, wrong_next = 0, with_next = 0;
  double distance = 0, normal = 0;  ///< the worst of both feet, in the units of FeetContract
  FeetCase worst_case{}, wrong_case{};

  bool passes() const {
    return wrong == 0 && wrong_next == 0 && distance <= FeetContract::kDistance &&
           normal <= FeetContract::kNormal;
  }
};

std::vector<FeetTally> judge_feet(const FeetFamily& family, const std::vector<FeetSolver>& solvers,
                                  size_t count, uint64_t seed);

std::vector<FeetTally> over_feet_families(const std::vector<FeetTally>& tallies);
std::string feet_table(const std::vector<FeetTally>& tallies);
std::string feet_csv(const std::vector<FeetTally>& tallies);

}  // namespace mien::accuracy
