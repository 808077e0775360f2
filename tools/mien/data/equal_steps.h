#pragma once
// Places along a scale that differ equally, whatever "differ" means.

#include <mien/expected.h>

#include <functional>
#include <vector>

namespace mien::command {

/// How much each of some places differs from the next, 0 for equal ones: one number fewer than places.
using Ruler = std::function<std::vector<double>(const std::vector<double>&)>;

/// `count` ≥ 2 places from `from` to `to`, both included, neighbours of which differ equally. A table of the way's
/// length gives them, and measuring the steps themselves mends them until they differ by at most a hundredth, or
/// do not get better: the ruler is asked for 65 places, or twice as many as steps, and a few times for `count`.
/// An error if nothing differs on the way.
Expected<std::vector<double>> equal_steps(double from, double to, int count, const Ruler& ruler);

}  // namespace mien::command
