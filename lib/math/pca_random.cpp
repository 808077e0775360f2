// The first components of a matrix that is large both ways, from a random subspace.

#include "pca_private.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>
#include <cstdint>

namespace mien::pca {
namespace {

using Matrix = Eigen::MatrixXd;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kMore = 10;    // directions beyond those wanted
constexpr int kPowerIterations = 2;  // each takes the subspace nearer by (σ_k+1 / σ_n)²

/// Nearly Gaussian random numbers (each the sum of twelve uniform ones), always the same.
Matrix random_matrix(Eigen::Index rows, Eigen::Index columns) {
  std::uint64_t state = 0x6D69656E;
  Matrix numbers(rows, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
    for (Eigen::Index r = 0; r < rows; ++r) {
      double sum = -6;
      for (int i = 0; i < 12; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        sum += double(state >> 11) * 0x1p-53;
      }
      numbers(r, c) = sum;
    }
  return numbers;
}

/// An orthonormal basis of the columns' span, in place.
void orthonormal_columns(Matrix& m) {
  const Eigen::HouseholderQR<Matrix> qr(m);
  m = qr.householderQ() * Matrix::Identity(m.rows(), m.cols());
}

Matrix times(Passes& passes, const Matrix& right) {  // X · right
  Matrix out(Eigen::Index(passes.rows()), right.cols());
  passes.by_rows([&](const MatrixBlock& block, double* numbers) {
    const Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    out.middleRows(Eigen::Index(block.row), b.rows()).noalias() = b * right;
  });
  return out;
}

Matrix transposed_times(Passes& passes, const Matrix& left) {  // Xᵀ · left
  Matrix out = Matrix::Zero(Eigen::Index(passes.columns()), left.cols());
  passes.by_rows([&](const MatrixBlock& block, double* numbers) {
    const Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    out.noalias() += b.transpose() * left.middleRows(Eigen::Index(block.row), b.rows());
  });
  return out;
}

}  // namespace

Components random_components(Passes& passes, std::size_t count) {
  const std::size_t side = std::min(passes.rows(), passes.columns());
  const Eigen::Index width = Eigen::Index(std::min(count + kMore, side));
  Matrix frames = times(passes, random_matrix(Eigen::Index(passes.columns()), width));
  Matrix numbers;
  for (int i = 0;; ++i) {
    orthonormal_columns(frames);
    numbers = transposed_times(passes, frames);
    if (i == kPowerIterations) break;
    orthonormal_columns(numbers);
    frames = times(passes, numbers);
  }
  // X ≈ frames · numbersᵀ. With numbers = Q R, its singular vectors follow from the small triangle R.
  const Eigen::HouseholderQR<Matrix> qr(numbers);
  const Matrix triangle =
      qr.matrixQR().topRows(width).triangularView<Eigen::Upper>().toDenseMatrix();
  const Eigen::JacobiSVD<Matrix> svd(triangle, Eigen::ComputeThinU);
  Components components;
  Eigen::Index kept = 0;
  const double least = svd.singularValues()[0] * 1e-13;
  while (kept < Eigen::Index(count) && svd.singularValues()[kept] > least)
    components.sigma.push_back(svd.singularValues()[kept++]);
  Matrix turned = Matrix::Zero(numbers.rows(), kept);
  turned.topRows(width) = svd.matrixU().leftCols(kept);
  turned = qr.householderQ() * turned;
  components.rows.resize(std::size_t(kept) * passes.columns());
  Eigen::Map<Rows>(components.rows.data(), kept, numbers.rows()) = turned.transpose();
  return components;
}

}  // namespace mien::pca
