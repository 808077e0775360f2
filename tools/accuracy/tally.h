#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/accuracy/families.h"
#include "tools/accuracy/solver.h"

namespace mien::accuracy {

/// What one solver did on one family.
struct Tally {
  std::string family, solver, instruction_set;
  size_t cases = 0, bad = 0, nan = 0;  ///< nan: not a number, or infinite where the truth is not
  /// In the judge's units: the worst of the numbers; what all but one in a thousand of the answers keep, infinite if
  /// more of them are none; the bar, 0: none.
  double worst = 0, p999 = 0, bar = 0;
  double ns = 0;  ///< per point; 0: nobody measured it
  Case worst_case{};
  std::optional<Case> bad_case{};

  bool passes() const { return bar == 0 || (worst <= bar && bad == 0 && nan == 0); }
};

/// What solvers are measured against: binary128, or mien's own scalar forms in double precision, which are
/// thirty times as fast but serve float kernels only. The scalar forms are measured against binary128
/// themselves, and their error is 2⁻²⁷ of a float kernel's unit.
enum class Truth { binary128, scalar };

/// Runs the solvers on `count` cases of the family. The reference is computed once.
std::vector<Tally> run(const Family& family, const std::vector<Solver>& solvers, size_t count,
                       uint64_t seed, Truth truth = Truth::binary128);

/// Measures how long the solvers take on the family's cases, and notes it in their tallies.
void measure_times(std::vector<Tally>& tallies, const Family& family,
                   const std::vector<Solver>& solvers, uint64_t seed);

/// One row per solver and instruction set: the worst over the families.
std::vector<Tally> over_families(const std::vector<Tally>& tallies);

std::string table(const std::vector<Tally>& tallies);
std::string csv(const std::vector<Tally>& tallies);
/// A picture of `worst` by family and solver, on a logarithmic scale; 1 = the bar.
std::string svg(const std::vector<Tally>& tallies);

}  // namespace mien::accuracy
