// Distances of many points.

#include <mien/distance.h>
#include "bind/c/door_private.h"

#include <cmath>

using namespace mien::c;

namespace {

mien::QuadBezier quad_of(const double* p) {
  need(p, "curve");
  return {{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}};
}

mien::CubicBezier cubic_of(const double* p) {
  need(p, "curve");
  return {{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}};
}

double not_negative(double length, const char* what) {
  if (length < 0) refuse(what, "expected no negative number, got " + std::to_string(length));
  return length;
}

mien::Ellipse ellipse_of(const double* p) {
  need(p, "ellipse");
  const double length = std::hypot(p[4], p[5]);
  if (!(length > 0) || !std::isfinite(length)) refuse("ellipse", "its direction has no length");
  return {{p[0], p[1]},
          {not_negative(p[2], "ellipse"), not_negative(p[3], "ellipse")},
          {p[4] / length, p[5] / length}};
}

mien::TaperedStroke tapered_of(const double* p) {
  need(p, "stroke");
  return {
      quad_of(p),
      {not_negative(p[6], "stroke"), not_negative(p[7], "stroke"), not_negative(p[8], "stroke")}};
}

template <class Number, class Figure>
mien_status measure(const char* function, Figure figure, const double* numbers, const Number* x,
                    const Number* y, Number* d, size_t count, mien_error** error) {
  return pass(function, error, [&] {
    const auto from = figure(numbers);
    if (count == 0) return;
    if (count > std::size_t(PTRDIFF_MAX) / sizeof(Number))
      misuse("count", "is more than memory holds");
    mien::distances(from, std::span{&need(x, "x"), count}, std::span{&need(y, "y"), count},
                    std::span{&need(d, "d"), count});
  });
}

}  // namespace

extern "C" {

mien_status mien_distances_quad_f32(const double curve[6], const float* x, const float* y, float* d,
                                    size_t count, mien_error** error) {
  return measure("mien_distances_quad_f32", quad_of, curve, x, y, d, count, error);
}
mien_status mien_distances_quad_f64(const double curve[6], const double* x, const double* y,
                                    double* d, size_t count, mien_error** error) {
  return measure("mien_distances_quad_f64", quad_of, curve, x, y, d, count, error);
}
mien_status mien_distances_cubic_f32(const double curve[8], const float* x, const float* y,
                                     float* d, size_t count, mien_error** error) {
  return measure("mien_distances_cubic_f32", cubic_of, curve, x, y, d, count, error);
}
mien_status mien_distances_cubic_f64(const double curve[8], const double* x, const double* y,
                                     double* d, size_t count, mien_error** error) {
  return measure("mien_distances_cubic_f64", cubic_of, curve, x, y, d, count, error);
}
mien_status mien_distances_ellipse_f32(const double ellipse[6], const float* x, const float* y,
                                       float* d, size_t count, mien_error** error) {
  return measure("mien_distances_ellipse_f32", ellipse_of, ellipse, x, y, d, count, error);
}
mien_status mien_distances_ellipse_f64(const double ellipse[6], const double* x, const double* y,
                                       double* d, size_t count, mien_error** error) {
  return measure("mien_distances_ellipse_f64", ellipse_of, ellipse, x, y, d, count, error);
}
mien_status mien_distances_tapered_f32(const double stroke[9], const float* x, const float* y,
                                       float* d, size_t count, mien_error** error) {
  return measure("mien_distances_tapered_f32", tapered_of, stroke, x, y, d, count, error);
}
mien_status mien_distances_tapered_f64(const double stroke[9], const double* x, const double* y,
                                       double* d, size_t count, mien_error** error) {
  return measure("mien_distances_tapered_f64", tapered_of, stroke, x, y, d, count, error);
}
}
