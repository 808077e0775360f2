#pragma once
// solve_cubic on its own families of nasty cases, judged in 113 bits: no root missed, none invented, each
// as accurate as its condition allows.

#include <mien/cubic_roots.h>
#include "tools/accuracy/families.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mien::accuracy {

/// a x³ + b x² + c x + d, as {a, b, c, d}.
using Cubic = std::array<double, 4>;

struct CubicFamily {
  std::string name;
  Cubic (*draw)(Random&);
};

const std::vector<CubicFamily>& cubic_families();

/// A root is robust if the cubic changes sign around it by more than 16 · 2⁻⁵² of its terms at both
/// turns (or towards infinity): no rounding of the coefficients can take it away. A condition unit
/// is how far rounding the coefficients moves a root: 2⁻⁵² · (terms / |slope| + |x|).
struct CubicTally {
  std::string family, solver;
  std::size_t cases = 0;
  std::size_t missed =
      0;  ///< robust roots without a found one within the contract's condition units
  std::size_t invented = 0;  ///< found where the cubic's value is above 16 · 2⁻⁵² of its terms
  std::size_t disordered = 0;
  double worst_root = 0;   ///< of the robust roots: error in condition units
  double worst_value = 0;  ///< |cubic| at any root found, in 2⁻⁵² of its terms
  std::optional<Cubic> fault{};

  bool passes() const;
};

struct CubicSolver {
  std::string name;
  std::function<void(std::span<const Cubic>, std::span<Roots>)> solve;
  std::function<void()> prepare = [] {};  ///< called before a run of cases
};

/// A solver of one cubic at a time.
CubicSolver one_by_one(std::string name, Roots (*solve)(double a, double b, double c, double d));

/// solve_cubic, and solve_cubics on every instruction set.
std::vector<CubicSolver> own_cubic_solvers();

CubicTally judge_cubics(const CubicFamily& family, std::size_t count, uint64_t seed,
                        const CubicSolver& solver);

std::string cubic_table(const std::vector<CubicTally>& tallies);

}  // namespace mien::accuracy
