#pragma once
// What a gradient shows beyond its stops is a place between them again.

#include <mien/paint.h>

#include <cmath>

namespace mien {

/// The place whose colour a gradient with stops from `first` to `last` shows at t. Extend::pad, and stops all at one
/// place, leave t as it is: it may lie beyond the stops, whose nearer end is meant then. So does an infinite t.
inline double extended_place(Extend extend, double first, double last, double t) {
  const double length = last - first;
  if (extend == Extend::pad || !(length > 0) || !std::isfinite(t)) return t;
  const double turns = (t - first) / length, whole = std::floor(turns);
  const double part = (turns - whole) * length;
  const bool back = extend == Extend::reflect && std::fmod(whole, 2.0) != 0.0;
  return first + (back ? length - part : part);
}

}  // namespace mien
