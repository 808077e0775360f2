#pragma once
// Loops as the path data of SVG: M, l, q and z, in whole steps of a power of ten, so that relative coordinates add up
// without error.

#include "render/svg/fragment_loops.h"

#include <span>
#include <string>

namespace mien {

/// How many decimals [px] of coordinates are kept, so that rounding moves a point by at most `error` [px].
int decimals_for(double error);

/// `value` in the shortest way with so many decimals at most: "-.5", "12".
std::string short_decimal(double value, int decimals);

/// Loops that enclose nothing once they are rounded are left out; empty if none is left.
std::string path_data(std::span<const FragmentLoop> loops, int decimals);

}  // namespace mien
