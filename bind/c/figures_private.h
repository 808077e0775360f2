#pragma once
// Figures out of a caller's numbers, as mien_c.h lists them.

#include <mien/shape.h>
#include "bind/c/door_private.h"

#include <cmath>
#include <cstdint>
#include <string>

#include <mien/cubic_bezier.h>

namespace mien::c {

inline QuadBezier quad_of(const double* p) {
  need(p, "curve");
  return {{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}};
}

inline CubicBezier cubic_of(const double* p) {
  need(p, "curve");
  return {{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}};
}

inline double not_negative(double length, const char* what) {
  if (length < 0) refuse(what, "expected no negative number, got " + std::to_string(length));
  return length;
}

inline Ellipse ellipse_of(const double* p) {
  need(p, "ellipse");
  const double length = std::hypot(p[4], p[5]);
  if (!(length > 0) || !std::isfinite(length)) refuse("ellipse", "its direction has no length");
  return {{p[0], p[1]},
          {not_negative(p[2], "ellipse"), not_negative(p[3], "ellipse")},
          {p[4] / length, p[5] / length}};
}

inline ParabolaSide parabola_of(const double* p) {
  need(p, "side");
  const double length = std::hypot(p[2], p[3]);
  if (!(length > 0) || !std::isfinite(length)) refuse("side", "its axis has no length");
  return {{p[0], p[1]}, {p[2] / length, p[3] / length}, p[4]};
}

inline TaperedStroke tapered_of(const double* p) {
  need(p, "stroke");
  return {
      quad_of(p),
      {not_negative(p[6], "stroke"), not_negative(p[7], "stroke"), not_negative(p[8], "stroke")}};
}

inline void need_memory_for(std::size_t count, std::size_t bytes_each, const char* argument) {
  if (count > std::size_t(PTRDIFF_MAX) / bytes_each) misuse(argument, "is more than memory holds");
}

inline Line line_of(const double* p) {
  need(p, "line");
  return {{p[0], p[1]}, {p[2], p[3]}, not_negative(p[4], "line")};
}

}  // namespace mien::c
