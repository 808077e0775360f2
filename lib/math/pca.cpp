#include "lib/base/memory_ran_out.h"
#include "pca_private.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace mien {
namespace {

using pca::Components;
using pca::Passes;
using pca::Unwind;

/// The number of passes that a fit is expected to make, for its progress.
constexpr int kPasses = 8;
constexpr std::size_t kEveryCount = 16;  // up to here the curve has every count
constexpr std::size_t kFirstTry = 32;  // components of the first try, if their number is not given
constexpr double kCurveStep = 1.25;  // and beyond, each count is so much larger than the one before

std::size_t most_components(const MatrixSource& frames) {
  return std::min(frames.rows, frames.columns);
}

void check_wish(const MatrixSource& frames, const PcaWish& wish) {
  const auto refuse = [](std::string what) { throw Unwind{Error{"", std::move(what)}}; };
  if (frames.rows == 0 || frames.columns == 0) refuse("there are no numbers to fit");
  if (bool(wish.count) + bool(wish.variance) + bool(wish.max_error) != 1)
    refuse("expected one of a count, a variance and a largest error");
  if (wish.count && (*wish.count < 1 || *wish.count > most_components(frames)))
    refuse(fmt::format("{} frames of {} numbers have 1 to {} components, not {}", frames.rows,
                       frames.columns, most_components(frames), *wish.count));
  if (wish.variance && !(*wish.variance > 0 && *wish.variance <= 1))
    refuse(fmt::format("a share of the variance goes from above 0 to 1, not {}", *wish.variance));
  if (wish.max_error && !(*wish.max_error > 0 && std::isfinite(*wish.max_error)))
    refuse(fmt::format("a largest error is a positive number, not {}", *wish.max_error));
}

double total_square(Passes& passes) {
  double total = 0;
  passes.by_rows([&](const MatrixBlock& block, const double* numbers) {
    const std::size_t size = block.rows * block.columns;
    for (std::size_t i = 0; i < size; ++i) total += numbers[i] * numbers[i];
  });
  return total;
}

void round_to_single(std::vector<double>& numbers) {
  for (double& number : numbers) number = double(float(number));
}

/// Makes the largest number of each component positive.
void set_signs(Components& components, std::size_t columns) {
  for (std::size_t i = 0; i < components.sigma.size(); ++i) {
    double* row = components.rows.data() + i * columns;
    const double* largest = std::max_element(
        row, row + columns, [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (*largest < 0)
      for (std::size_t c = 0; c < columns; ++c) row[c] = -row[c];
  }
}

void keep_first(PcaFit& fit, std::size_t count, std::size_t frames) {
  PcaBasis& basis = fit.basis;
  std::vector<double> weights(frames * count);
  for (std::size_t f = 0; f < frames; ++f)
    std::copy_n(fit.weights.begin() + std::ptrdiff_t(f * basis.count), count,
                weights.begin() + std::ptrdiff_t(f * count));
  fit.weights = std::move(weights);
  basis.count = count;
  basis.components.resize(count * basis.columns);
  basis.components.shrink_to_fit();
  basis.variances.resize(count);
}

/// The counts of the error curve, up to `count`; count − 1 is always among them.
std::vector<std::size_t> curve_counts(std::size_t count, bool every) {
  std::vector<std::size_t> counts;
  for (std::size_t k = 0; k < count;
       k = every || k < kEveryCount ? k + 1 : std::size_t(double(k) * kCurveStep))
    counts.push_back(k);
  if (count > 0 && counts.back() < count - 1) counts.push_back(count - 1);
  counts.push_back(count);
  return counts;
}

class Fitter {
 public:
  Fitter(const MatrixSource& frames, const PcaWish& wish, const PcaOptions& options)
      : frames_(frames),
        wish_(wish),
        options_(options),
        most_(most_components(frames)),
        passes_(frames, options.progress, kPasses),
        vertices_(options.vertices.begin.empty() ? equal_vertices(frames.columns, 1)
                                                 : options.vertices) {}

  PcaFit fit() {
    passes_.find_mean();
    if (options_.single) round_to_single(passes_.mean);
    total_ = total_square(passes_);
    PcaFit fit = most_ <= options_.direct ? direct() : random();
    if (options_.progress) options_.progress(1);
    return fit;
  }

 private:
  /// Whether these singular values fulfil the wish. They do not tell a largest error: if that is wished
  /// for, `tried` components are enough for a try.
  bool enough(const std::vector<double>& sigma, std::size_t tried = 0) const {
    if (wish_.count) return sigma.size() >= *wish_.count;
    if (wish_.max_error) return sigma.size() >= tried;
    double held = 0;
    for (const double s : sigma) held += s * s;
    return held >= *wish_.variance * total_ || total_ == 0;
  }

  PcaFit direct() {
    for (std::size_t tried = kFirstTry;; tried *= 4) {
      Components found = pca::direct_components(
          passes_, [&](const std::vector<double>& s) { return enough(s, tried); });
      const bool all = found.sigma.size() < tried;
      if (auto done = finished(std::move(found), all)) return *std::move(done);
    }
  }

  PcaFit random() {
    for (std::size_t count = wish_.count ? *wish_.count : kFirstTry;; count *= 2) {
      if (count > most_ / 4) return direct();  // most of the space: no shorter way
      Components found = pca::random_components(passes_, count);
      const bool all = found.sigma.size() < count;
      if (wish_.variance) {
        std::vector<double> first;
        while (first.size() < found.sigma.size() && !enough(first))
          first.push_back(found.sigma[first.size()]);
        if (!enough(first) && !all) continue;
        found.sigma = first;
        found.rows.resize(first.size() * passes_.columns());
      }
      if (auto done = finished(std::move(found), all)) return *std::move(done);
    }
  }

  /// The fit with these components, or nothing if they miss the largest error wished for. `all`: there are
  /// no more components, so nothing but rounding can be missing.
  std::optional<PcaFit> finished(Components found, bool all) {
    const std::size_t wished = wish_.count ? *wish_.count : 1;
    if (found.sigma.size() < wished) pca::complete(found, passes_.columns(), wished);
    set_signs(found, passes_.columns());
    PcaFit fit;
    PcaBasis& basis = fit.basis;
    basis.columns = passes_.columns();
    basis.count = found.sigma.size();
    basis.mean = passes_.mean;
    basis.components = std::move(found.rows);
    const double frames = double(std::max<std::size_t>(passes_.rows(), 2) - 1);
    for (const double s : found.sigma) basis.variances.push_back(s * s / frames);
    basis.total_variance = total_ / frames;
    if (options_.single) round_to_single(basis.components);
    fit.weights = pca::weights_along(passes_, basis.components);
    if (options_.single) round_to_single(fit.weights);
    fit.curve = curve_of(fit, curve_counts(basis.count, wish_.max_error.has_value()));
    if (wish_.max_error) return within_error(std::move(fit), all);
    return with_decoded_error(std::move(fit));
  }

  /// The fit with the curve's last point measured on decoded frames.
  PcaFit with_decoded_error(PcaFit fit) {
    if (!options_.single) return fit;
    const PcaError decoded = decoded_error(fit, fit.basis.count);
    PcaError& last = fit.curve.back();
    last = {last.count, last.variance, decoded.rms, decoded.max, decoded.frame, decoded.vertex};
    return fit;
  }

  std::vector<PcaError> curve_of(const PcaFit& fit, const std::vector<std::size_t>& counts) {
    auto curve = pca::error_curve(passes_, fit.basis.components, fit.weights, vertices_, counts);
    for (PcaError& error : curve) {
      const double held = std::accumulate(fit.basis.variances.begin(),
                                          fit.basis.variances.begin() + long(error.count), 0.0);
      error.variance =
          fit.basis.total_variance > 0 ? std::min(held / fit.basis.total_variance, 1.0) : 1;
    }
    return curve;
  }

  /// Whether the curve's point i keeps the error in decoded frames too: 32-bit frames are rounded once
  /// more.
  bool keeps_error(const PcaFit& fit, std::size_t i) {
    if (fit.curve[i].max > *wish_.max_error) return false;
    return !options_.single || decoded_error(fit, fit.curve[i].count).max <= *wish_.max_error;
  }

  PcaError decoded_error(const PcaFit& fit, std::size_t count) {
    const auto found = compare_frames(
        frames_, decoded_frames(fit.basis, fit.weights, count, options_.single), vertices_);
    if (!found) throw Unwind{found.error()};
    return found->all;
  }

  /// The fewest components (at least one) that keep the error.
  std::optional<PcaFit> within_error(PcaFit fit, bool all) {
    std::size_t i = 1;
    while (i < fit.curve.size() && !keeps_error(fit, i)) ++i;
    if (i == fit.curve.size()) {
      if (!all) return {};
      throw Unwind{Error{"", fmt::format("no basis keeps an error of {}: all {} components leave "
                                         "{:.3g}, which is the rounding of its numbers",
                                         *wish_.max_error, fit.basis.count, fit.curve.back().max)}};
    }
    const std::size_t count = fit.curve[i].count;
    const auto all_counts = curve_counts(count, false);
    std::vector<PcaError> curve;
    for (const std::size_t k : all_counts) curve.push_back(fit.curve[k]);
    fit.curve = std::move(curve);
    keep_first(fit, count, passes_.rows());
    return with_decoded_error(std::move(fit));
  }

  const MatrixSource& frames_;
  const PcaWish& wish_;
  const PcaOptions& options_;
  const std::size_t most_;
  Passes passes_;
  VertexGroups vertices_;
  double total_ = 0;  // sum of all squares after the mean is subtracted
};

}  // namespace

VertexGroups equal_vertices(std::size_t count, std::size_t size) {
  VertexGroups groups{std::vector<std::size_t>(count + 1), std::vector<double>(count, 1.0)};
  for (std::size_t v = 0; v <= count; ++v) groups.begin[v] = v * size;
  return groups;
}

Expected<PcaFit> fit_pca(const MatrixSource& frames, const PcaWish& wish,
                         const PcaOptions& options) try {
  return pca::guarded([&] {
    check_wish(frames, wish);
    return Fitter(frames, wish, options).fit();
  });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<std::vector<double>> encode_pca(const PcaBasis& basis, const MatrixSource& frames,
                                         const Progress& progress) try {
  return pca::guarded([&] {
    if (frames.columns != basis.columns)
      throw Unwind{Error{"", fmt::format("the basis is of frames of {} numbers, these have {}",
                                         basis.columns, frames.columns)}};
    Passes passes(frames, progress, 1);
    passes.mean = basis.mean;
    return pca::weights_along(passes, basis.components);
  });
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

MatrixSource decoded_frames(const PcaBasis& basis, std::span<const double> weights,
                            std::size_t count, bool single) {
  const std::size_t stride = basis.count;
  const auto read = [&basis, weights, count, stride, single](const MatrixBlock& block,
                                                             double* out) -> Expected<Done> {
    for (std::size_t r = 0; r < block.rows; ++r, out += block.columns) {
      std::copy_n(basis.mean.begin() + std::ptrdiff_t(block.column), block.columns, out);
      for (std::size_t i = 0; i < count; ++i) {
        const double* row = basis.components.data() + i * basis.columns + block.column;
        const double w = weights[(block.row + r) * stride + i];
        for (std::size_t c = 0; c < block.columns; ++c) out[c] += w * row[c];
      }
      if (single)
        for (std::size_t c = 0; c < block.columns; ++c) out[c] = double(float(out[c]));
    }
    return Done{};
  };
  return {stride ? weights.size() / stride : 0, basis.columns, read};
}

void decode_pca(const PcaBasis& basis, std::span<const double> weights, std::span<double> frame) {
  std::copy(basis.mean.begin(), basis.mean.end(), frame.begin());
  for (std::size_t i = 0; i < std::min(basis.count, weights.size()); ++i) {
    const double* row = basis.components.data() + i * basis.columns;
    for (std::size_t c = 0; c < basis.columns; ++c) frame[c] += weights[i] * row[c];
  }
}

}  // namespace mien
