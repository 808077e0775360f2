// Items P2 to P4 and P8: bases of any size, of matrices long either way, checked by what they must
// be; against NumPy in tests/tools/pca_numpy_test.py.

#include <gtest/gtest.h>

#include <mien/pca.h>

#include <cmath>
#include <random>

namespace mien {
namespace {

struct Data {
  std::size_t rows, columns;
  std::vector<double> numbers;
  MatrixSource source() const { return matrix_in_memory(numbers, rows, columns); }
};

/// Σ over `rank` of falling strength, plus a mean.
Data made(std::size_t rows, std::size_t columns, std::size_t rank, double falling = 0.5,
          unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> bell;
  Data data{rows, columns, std::vector<double>(rows * columns)};
  for (std::size_t c = 0; c < columns; ++c) {
    const double mean = 3 * bell(random);
    for (std::size_t r = 0; r < rows; ++r) data.numbers[r * columns + c] = mean;
  }
  double strength = 1;
  for (std::size_t k = 0; k < rank; ++k, strength *= falling) {
    std::vector<double> left(rows), right(columns);
    for (double& x : left) x = bell(random);
    for (double& x : right) x = bell(random);
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t c = 0; c < columns; ++c)
        data.numbers[r * columns + c] += strength * left[r] * right[c];
  }
  return data;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double orthonormality(const PcaBasis& basis) {
  double worst = 0;
  for (std::size_t i = 0; i < basis.count; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      worst = std::max(worst, std::abs(dot(basis.component(i), basis.component(j)) - (i == j)));
  return worst;
}

double worst_error(const Data& data, const PcaFit& fit) {
  double worst = 0;
  std::vector<double> frame(data.columns);
  for (std::size_t r = 0; r < data.rows; ++r) {
    decode_pca(fit.basis, std::span(fit.weights).subspan(r * fit.basis.count, fit.basis.count),
               frame);
    for (std::size_t c = 0; c < data.columns; ++c)
      worst = std::max(worst, std::abs(frame[c] - data.numbers[r * data.columns + c]));
  }
  return worst;
}

PcaFit fitted(const Data& data, std::size_t count, PcaOptions options = {}) {
  auto fit = fit_pca(data.source(), {.count = count}, options);
  EXPECT_TRUE(fit) << (fit ? "" : fit.error().what);
  return *std::move(fit);
}

// P8: any count, F much smaller and much larger than N, and square.
TEST(Pca, EveryCountFromOneToAll) {
  for (const auto& [rows, columns] :
       std::vector<std::pair<std::size_t, std::size_t>>{{7, 60}, {60, 7}, {9, 9}, {1, 5}, {5, 1}}) {
    const Data data = made(rows, columns, 12);
    const std::size_t most = std::min(rows, columns);
    double before = 1e300;
    for (std::size_t n = 1; n <= most; ++n) {
      const PcaFit fit = fitted(data, n);
      ASSERT_EQ(fit.basis.count, n);
      EXPECT_LT(orthonormality(fit.basis), 1e-13) << rows << " x " << columns << ", " << n;
      EXPECT_LE(fit.curve.back().rms, before + 1e-12);
      before = fit.curve.back().rms;
    }
    EXPECT_LT(worst_error(data, fitted(data, most)), 1e-12);  // all components: everything
  }
}

// P3: beyond the rank, components are orthonormal with variance 0.
TEST(Pca, BeyondTheRankVarianceIsZero) {
  for (const auto& [rows, columns] :
       std::vector<std::pair<std::size_t, std::size_t>>{{20, 300}, {300, 20}}) {
    const Data data = made(rows, columns, 3);
    const PcaFit fit = fitted(data, 20);
    EXPECT_GT(fit.basis.variances[2], 1e-3);
    for (std::size_t i = 3; i < 20; ++i) EXPECT_EQ(fit.basis.variances[i], 0) << i;
    EXPECT_LT(orthonormality(fit.basis), 1e-13);
    EXPECT_LT(worst_error(data, fit), 1e-12);
  }
}

// Variances are the weights' own, falling, and sum up to the total.
TEST(Pca, VariancesAreThoseOfTheWeights) {
  const Data data = made(40, 90, 40, 0.8);
  const PcaFit fit = fitted(data, 40);
  double sum = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    double square = 0, mean = 0;
    for (std::size_t r = 0; r < 40; ++r) {
      square += fit.weights[r * 40 + i] * fit.weights[r * 40 + i];
      mean += fit.weights[r * 40 + i];
    }
    EXPECT_NEAR(square / 39, fit.basis.variances[i], 1e-10 * fit.basis.variances[0]);
    EXPECT_NEAR(mean / 40, 0, 1e-12);
    EXPECT_LE(fit.basis.variances[i], fit.basis.variances[i ? i - 1 : 0]);
    sum += fit.basis.variances[i];
  }
  EXPECT_NEAR(sum / fit.basis.total_variance, 1, 1e-12);
}

// Singular values over twelve orders of magnitude: squares alone would lose those below 1e-8.
TEST(Pca, SmallComponentsAreNotLostInTheSquares) {
  const Data data = made(14, 200, 12, 0.1);
  const PcaFit fit = fitted(data, 12);
  for (std::size_t i = 1; i < 12; ++i) {
    const double ratio = std::sqrt(fit.basis.variances[i] / fit.basis.variances[i - 1]);
    EXPECT_GT(ratio, 0.003) << i;
    EXPECT_LT(ratio, 0.5) << i;
  }
  EXPECT_LT(orthonormality(fit.basis), 1e-13);
}

TEST(Pca, TheSameDataGiveTheSameBasisAndSigns) {
  const Data data = made(30, 50, 9);
  const PcaFit a = fitted(data, 5), b = fitted(data, 5);
  EXPECT_EQ(a.basis.components, b.basis.components);
  for (std::size_t i = 0; i < 5; ++i) {
    double largest = 0;
    for (const double x : a.basis.component(i))
      if (std::abs(x) > std::abs(largest)) largest = x;
    EXPECT_GT(largest, 0);
  }
}

// P3: by variance, and by the largest error of any vertex in any frame.
TEST(Pca, CountByVarianceIsTheFewest) {
  const Data data = made(50, 80, 20, 0.7);
  for (const double share : {0.5, 0.9, 0.999}) {
    const auto fit = fit_pca(data.source(), {.variance = share});
    ASSERT_TRUE(fit);
    EXPECT_GE(fit->curve.back().variance, share);
    const PcaFit one_less = fitted(data, fit->basis.count);
    EXPECT_LT(one_less.curve[one_less.curve.size() - 2].variance, share);
  }
}

TEST(Pca, LargestErrorHoldsOnEveryFrameAndIsTheFewest) {
  const Data data = made(60, 90, 25, 0.7);
  for (const bool single : {false, true})
    for (const double wanted : {2.0, 0.3, 0.01}) {
      const PcaOptions options{.vertices = equal_vertices(30, 3), .single = single};
      const auto fit = fit_pca(data.source(), {.max_error = wanted}, options);
      ASSERT_TRUE(fit);
      double worst = 0;
      std::vector<double> frame(90);
      for (std::size_t r = 0; r < 60; ++r) {
        decode_pca(fit->basis,
                   std::span(fit->weights).subspan(r * fit->basis.count, fit->basis.count), frame);
        for (std::size_t v = 0; v < 30; ++v) {
          double square = 0;
          for (std::size_t i = 3 * v; i < 3 * v + 3; ++i) {
            const double number = single ? double(float(frame[i])) : frame[i];
            square += std::pow(number - data.numbers[r * 90 + i], 2);
          }
          worst = std::max(worst, std::sqrt(square));
        }
      }
      EXPECT_LE(worst, wanted);
      EXPECT_NEAR(fit->curve.back().max, worst, 1e-12);
      EXPECT_GT(fit->curve[fit->curve.size() - 2].max, wanted);  // one less would not do
    }
}

TEST(Pca, AnErrorNoBasisCanKeepIsRefused) {
  const Data data = made(20, 30, 20, 0.9);
  const auto fit = fit_pca(data.source(), {.max_error = 1e-9}, {.single = true});
  ASSERT_FALSE(fit);
  EXPECT_NE(fit.error().what.find("no basis keeps an error of 1e-09"), std::string::npos);
}

// The way for matrices large both ways, on one small enough to know the answer.
TEST(Pca, RandomSubspaceAgreesWithTheDirectWay) {
  for (const auto& [rows, columns] :
       std::vector<std::pair<std::size_t, std::size_t>>{{200, 300}, {300, 200}}) {
    const Data data = made(rows, columns, 60, 0.7);
    const PcaFit direct = fitted(data, 8), random = fitted(data, 8, {.direct = 10});
    EXPECT_NE(direct.basis.components, random.basis.components);  // it was another way
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(dot(direct.basis.component(i), random.basis.component(i)), 1, 1e-6) << i;
      EXPECT_NEAR(direct.basis.variances[i] / random.basis.variances[i], 1, 1e-6);
    }
    EXPECT_LT(orthonormality(random.basis), 1e-13);
    const auto by_error = fit_pca(data.source(), {.max_error = 0.5}, {.direct = 10});
    ASSERT_TRUE(by_error);
    EXPECT_LE(worst_error(data, *by_error), 0.5);
  }
}

// P4: weights of frames are what fit stores; decoding them and encoding again changes nothing.
TEST(Pca, EncodeAndDecodeAgree) {
  const Data data = made(30, 40, 6);
  const PcaFit fit = fitted(data, 6);
  const auto weights = encode_pca(fit.basis, data.source());
  ASSERT_TRUE(weights);
  for (std::size_t i = 0; i < weights->size(); ++i)
    EXPECT_NEAR((*weights)[i], fit.weights[i], 1e-12);
  std::vector<double> block(10 * 5);
  const MatrixSource decoded = decoded_frames(fit.basis, fit.weights, 6, false);
  ASSERT_TRUE(decoded.read({3, 10, 7, 5}, block.data()));
  for (std::size_t r = 0; r < 10; ++r)
    for (std::size_t c = 0; c < 5; ++c)
      EXPECT_NEAR(block[r * 5 + c], data.numbers[(3 + r) * 40 + 7 + c], 1e-12);
}

// P5: what is printed is what is recomputed.
TEST(Pca, ComparisonIsTheCurvesLastPoint) {
  const Data data = made(25, 60, 20, 0.8);
  const VertexGroups vertices = equal_vertices(20, 3);
  const PcaFit fit = fitted(data, 4, {.vertices = vertices});
  const auto found =
      compare_frames(data.source(), decoded_frames(fit.basis, fit.weights, 4, false), vertices);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->all.rms, fit.curve.back().rms, 1e-12);
  EXPECT_NEAR(found->all.max, fit.curve.back().max, 1e-12);
  EXPECT_EQ(found->all.frame, fit.curve.back().frame);
  EXPECT_EQ(found->all.vertex, fit.curve.back().vertex);
  EXPECT_EQ(found->frame_max[found->all.frame], found->all.max);
}

