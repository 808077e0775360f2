// Distances of many points.

#include <mien/distance.h>
#include "bind/c/figures_private.h"

#include <vector>

using namespace mien::c;

namespace {

template <class Number, class Figure>
mien_status measure(const char* function, Figure figure, const double* numbers, const Number* x,
                    const Number* y, Number* d, size_t count, mien_error** error) {
  return pass(function, error, [&] {
    const auto from = figure(numbers);
    if (count == 0) return;
    need_memory_for(count, sizeof(Number), "count");
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
mien_status mien_distances_parabola_f32(const double side[5], const float* x, const float* y,
                                        float* d, size_t count, mien_error** error) {
  return measure("mien_distances_parabola_f32", parabola_of, side, x, y, d, count, error);
}
mien_status mien_distances_parabola_f64(const double side[5], const double* x, const double* y,
                                        double* d, size_t count, mien_error** error) {
  return measure("mien_distances_parabola_f64", parabola_of, side, x, y, d, count, error);
}
mien_status mien_distances_tapered_f32(const double stroke[9], const float* x, const float* y,
                                       float* d, size_t count, mien_error** error) {
  return measure("mien_distances_tapered_f32", tapered_of, stroke, x, y, d, count, error);
}
mien_status mien_distances_tapered_f64(const double stroke[9], const double* x, const double* y,
                                       double* d, size_t count, mien_error** error) {
  return measure("mien_distances_tapered_f64", tapered_of, stroke, x, y, d, count, error);
}

mien_status mien_distances_quad_accurate_f32(const double curve[6], const float* x, const float* y,
                                             float* d, size_t count, mien_error** error) {
  return pass("mien_distances_quad_accurate_f32", error, [&] {
    const mien::QuadBezier from = quad_of(curve);
    if (count == 0) return;
    need_memory_for(count, sizeof(float), "count");
    mien::distances(from, {&need(x, "x"), count}, {&need(y, "y"), count}, {&need(d, "d"), count},
                    mien::Precision::accurate);
  });
}

mien_status mien_distances_quads_f32(const double* curves, size_t curve_count, const float* x,
                                     const float* y, float* d, size_t count, mien_error** error) {
  return pass("mien_distances_quads_f32", error, [&] {
    need_memory_for(curve_count, sizeof(mien::QuadBezier), "curve_count");
    if (curve_count > 0) need(curves, "curves");
    std::vector<mien::QuadBezier> all;
    for (std::size_t i = 0; i < curve_count; ++i) all.push_back(quad_of(curves + 6 * i));
    if (count == 0) return;
    need_memory_for(count, sizeof(float), "count");
    mien::distances(std::span<const mien::QuadBezier>(all), {&need(x, "x"), count},
                    {&need(y, "y"), count}, {&need(d, "d"), count});
  });
}

mien_status mien_distances_quad_on_grid_f32(const double curve[6], double x, double y, double step,
                                            size_t columns, size_t rows, float* d,
                                            mien_error** error) {
  return pass("mien_distances_quad_on_grid_f32", error, [&] {
    const mien::QuadBezier from = quad_of(curve);
    if (columns == 0 || rows == 0) return;
    need_memory_for(columns, sizeof(float), "columns");
    need_memory_for(rows, sizeof(float) * columns, "rows");
    mien::distances_on_grid(from, {x, y}, step, columns, rows, {&need(d, "d"), columns * rows});
  });
}
}
