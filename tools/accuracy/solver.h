#pragma once
// The interface of a foreign solver that is to stand in the table: a shared library with this one function.
//
//   /* Distances from (x[i], y[i]) to the quadratic Bézier curve[] = {x0, y0, x1, y1, x2, y2}. */
//   extern "C" void mien_accuracy_solve(const double* curve, const double* x, const double* y,
//                                       double* distance, size_t count) {
//     for (size_t i = 0; i < count; ++i) distance[i] = my_distance(curve, x[i], y[i]);
//   }
//
// mien-accuracy --solver ./libmine.so

#include <mien/quad_bezier.h>

#include <functional>
#include <string>
#include <vector>

#include "tools/accuracy/families.h"
#include "tools/accuracy/quad.h"

namespace mien::accuracy {

/// The unit that an error is counted in, and the bar.
enum class Judge {
  fast,  ///< max(2⁻²³ size, float ulp): "mix". A parabola's size: its foot's and the point's from
         ///< the vertex
  accurate,  ///< float ulps where well-conditioned, else max(ulp, 1e-8/0.86 size)
  exact      ///< 2⁻⁵² S, S as each figure's contract says
};

/// Points for many distances at once, in both types.
struct Points {
  std::vector<float> xf, yf, df;
  std::vector<double> xd, yd, dd;
};

struct Solver {
  std::string name;
  std::string instruction_set;  ///< empty for scalar and foreign solvers
  Judge judge;
  double bar;     ///< 0: none promised
  size_t figure;  ///< which of Figure's it is for
  std::function<double(const Case&)> solve;
  std::function<void()> prepare = [] {};  ///< called before a run of cases
  /// The same for many points of one quadratic curve, to see how long it takes; may be empty.
  std::function<void(const QuadBezier&, Points&)> many = {};
};

/// mien's own: the scalar form, and every batch kernel on every instruction set.
std::vector<Solver> own_solvers();

/// mien's own scalar form.
double scalar_distance(const Case& k);

/// The size of a case's figure, in the unit of Judge::fast.
double size_of(const Case& k);

/// A foreign one, from a shared library; throws std::runtime_error with a sentence.
Solver foreign_solver(const std::string& path);

/// The error of `found`, in the judge's units; +infinity if it is not a number, or infinite where
/// the truth is not.
double error_units(Judge judge, bool well_conditioned, const Case& k, Quad truth, double found);

/// Wrong by more than rounding can explain: > 1e-6 size and > 2 float ulp.
bool is_bad(const Case& k, Quad truth, double found);

}  // namespace mien::accuracy
