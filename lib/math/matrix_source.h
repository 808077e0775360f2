#pragma once
// A matrix that is read in blocks, so that it may be larger than memory.

#include <mien/expected.h>

#include <cstddef>
#include <functional>
#include <span>

namespace mien {

/// A block of rows and columns of a matrix.
struct MatrixBlock {
  std::size_t row, rows, column, columns;
};

/// rows × columns finite numbers. `read` writes a block, row by row, to `out`
/// (block.rows · block.columns numbers); it may be called any number of times, in any order.
struct MatrixSource {
  std::size_t rows = 0, columns = 0;
  std::function<Expected<Done>(const MatrixBlock& block, double* out)> read;
};

/// A matrix in memory, row by row; `numbers` must outlive it.
inline MatrixSource matrix_in_memory(std::span<const double> numbers, std::size_t rows,
                                     std::size_t columns) {
  return {rows, columns, [=](const MatrixBlock& b, double* out) -> Expected<Done> {
            for (std::size_t r = 0; r < b.rows; ++r)
              for (std::size_t c = 0; c < b.columns; ++c)
                *out++ = numbers[(b.row + r) * columns + b.column + c];
            return Done{};
          }};
}

}  // namespace mien
