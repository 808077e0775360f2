#pragma once
// Real roots of polynomials in binary128, each inside a certified bracket.

#include "tools/accuracy/quad.h"

#include <vector>

namespace mien::accuracy {

/// c[0] + c[1] x + … ; at least one coefficient.
using Polynomial = std::vector<Quad>;

/// Every point of [lo, hi], ascending, where the polynomial changes sign or is exactly zero on a
/// border of its monotone pieces. Pieces are found from the derivative's roots, recursively, so no
/// sign change between two of them is missed; a root is then bracketed and bisected, by Newton
/// where that is faster, down to 2⁻¹¹⁰ of its own size.
std::vector<Quad> sign_changes(const Polynomial& p, Quad lo, Quad hi);

Quad value(const Polynomial& p, Quad x);

}  // namespace mien::accuracy
