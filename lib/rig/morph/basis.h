#pragma once
// A face animated by a basis: its vector is mean + Σ weight · component, decoded when it is posed.
// Morphs, controls and rules then act on that vector.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/pca.h>

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

struct Pose;
class Layout;

/// A basis of a face's vectors, with the weights of the frames it was fitted to.
struct FaceBasis {
  PcaBasis basis;               ///< basis.columns == the face's layout.size()
  std::vector<double> weights;  ///< frames × basis.count
  double fps = 30;              ///< of those frames; frame 0 is at `begin`
  double begin = 0;             ///< [s]

  std::size_t frames() const { return basis.count ? weights.size() / basis.count : 0; }
};

/// The weights at a time, interpolated linearly between the two nearest frames and held before the first
/// and after the last. At a frame's own time they are that frame's weights, bit for bit.
MIEN_API std::vector<double> weights_at(const FaceBasis& basis, double time);

/// The face vector of these weights; missing weights are 0. Rules are not applied yet.
MIEN_API FaceVector vector_from_basis(const FaceBasis& basis, std::span<const double> weights);

/// Frames of the posed face as rows, at first/fps, (first + 1)/fps … seconds, with the pose's
/// settings.
MIEN_API std::vector<double> frames_of_face(const Face& face, const Pose& pose, long first,
                                            std::size_t count, double fps);

/// The groups in which errors of a face vector are measured: each slice is a vertex. Places and lengths
/// count in pixels at `pixels_per_unit` (1: in the face's own units), colours in levels of 255, and
/// everything else in its own unit.
MIEN_API VertexGroups face_vertices(const Layout& layout, double pixels_per_unit);

}  // namespace mien
