// Components from the Gram matrix of the shorter side.

#include "pca_private.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstdint>

namespace mien::pca {
namespace {

using Matrix = Eigen::MatrixXd;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Below this share of the largest singular value of a round, the rounding of the squares (1e-16) shows.
constexpr double kTrusted = 1e-5;
/// Below this share of the largest of all, a singular value is only the rounding of the data.
constexpr double kRounding = 1e-13;

/// The Gram matrix of the frames, with the orthonormal columns of `known` projected out.
Matrix frame_products(Passes& passes, const Matrix& known) {
  Matrix products = Matrix::Zero(Eigen::Index(passes.rows()), Eigen::Index(passes.rows()));
  passes.by_columns([&](const MatrixBlock& block, double* numbers) {
    Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    if (known.cols() > 0) b -= known * (known.transpose() * b);
    products.selfadjointView<Eigen::Lower>().rankUpdate(b);
  });
  return products;
}

/// The same of the numbers: one row and column for each number of a frame.
Matrix number_products(Passes& passes, const Matrix& known) {
  Matrix products = Matrix::Zero(Eigen::Index(passes.columns()), Eigen::Index(passes.columns()));
  passes.by_rows([&](const MatrixBlock& block, double* numbers) {
    Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    if (known.cols() > 0) b -= (b * known) * known.transpose();
    products.selfadjointView<Eigen::Lower>().rankUpdate(b.transpose());
  });
  return products;
}

/// The components over numbers, from those over frames: rows uᵀX / σ.
std::vector<double> rows_from_frames(Passes& passes, const Matrix& left,
                                     const std::vector<double>& sigma) {
  const Eigen::Index count = left.cols(), columns = Eigen::Index(passes.columns());
  std::vector<double> rows(std::size_t(count * columns));
  Eigen::Map<Rows> out(rows.data(), count, columns);
  passes.by_columns([&](const MatrixBlock& block, double* numbers) {
    const Eigen::Map<Rows> b(numbers, Eigen::Index(block.rows), Eigen::Index(block.columns));
    out.middleCols(Eigen::Index(block.column), b.cols()).noalias() = left.transpose() * b;
  });
  for (Eigen::Index i = 0; i < count; ++i) out.row(i) /= sigma[std::size_t(i)];
  return rows;
}

/// Appends the `count` largest of these eigenvectors to `known`, and their singular values to `sigma`.
void append_components(const Eigen::SelfAdjointEigenSolver<Matrix>& eigen, Eigen::Index count,
                       Matrix& known, std::vector<double>& sigma) {
  const Eigen::Index before = known.cols(), last = known.rows() - 1;
  known.conservativeResize(Eigen::NoChange, before + count);
  for (Eigen::Index i = 0; i < count; ++i) {
    // Rounding leaves a trace of the large components here, which would outweigh a small one.
    Eigen::VectorXd next = eigen.eigenvectors().col(last - i);
    for (int again = 0; again < 2; ++again)
      next -= known.leftCols(before) * (known.leftCols(before).transpose() * next);
    known.col(before + i) = next.normalized();
    sigma.push_back(std::sqrt(eigen.eigenvalues()[last - i]));
  }
}

}  // namespace

Components direct_components(Passes& passes, const Enough& enough) {
  const bool few_frames = passes.rows() <= passes.columns();
  const Eigen::Index side = Eigen::Index(std::min(passes.rows(), passes.columns()));
  Matrix known(side, 0);
  std::vector<double> sigma;
  while (known.cols() < side && !enough(sigma)) {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(few_frames ? frame_products(passes, known)
                                                                 : number_products(passes, known));
    const double largest = std::sqrt(std::max(eigen.eigenvalues()[side - 1], 0.0));
    const double least =
        std::max(largest * kTrusted, (sigma.empty() ? largest : sigma[0]) * kRounding);
    Eigen::Index found = 0;
    while (found < side - known.cols() && eigen.eigenvalues()[side - 1 - found] > 0 &&
           std::sqrt(eigen.eigenvalues()[side - 1 - found]) > least)
      ++found;
    if (found == 0 || largest == 0) break;
    append_components(eigen, found, known, sigma);
  }
  // Keeps only as many as are asked for.
  Eigen::Index kept = 0;
  std::vector<double> first;
  while (kept < known.cols() && !enough(first)) first.push_back(sigma[std::size_t(kept++)]);
  known.conservativeResize(Eigen::NoChange, kept);
  Components components{{}, first};
  if (few_frames) {
    components.rows = rows_from_frames(passes, known, first);
  } else {
    components.rows.resize(std::size_t(kept * side));
    Eigen::Map<Rows>(components.rows.data(), kept, side) = known.transpose();
  }
  make_orthonormal(components.rows, passes.columns());
  return components;
}

void make_orthonormal(std::vector<double>& rows, std::size_t columns) {
  const Eigen::Index count = Eigen::Index(rows.size() / columns);
  if (count == 0) return;
  Eigen::Map<Rows> v(rows.data(), count, Eigen::Index(columns));
  Matrix products = Matrix::Zero(count, count);
  products.selfadjointView<Eigen::Lower>().rankUpdate(v);
  const Matrix lower = products.triangularView<Eigen::Lower>();
  if ((lower - Matrix::Identity(count, count)).cwiseAbs().maxCoeff() < 1e-14) return;
  const Eigen::LLT<Matrix> factor(products);
  // In slices, so that no copy of all rows is made.
  constexpr Eigen::Index kSlice = 4096;
  for (Eigen::Index c = 0; c < v.cols(); c += kSlice) {
    auto part = v.middleCols(c, std::min(kSlice, v.cols() - c));
    part = factor.matrixL().solve(Matrix(part));
  }
}

void complete(Components& components, std::size_t columns, std::size_t count) {
  std::uint64_t state = 1;
  const auto random = [&] {  // splitmix64, in −1 … 1
    std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return double(std::int64_t(z ^ (z >> 31))) * 0x1p-63;
  };
  while (components.sigma.size() < count) {
    const Eigen::Index known = Eigen::Index(components.sigma.size());
    const Eigen::Map<Rows> rows(components.rows.data(), known, Eigen::Index(columns));
    Eigen::VectorXd next(Eigen::Index{static_cast<Eigen::Index>(columns)});
    for (double& number : next) number = random();
    for (int again = 0; again < 3; ++again) {  // once is not enough when little is left
      if (known > 0) next -= rows.transpose() * (rows * next);
      next.normalize();
    }
    components.rows.insert(components.rows.end(), next.begin(), next.end());
    components.sigma.push_back(0.0);
  }
}

}  // namespace mien::pca
