#include "pca_private.h"

#include <cmath>

namespace mien::pca {

void Passes::show(const MatrixBlock& block, const Visit& visit) {
  buffer_.resize(block.rows * block.columns);
  if (auto read = source_.read(block, buffer_.data()); !read) throw Unwind{read.error()};
  if (!mean.empty())
    for (std::size_t r = 0; r < block.rows; ++r)
      for (std::size_t c = 0; c < block.columns; ++c)
        buffer_[r * block.columns + c] -= mean[block.column + c];
  visit(block, buffer_.data());
  passed_ += double(block.rows) * double(block.columns) / (double(rows()) * double(columns()));
  if (progress_ && !progress_(std::min(passed_ / expected_, 0.99)))
    throw Unwind{Error{"", "cancelled"}};
}

void Passes::by_columns(const Visit& visit) {
  const std::size_t step = std::max<std::size_t>(kBlock / rows(), 1);
  for (std::size_t c = 0; c < columns(); c += step)
    show({0, rows(), c, std::min(step, columns() - c)}, visit);
}

void Passes::by_rows(const Visit& visit) {
  const std::size_t step = std::max<std::size_t>(kBlock / columns(), 1);
  for (std::size_t r = 0; r < rows(); r += step)
    show({r, std::min(step, rows() - r), 0, columns()}, visit);
}

void Passes::by_vertices(const VertexGroups& vertices, const Visit& visit) {
  constexpr std::size_t kColumns = 768, kRows = 256;  // a block that stays in the cache
  for (std::size_t v = 0; v < vertices.count();) {
    std::size_t end = v + 1;
    while (end < vertices.count() && vertices.begin[end + 1] - vertices.begin[v] <= kColumns) ++end;
    const std::size_t column = vertices.begin[v], width = vertices.begin[end] - column;
    for (std::size_t r = 0; width > 0 && r < rows(); r += kRows)
      show({r, std::min(kRows, rows() - r), column, width}, visit);
    v = end;
  }
}

void Passes::find_mean() {
  std::vector<double> sums(columns(), 0.0);
  mean.clear();
  by_rows([&](const MatrixBlock& block, double* numbers) {
    for (std::size_t r = 0; r < block.rows; ++r)
      for (std::size_t c = 0; c < block.columns; ++c) sums[c] += *numbers++;
  });
  for (double& sum : sums) sum /= double(rows());
  mean = std::move(sums);
}

}  // namespace mien::pca
