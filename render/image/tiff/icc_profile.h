#pragma once
// What a TIFF's numbers mean, as colour management reads it.

#include <cstdint>
#include <vector>

namespace mien {

enum class ToneCurve { srgb, linear };

/// An ICC profile (version 4, matrix and curves) for the primaries of sRGB with that curve.
/// Source: ICC.1:2010; the curve is IEC 61966-2-1's, the colorants its primaries adapted from D65
/// to D50 by Bradford's transform.
std::vector<std::uint8_t> icc_profile(ToneCurve curve);

}  // namespace mien
