#pragma once
#include <ostream>

#include "tools/accuracy/families.h"
#include "tools/accuracy/feet.h"

namespace mien::accuracy {

/// The cases of a family of quadratic Bézier curves as comma-separated values, every number a hex
/// float: family, x0, y0, x1, y1, x2, y2, px, py, and the true distance rounded to double, plus
/// what that rounding left over (their sum is good to 2⁻¹⁰⁵).
void write_cases(std::ostream& out, const Family& family, size_t count, uint64_t seed);
void write_cases_header(std::ostream& out, uint64_t seed);

/// The same of feet, for families of one quadratic curve; of others nothing. Where there is no next foot its distance is
/// infinite; next_barrier is how far the distance rises before another one is reached.
void write_feet_header(std::ostream& out, uint64_t seed);
void write_feet(std::ostream& out, const FeetFamily& family, size_t count, uint64_t seed);

}  // namespace mien::accuracy