TEST(Pca, RefusesWhatCannotBe) {
  const Data data = made(5, 9, 3);
  EXPECT_EQ(fit_pca(data.source(), {.count = 0}).error().what,
            "5 frames of 9 numbers have 1 to 5 components, not 0");
  EXPECT_EQ(fit_pca(data.source(), {.count = 6}).error().what,
            "5 frames of 9 numbers have 1 to 5 components, not 6");
  EXPECT_FALSE(fit_pca(data.source(), {.variance = 0}));
  EXPECT_FALSE(fit_pca(data.source(), {.variance = 1.5}));
  EXPECT_FALSE(fit_pca(data.source(), {.max_error = -1}));
  EXPECT_FALSE(fit_pca(data.source(), {}));
  EXPECT_FALSE(fit_pca(data.source(), {.count = 1, .variance = 0.5}));
  EXPECT_FALSE(fit_pca(matrix_in_memory({}, 0, 0), {.count = 1}));
}

TEST(Pca, CanBeCancelledAndPassesErrorsOn) {
  const Data data = made(50, 90, 3);
  const auto stopped =
      fit_pca(data.source(), {.count = 3}, {.progress = [](double) { return false; }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().what, "cancelled");
  MatrixSource broken = data.source();
  broken.read = [](const MatrixBlock&, double*) -> Expected<Done> { return Error{"a", "b"}; };
  EXPECT_EQ(fit_pca(broken, {.count = 1}).error().where, "a");
}

TEST(Pca, AllFramesEqual) {
  const Data data{4, 6, std::vector<double>(24, 2.5)};
  const PcaFit fit = fitted(data, 2);
  EXPECT_EQ(fit.basis.variances, (std::vector<double>{0, 0}));
  EXPECT_EQ(worst_error(data, fit), 0);
  EXPECT_LT(orthonormality(fit.basis), 1e-13);
}

}  // namespace
}  // namespace mien
