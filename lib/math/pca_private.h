#pragma once
// The parts of lib/math/pca: passes over the data, and the two ways to components.

#include <mien/pca.h>

#include <algorithm>
#include <functional>
#include <new>
#include <vector>

namespace mien::pca {

/// Thrown inside these files only; fit_pca and its sisters turn it into the Error it holds.
struct Unwind {
  Error error;
};

/// Numbers of a block: large enough for whole products, small enough to be nothing (8 MB).
inline constexpr std::size_t kBlock = std::size_t(1) << 20;

/// Goes over a matrix in blocks, less a mean, and tells the progress.
class Passes {
 public:
  Passes(const MatrixSource& source, const Progress& progress, int expected)
      : source_(source), progress_(progress), expected_(expected) {}

  std::size_t rows() const { return source_.rows; }
  std::size_t columns() const { return source_.columns; }
  std::vector<double> mean;  ///< taken off; empty: nothing is

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
  int expected_;  // passes, for the progress only
  double passed_ = 0;
  std::vector<double> buffer_;
};

/// Rows of an orthonormal set with what each holds.
struct Components {
  std::vector<double> rows;   ///< count × columns
  std::vector<double> sigma;  ///< singular values, falling
};

/// When to stop looking for more: given the singular values so far.
using Enough = std::function<bool(const std::vector<double>& sigma)>;

/// All components down to rounding, or until enough, by the products of the shorter side.
Components direct_components(Passes& passes, const Enough& enough);
/// The first `count`, by a random subspace.
Components random_components(Passes& passes, std::size_t count);

/// Makes rows orthonormal that nearly are, each changed by those before it only.
void make_orthonormal(std::vector<double>& rows, std::size_t columns);
/// Appends rows until there are `count`, orthonormal to those there and to each other.
void complete(Components& components, std::size_t columns, std::size_t count);

/// F × n: the frames' differences from the passes' mean along each row.
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
