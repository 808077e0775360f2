#pragma once
// The parts of lib/math/pca: passes over the data, and the two ways to components.

#include <mien/pca.h>

#include <algorithm>
#include <functional>
#include <new>
#include <vector>

namespace mien::pca {

/// Thrown inside these files only; the public functions turn it into the Error it holds.
struct Unwind {
  Error error;
};

/// How many numbers a block has: enough for efficient matrix products, and only 8 MB.
inline constexpr std::size_t kBlock = std::size_t(1) << 20;

/// Visits a matrix in blocks, with a mean subtracted, and reports the progress.
class Passes {
 public:
  Passes(const MatrixSource& source, const Progress& progress, int expected)
      : source_(source), progress_(progress), expected_(expected) {}

  std::size_t rows() const { return source_.rows; }
  std::size_t columns() const { return source_.columns; }
  std::vector<double> mean;  ///< subtracted; empty: none

  using Visit = std::function<void(const MatrixBlock& block, double* numbers)>;
  /// Blocks of all rows, or of all columns.
  void by_columns(const Visit& visit);
  void by_rows(const Visit& visit);
  /// Blocks cut between vertices.
  void by_vertices(const VertexGroups& vertices, const Visit& visit);

  /// Sets `mean`.
  void find_mean();

 private:
  void show(const MatrixBlock& block, const Visit& visit);

  const MatrixSource& source_;
  const Progress& progress_;
  int expected_;  // number of passes, for the progress only
  double passed_ = 0;
  std::vector<double> buffer_;
};

/// Orthonormal rows with their singular values.
struct Components {
  std::vector<double> rows;   ///< count × columns
  std::vector<double> sigma;  ///< singular values, falling
};

/// Whether the singular values found so far are enough.
using Enough = std::function<bool(const std::vector<double>& sigma)>;

/// All components down to rounding, or until there are enough, from the Gram matrix of the shorter side.
Components direct_components(Passes& passes, const Enough& enough);
/// The first `count`, by a random subspace.
Components random_components(Passes& passes, std::size_t count);

/// Orthonormalizes rows that nearly are. Each is changed by those before it only.
void make_orthonormal(std::vector<double>& rows, std::size_t columns);
/// Appends rows until there are `count`, orthonormal to those there and to each other.
void complete(Components& components, std::size_t columns, std::size_t count);

/// F × n: the projections of each frame, minus the passes' mean, onto the rows.
std::vector<double> weights_along(Passes& passes, const std::vector<double>& rows);

/// Errors with the first k components for every k of `counts` (rising), in one pass. `variance` is
/// left for the caller.
std::vector<PcaError> error_curve(Passes& passes, const std::vector<double>& rows,
                                  const std::vector<double>& weights, const VertexGroups& vertices,
                                  const std::vector<std::size_t>& counts);

/// Runs `work`; an Unwind or a lack of memory becomes an Error.
template <class Work>
auto guarded(Work&& work) -> Expected<decltype(work())> {
  try {
    return work();
  } catch (const Unwind& unwind) {
    return unwind.error;
  } catch (const std::bad_alloc&) {
    return Error{"", "not enough memory for these components"};
  }
}

}  // namespace mien::pca
