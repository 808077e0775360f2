#pragma once
// Places along a scale that differ equally, whatever "differ" means.

#include <mien/expected.h>

#include <functional>
#include <vector>

namespace mien::command {

/// How much two places differ: 0 for equal places, and growing as they part.
using Difference = std::function<double(double, double)>;

/// `count` ≥ 2 places from `from` to `to`, both included, neighbours of which differ equally, to 10⁻⁴ of the
/// way. An error if the ends do not differ.
Expected<std::vector<double>> equal_steps(double from, double to, int count,
                                          const Difference& difference);

}  // namespace mien::command
