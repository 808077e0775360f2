#pragma once
// Principal components: an animation of F frames of N numbers as a mean, n components and n weights
// a frame.
//
//   const auto fit = fit_pca(matrix_in_memory(numbers, 220, 60000), {.count = 7});
//   decode_pca(fit->basis, weights_of_frame, frame);     // mean + Σ wᵢ · componentᵢ
//
// The mean is taken off first. Components are orthonormal, the one of largest variance first, each
// with its largest number positive, so that the same data always gives the same basis. Sources:
// docs/sources.md, principal components.

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
  std::size_t columns = 0;         ///< N, numbers of a frame
  std::size_t count = 0;           ///< n
  std::vector<double> mean;        ///< N
  std::vector<double> components;  ///< n × N, a component after the other; orthonormal
  std::vector<double> variances;   ///< n, falling: the weights' sum of squares / (F − 1); beyond
                                   ///< the data's rank 0
  double total_variance = 0;       ///< of all components there could be

  std::span<const double> component(std::size_t i) const {
    return {components.data() + i * columns, columns};
  }
};

/// Which numbers of a frame belong together when an error is a length: vertex v is the numbers
/// begin[v] … begin[v + 1] − 1, and its error is scale[v] · the length of their differences.
struct VertexGroups {
  std::vector<std::size_t> begin;
  std::vector<double> scale;
  std::size_t count() const { return scale.size(); }
};

/// `count` vertices of `size` numbers each, scale 1.
MIEN_API VertexGroups equal_vertices(std::size_t count, std::size_t size);

/// What is lost with so many components: over all frames and vertices.
struct PcaError {
  std::size_t count = 0;              ///< components kept
  double variance = 0;                ///< share of the total variance that they hold, 0 … 1
  double rms = 0;                     ///< root mean square of the vertices' errors
  double max = 0;                     ///< the largest error of any vertex in any frame …
  std::size_t frame = 0, vertex = 0;  ///< … which is there
};

/// How many components are wanted: exactly one of three.
struct PcaWish {
  std::optional<std::size_t> count;  ///< 1 … min(F, N)
  std::optional<double> variance;    ///< the fewest that hold this share of the variance, 0 … 1
  std::optional<double> max_error;  ///< the fewest with which no vertex of any frame is farther off
};

struct PcaOptions {
  VertexGroups vertices;      ///< empty: every number is a vertex
  bool single = false;        ///< the basis is to be kept as 32-bit floats: mean, components and
                              ///< weights are rounded to such, and errors are those of decoded
                              ///< 32-bit frames
  Progress progress;          ///< may cancel
  std::size_t direct = 2000;  ///< up to this min(F, N) the answer comes from one symmetric matrix
                              ///< of that side, exact to rounding; beyond, from a random subspace
                              ///< with power iterations, in memory of n + 10 rows and columns
};

struct PcaFit {
  PcaBasis basis;
  std::vector<double> weights;  ///< F × n
  std::vector<PcaError> curve;  ///< for rising counts; the last is the basis as it is
};

/// Fits a basis. Errors: a wish out of range, a source that cannot be read, "cancelled", too little
/// memory.
///
/// Method. min(F, N) <= direct: eigenvectors of the F × F or N × N matrix of products, whichever is
///   smaller, summed up block by block in double. Its rounding hides singular values below 1e-5 of
///   the largest, so those are found from the matrix of what the larger ones leave, again and
///   again: relative accuracy is kept to 1e-13 of the largest. Below that is rounding: the rank
///   ends, and further components are any that complete the orthonormal set.
/// Method beyond. Halko, Martinsson, Tropp, "Finding structure with randomness", SIAM Review 2011,
///   algorithm 4.4 with two power iterations; the random numbers are always the same.
/// Memory. The result, and blocks of 8 MB; the source is never held as a whole.
MIEN_API Expected<PcaFit> fit_pca(const MatrixSource& frames, const PcaWish& wish,
                                  const PcaOptions& options = {});

/// The weights of every frame (F × n): its difference from the mean along each component.
MIEN_API Expected<std::vector<double>> encode_pca(const PcaBasis& basis, const MatrixSource& frames,
                                                  const Progress& progress = {});

/// frame = mean + Σ weights[i] · component i, added up in this order.
MIEN_API void decode_pca(const PcaBasis& basis, std::span<const double> weights,
                         std::span<double> frame);

/// All decoded frames, by the first `count` components, for weights of basis.count a frame;
/// `single`: rounded to 32-bit floats. Basis and weights must outlive it.
MIEN_API MatrixSource decoded_frames(const PcaBasis& basis, std::span<const double> weights,
                                     std::size_t count, bool single);

/// What two sets of frames differ by.
struct FrameDifference {
  PcaError all;                   ///< count and variance are not set
  std::vector<double> frame_rms;  ///< per frame
  std::vector<double> frame_max;
};
MIEN_API Expected<FrameDifference> compare_frames(const MatrixSource& a, const MatrixSource& b,
                                                  const VertexGroups& vertices);

}  // namespace mien
