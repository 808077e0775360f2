// The errors of a truncated basis: frames minus their mean, minus one component after the other.

#include "lib/base/memory_ran_out.h"
#include "pca_private.h"

#include <Eigen/Core>

#include <cmath>

namespace mien::pca {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds a block of differences to the errors.
void add_errors(const MatrixBlock& block, const double* left, const VertexGroups& vertices,
                std::size_t first_vertex, PcaError& error) {
  for (std::size_t r = 0; r < block.rows; ++r, left += block.columns) {
    const double* number = left;
    for (std::size_t v = first_vertex; vertices.begin[v] < block.column + block.columns; ++v) {
      double square = 0;
      for (std::size_t i = vertices.begin[v]; i < vertices.begin[v + 1]; ++i, ++number)
        square += *number * *number;
      square *= vertices.scale[v] * vertices.scale[v];
      error.rms += square;  // a sum of squares until the end
      if (square > error.max) {
        error.max = square;
        error.frame = block.row + r;
        error.vertex = v;
      }
    }
  }
}

std::size_t vertex_at(const VertexGroups& vertices, std::size_t column) {
  return std::size_t(std::lower_bound(vertices.begin.begin(), vertices.begin.end(), column) -
                     vertices.begin.begin());
}

}  // namespace

std::vector<double> weights_along(Passes& passes, const std::vector<double>& rows) {
  const Eigen::Index columns = Eigen::Index(passes.columns());
  const Eigen::Index count = Eigen::Index(rows.size()) / columns;
  std::vector<double> weights(passes.rows() * std::size_t(count));
  const Eigen::Map<const Rows> v(rows.data(), count, columns);
  Eigen::Map<Rows> w(weights.data(), Eigen::Index(passes.rows()), count);
  passes.by_rows([&](const MatrixBlock& block, double* numbers) {
    const Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), columns);
    w.middleRows(Eigen::Index(block.row), b.rows()).noalias() = b * v.transpose();
  });
  return weights;
}

std::vector<PcaError> error_curve(Passes& passes, const std::vector<double>& rows,
                                  const std::vector<double>& weights, const VertexGroups& vertices,
                                  const std::vector<std::size_t>& counts) {
  const Eigen::Index columns = Eigen::Index(passes.columns());
  const Eigen::Index count = Eigen::Index(rows.size()) / columns;
  const Eigen::Map<const Rows> v(rows.data(), count, columns);
  const Eigen::Map<const Rows> w(weights.data(), Eigen::Index(passes.rows()), count);
  std::vector<PcaError> curve(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) curve[i].count = counts[i];
  passes.by_vertices(vertices, [&](const MatrixBlock& block, double* numbers) {
    Eigen::Map<Rows> left(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    const auto rs = Eigen::seqN(Eigen::Index(block.row), left.rows());
    const std::size_t first = vertex_at(vertices, block.column);
    Eigen::Index done = 0;
    for (PcaError& error : curve) {
      const Eigen::Index more = Eigen::Index(error.count) - done;
      if (more > 0)
        left.noalias() -= w(rs, Eigen::seqN(done, more)) *
                          v.block(done, Eigen::Index(block.column), more, left.cols());
      done += more;
      add_errors(block, numbers, vertices, first, error);
    }
  });
  for (PcaError& error : curve) {
    error.rms = std::sqrt(error.rms / (double(passes.rows()) * double(vertices.count())));
    error.max = std::sqrt(error.max);
  }
  return curve;
}

}  // namespace mien::pca

namespace mien {

Expected<FrameDifference> compare_frames(const MatrixSource& a, const MatrixSource& b,
                                         const VertexGroups& vertices) try {
  return pca::guarded([&] {
    FrameDifference found;
    found.frame_rms.resize(a.rows), found.frame_max.resize(a.rows);
    const Progress silent;
    pca::Passes passes(a, silent, 1);
    std::vector<double> other;
    passes.by_rows([&](const MatrixBlock& block, double* numbers) {
      other.resize(block.rows * block.columns);
      if (auto read = b.read(block, other.data()); !read) throw pca::Unwind{read.error()};
      for (std::size_t i = 0; i < other.size(); ++i) numbers[i] -= other[i];
      for (std::size_t r = 0; r < block.rows; ++r) {
        PcaError one;
        pca::add_errors({block.row + r, 1, 0, block.columns}, numbers + r * block.columns, vertices,
                        0, one);
        found.all.rms += one.rms;
        if (one.max > found.all.max)
          found.all = {0, 0, found.all.rms, one.max, one.frame, one.vertex};
        found.frame_rms[block.row + r] = std::sqrt(one.rms / double(vertices.count()));
        found.frame_max[block.row + r] = std::sqrt(one.max);
      }
    });
    found.all.max = std::sqrt(found.all.max);
    found.all.rms = std::sqrt(found.all.rms / (double(a.rows) * double(vertices.count())));
    return found;
  });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
