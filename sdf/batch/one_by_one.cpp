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

}  // namespace mien
