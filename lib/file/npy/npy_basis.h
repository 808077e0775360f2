#pragma once
// Basis files: arrays in NumPy's .npy format, one after the other, so that Python can read them.
//
//   with open("head.basis", "rb") as f:
//       info = json.loads(np.load(f).tobytes()); mean = np.load(f); components = np.load(f)
//       variances = np.load(f); weights = np.load(f)
//   frames = mean + np.tensordot(weights, components, 1)
//
//   info        uint8: JSON text with format, format_version, frames, vertices, dimensions, total_variance,
//               curve; of a face also face, slices, fps, begin
//   mean        [V, D]        float32 or float64 as the frames were
//   components  [n, V, D]     orthonormal
//   variances   [n] float64
//   weights     [F, n]

#include <mien/api.h>
#include <mien/basis.h>
#include <mien/expected.h>
#include <mien/npy.h>
#include <mien/pca.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace mien {

struct BasisFile {
  PcaFit fit;
  std::size_t frames = 0, vertices = 0, dimensions = 1;
  bool single = false;  ///< numbers are 32-bit floats

  // Only for a basis of face vectors; otherwise empty.
  std::string face;
  std::vector<std::pair<std::string, int>> slices;  ///< name and size, in the vector's order
  double fps = 0, begin = 0;

  /// Size in bytes of the frames it was fitted to, and of mean, components and weights.
  std::size_t bytes_before() const { return frames * vertices * dimensions * (single ? 4u : 8u); }
  std::size_t bytes_after() const {
    return ((fit.basis.count + 1) * vertices * dimensions + frames * fit.basis.count) *
           (single ? 4u : 8u);
  }
};

MIEN_API Expected<BasisFile> read_basis(const std::filesystem::path& path);
MIEN_API Expected<Done> write_basis(const ByteSink& sink, const BasisFile& file);

/// The basis in the form that poses `face`; an error if the face's vector has other slices.
MIEN_API Expected<FaceBasis> face_basis(const BasisFile& file, const Face& face);
/// Marks a basis as one of this face's vectors.
MIEN_API void set_face(BasisFile& file, const Face& face);

}  // namespace mien
