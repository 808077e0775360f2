// Feet of many places.

#include <mien/feet.h>
#include "bind/c/figures_private.h"

#include <vector>

using namespace mien::c;

namespace {

constexpr mien_feet kNoFeet{.size = sizeof(mien_feet)};

mien::FootSpans feet_spans(const mien_feet* feet, std::size_t count, const char* argument) {
  if (!feet) return {};
  const mien_feet f = whole_struct(feet, kNoFeet, argument);
  const auto span = [&](auto* to) { return std::span(to, to ? count : 0); };
  return {span(f.piece),    span(f.t),        span(f.distance),
          span(f.normal_x), span(f.normal_y), span(f.bend)};
}

template <class Figure>
void find_feet(const Figure& figure, const double* x, const double* y, std::size_t count,
               const mien_feet* nearest, const mien_feet* next) {
  need_memory_for(count, sizeof(double), "count");
  const mien::FootSpans best = feet_spans(nearest, count, "nearest");
  const mien::FootSpans second = feet_spans(next, count, "next");
  if (count == 0) return;
  mien::nearest_feet(figure, std::span<const double>{&need(x, "x"), count}, {&need(y, "y"), count},
                     best, second);
}

template <class Figure>
mien_status feet_on_list(const char* function, const char* argument,
                         Figure (*figure)(const double*), std::size_t numbers,
                         const double* figures, std::size_t figure_count, const double* x,
                         const double* y, std::size_t count, const mien_feet* nearest,
                         const mien_feet* next, mien_error** error) {
  return pass(function, error, [&] {
    need_memory_for(figure_count, sizeof(Figure), argument);
    if (figure_count > 0) need(figures, argument);
    if (figure_count > std::size_t(INT32_MAX)) misuse(argument, "are more than 2^31");
    std::vector<Figure> all;
    for (std::size_t i = 0; i < figure_count; ++i) all.push_back(figure(figures + numbers * i));
    find_feet(std::span<const Figure>(all), x, y, count, nearest, next);
  });
}

}  // namespace

extern "C" {

void mien_feet_init(mien_feet* feet, size_t size) {
  init_struct(feet, size, kNoFeet);
}

mien_status mien_feet_quads_f64(const double* curves, size_t curve_count, const double* x,
                                const double* y, size_t count, const mien_feet* nearest,
                                const mien_feet* next, mien_error** error) {
  return feet_on_list("mien_feet_quads_f64", "curves", quad_of, 6, curves, curve_count, x, y, count,
                      nearest, next, error);
}
mien_status mien_feet_lines_f64(const double* lines, size_t line_count, const double* x,
                                const double* y, size_t count, const mien_feet* nearest,
                                const mien_feet* next, mien_error** error) {
  return feet_on_list("mien_feet_lines_f64", "lines", line_of, 5, lines, line_count, x, y, count,
                      nearest, next, error);
}
mien_status mien_feet_tapered_f64(const double* strokes, size_t stroke_count, const double* x,
                                  const double* y, size_t count, const mien_feet* nearest,
                                  const mien_feet* next, mien_error** error) {
  return feet_on_list("mien_feet_tapered_f64", "strokes", tapered_of, 9, strokes, stroke_count, x,
                      y, count, nearest, next, error);
}
mien_status mien_feet_ellipse_f64(const double ellipse[6], const double* x, const double* y,
                                  size_t count, const mien_feet* nearest, const mien_feet* next,
                                  mien_error** error) {
  return pass("mien_feet_ellipse_f64", error,
              [&] { find_feet(ellipse_of(ellipse), x, y, count, nearest, next); });
}
}
