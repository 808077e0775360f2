#pragma once
// Principal components: an animation of F frames of N numbers becomes a mean, n components, and n weights
// per frame.
//
//   const auto fit = fit_pca(matrix_in_memory(numbers, 220, 60000), {.count = 7});
//   decode_pca(fit->basis, weights_of_frame, frame);     // mean + Σ wᵢ · componentᵢ
//
// The mean is subtracted first. Components are orthonormal and sorted by falling variance. The largest
// number of each is positive, so the same data always gives the same basis. Sources: docs/sources.md,
// principal components.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/matrix_source.h>
#include <mien/progress.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace mien {

struct PcaBasis {
  std::size_t columns = 0;         ///< N, numbers per frame
  std::size_t count = 0;           ///< n
  std::vector<double> mean;        ///< N
  std::vector<double> components;  ///< n × N, one component after the other; orthonormal
  std::vector<double> variances;   ///< n, falling: the weights' sum of squares / (F − 1); 0
                                   ///< beyond the data's rank
  double total_variance = 0;       ///< of all components there could be

  std::span<const double> component(std::size_t i) const {
    return {components.data() + i * columns, columns};
  }
};

/// Groups the numbers of a frame into vertices, whose errors are lengths. Vertex v is the numbers
/// begin[v] … begin[v + 1] − 1; its error is scale[v] times the length of their differences.
struct VertexGroups {
  std::vector<std::size_t> begin;
  std::vector<double> scale;
  std::size_t count() const { return scale.size(); }
};

/// `count` vertices of `size` numbers each, scale 1.
MIEN_API VertexGroups equal_vertices(std::size_t count, std::size_t size);

/// The error of a number of components, over all frames and vertices.
struct PcaError {
  std::size_t count = 0;              ///< components kept
  double variance = 0;                ///< share of the total variance that they hold, 0 … 1
  double rms = 0;                     ///< root mean square of the vertices' errors
  double max = 0;                     ///< the largest error of any vertex in any frame …
  std::size_t frame = 0, vertex = 0;  ///< … and where it is
};

/// How many components are wanted. Exactly one of the three is set.
struct PcaWish {
  std::optional<std::size_t> count;  ///< 1 … min(F, N)
  std::optional<double> variance;    ///< the fewest that hold this share of the variance, 0 … 1
  std::optional<double> max_error;   ///< the fewest with which no vertex error is larger
};

struct PcaOptions {
  VertexGroups vertices = {};  ///< empty: every number is a vertex
  bool single = false;         ///< the basis will be stored as 32-bit floats: mean, components
                               ///< and weights are rounded to them, and errors are those of
                               ///< decoded 32-bit frames
  Progress progress = {};      ///< may cancel
  std::size_t direct = 2000;   ///< up to this min(F, N) one symmetric matrix of that size gives the
                               ///< answer, exact to rounding; beyond it a random subspace with
                               ///< power iterations does, in memory of n + 10 rows and columns
};

struct PcaFit {
  PcaBasis basis;
  std::vector<double> weights;  ///< F × n
  std::vector<PcaError> curve;  ///< for rising counts; the last is the basis as it is
};

/// Fits a basis. Errors: an option out of range, a source that cannot be read, "cancelled", too little
/// memory.
///
/// Method for min(F, N) <= direct. Eigenvectors of the F × F or the N × N Gram matrix, whichever is
///   smaller; it is summed block by block in double. Its rounding hides singular values below 1e-5 of the
///   largest. Those are found by deflation: from the Gram matrix of the residual, repeatedly. Relative
///   accuracy thus reaches down to 1e-13 of the largest. Whatever is smaller is rounding error and ends
///   the rank; further components are arbitrary ones that complete the orthonormal set.
/// Method beyond. Halko, Martinsson, Tropp, "Finding structure with randomness", SIAM Review 2011,
///   algorithm 4.4 with two power iterations; the random numbers are always the same.
/// Memory. The result, and blocks of 8 MB. The source is never held as a whole.
MIEN_API Expected<PcaFit> fit_pca(const MatrixSource& frames, const PcaWish& wish,
                                  const PcaOptions& options = {});

/// The weights of every frame (F × n): the projections of frame − mean onto the components.
MIEN_API Expected<std::vector<double>> encode_pca(const PcaBasis& basis, const MatrixSource& frames,
                                                  const Progress& progress = {});

/// frame = mean + Σ weights[i] · component i, summed in this order.
MIEN_API void decode_pca(const PcaBasis& basis, std::span<const double> weights,
                         std::span<double> frame);

/// All frames, decoded by the first `count` components; `weights` holds basis.count numbers per frame.
/// `single` rounds to 32-bit floats. Basis and weights must outlive the source.
MIEN_API MatrixSource decoded_frames(const PcaBasis& basis, std::span<const double> weights,
                                     std::size_t count, bool single);

/// The difference between two sets of frames.
struct FrameDifference {
  PcaError all;                   ///< count and variance are not set
  std::vector<double> frame_rms;  ///< per frame
  std::vector<double> frame_max;
};
MIEN_API Expected<FrameDifference> compare_frames(const MatrixSource& a, const MatrixSource& b,
                                                  const VertexGroups& vertices);

}  // namespace mien
