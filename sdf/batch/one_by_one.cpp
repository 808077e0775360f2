#include <mien/sdf/batch/one_by_one.h>
#include <mien/sdf/distance.h>

namespace mien {
namespace {

template <class Figure, class T>
void each(const Figure& figure, std::span<const T> x, std::span<const T> y, std::span<T> d) {
  batch::require_spans("distances", batch::span_of(x), batch::span_of(y), batch::span_of(d));
  batch::distances_one_by_one(figure, x, y, d);
}

}  // namespace

using Floats = std::span<const float>;
using Doubles = std::span<const double>;

void distances(const Ellipse& f, Doubles x, Doubles y, std::span<double> d) {
  each(f, x, y, d);
}
void distances(const ParabolaSide& f, Doubles x, Doubles y, std::span<double> d) {
  each(f, x, y, d);
}
void distances(const TaperedStroke& f, Doubles x, Doubles y, std::span<double> d) {
  each(f, x, y, d);
}
void distances(const CubicBezier& f, Floats x, Floats y, std::span<float> d) {
  each(f, x, y, d);
}
void distances(const CubicBezier& f, Doubles x, Doubles y, std::span<double> d) {
  each(f, x, y, d);
}

void solve_cubics(Doubles a, Doubles b, Doubles c, Doubles d, std::span<Roots> out) {
  const batch::Span span = {out.data(), out.size(), sizeof(Roots)};
  batch::require_spans("solve_cubics", batch::span_of(a), batch::span_of(b), span);
  batch::require_spans("solve_cubics", batch::span_of(c), batch::span_of(d), span);
  for (size_t i = 0; i < out.size(); ++i) out[i] = solve_cubic(a[i], b[i], c[i], d[i]);
}

}  // namespace mien
