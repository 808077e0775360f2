#include <mien/morph.h>

#include <mien/face_model.h>

#include <algorithm>
#include <cmath>

namespace mien {

std::vector<PointShift> point_shifts(const Face& rest, const Face& posed) {
  std::vector<PointShift> shifts;
  const std::vector<Slice>& slices = rest.model->layout.slices();
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (slices[i].kind != SliceKind::point) continue;
    const auto at = std::size_t(slices[i].begin);
    const glm::dvec2 a{rest.vector[at], rest.vector[at + 1]};
    const glm::dvec2 b{posed.vector[at], posed.vector[at + 1]};
    shifts.push_back({int(i), a, b, std::hypot(b.x - a.x, b.y - a.y)});
  }
  return shifts;
}

double largest_shift(const std::vector<PointShift>& shifts) {
  double largest = 0;
  for (const PointShift& shift : shifts) largest = std::max(largest, shift.amount);
  return largest;
}

}  // namespace mien
