#pragma once
// A face animated through a basis: its vector is mean + Σ weight · component, decoded when it is
// posed. Everything else poses it on from there: morphs, controls, rules.

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

/// The weights at a moment: mixed linearly from the two frames around it, held before the first and
/// after the last. At a frame's own time they are that frame's, bit for bit.
MIEN_API std::vector<double> weights_at(const FaceBasis& basis, double time);

/// The face vector of these weights; missing ones are 0. Not yet brought into range.
MIEN_API FaceVector vector_from_basis(const FaceBasis& basis, std::span<const double> weights);

/// Frames of a posed face as rows: at first/fps, (first + 1)/fps … seconds, with the pose's
/// settings.
MIEN_API std::vector<double> frames_of_face(const Face& face, const Pose& pose, long first,
                                            std::size_t count, double fps);

/// What an error of a face vector is: a slice is a vertex. Places and lengths count in pixels where
/// a picture has `pixels_per_unit` (1: in the face's own units), colours in levels of 255, all else
/// as it is.
MIEN_API VertexGroups face_vertices(const Layout& layout, double pixels_per_unit);

}  // namespace mien
