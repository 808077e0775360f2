#include <mien/basis.h>

#include <mien/layout.h>
#include <mien/pose.h>

#include <algorithm>
#include <cmath>

namespace mien {

std::vector<double> weights_at(const FaceBasis& basis, double time) {
  const std::size_t n = basis.basis.count, frames = basis.frames();
  std::vector<double> weights(n, 0.0);
  if (frames == 0 || !std::isfinite(time)) return weights;
  const double at = std::clamp((time - basis.begin) * basis.fps, 0.0, double(frames - 1));
  // A frame's own time may be off by a rounding error: it counts as that frame.
  const double nearest = std::round(at);
  const double place = std::abs(at - nearest) < 1e-9 * std::max(1.0, at) ? nearest : at;
  const auto low = std::size_t(place);
  const std::size_t high = std::min(low + 1, frames - 1);
  const double u = place - double(low);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = basis.weights[low * n + i], b = basis.weights[high * n + i];
    weights[i] = a + u * (b - a);
  }
  return weights;
}

FaceVector vector_from_basis(const FaceBasis& basis, std::span<const double> weights) {
  FaceVector vector(basis.basis.columns);
  decode_pca(basis.basis, weights, vector);
  return vector;
}

std::vector<double> frames_of_face(const Face& face, const Pose& pose, long first,
                                   std::size_t count, double fps) {
  std::vector<double> rows;
  rows.reserve(count * face.vector.size());
  Pose at = pose;
  for (std::size_t f = 0; f < count; ++f) {
    at.time = double(first + long(f)) / fps;
    const Face posed = pose_face(face, at);
    rows.insert(rows.end(), posed.vector.begin(), posed.vector.end());
  }
  return rows;
}

VertexGroups face_vertices(const Layout& layout, double pixels_per_unit) {
  VertexGroups groups;
  for (const Slice& slice : layout.slices()) {
    const bool places = slice.kind == SliceKind::point || slice.kind == SliceKind::length ||
                        slice.kind == SliceKind::parabola;
    groups.begin.push_back(std::size_t(slice.begin));
    groups.scale.push_back(places ? pixels_per_unit : slice.kind == SliceKind::color ? 255.0 : 1.0);
  }
  groups.begin.push_back(layout.size());
  return groups;
}

}  // namespace mien
