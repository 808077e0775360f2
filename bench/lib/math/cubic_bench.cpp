// solve_cubic beside Eigen's polynomial solver (companion matrix), on cubics with three roots in [−1, 1].

#include <benchmark/benchmark.h>
#include <mien/lib/math/cubic.h>

#include <array>
#include <random>
#include <unsupported/Eigen/Polynomials>
#include <vector>

namespace {

std::vector<std::array<double, 4>> cubics() {
  std::mt19937_64 bits(1);
  const auto root = [&] { return double(bits() >> 11) * 0x1p-52 - 1; };
  std::vector<std::array<double, 4>> all;
  for (int i = 0; i < 1000; ++i) {
    const double a = root(), b = root(), c = root();
    all.push_back({-a * b * c, a * b + b * c + c * a, -(a + b + c), 1});
  }
  return all;
}

void Mien(benchmark::State& state) {
  const auto all = cubics();
  for (auto _ : state) {
    for (const auto& c : all) {
      const mien::Roots roots = mien::solve_cubic(c[3], c[2], c[1], c[0]);
      benchmark::DoNotOptimize(roots);
    }
  }
  state.SetItemsProcessed(state.iterations() * int64_t(all.size()));
}
BENCHMARK(Mien);

void Eigens(benchmark::State& state) {
  const auto all = cubics();
  std::vector<double> roots;
  for (auto _ : state) {
    for (const auto& c : all) {
      Eigen::PolynomialSolver<double, 3> solver;
      solver.compute(Eigen::Vector4d(c[0], c[1], c[2], c[3]));
      roots.clear();
      solver.realRoots(roots);
      benchmark::DoNotOptimize(roots.data());
    }
  }
  state.SetItemsProcessed(state.iterations() * int64_t(all.size()));
}
BENCHMARK(Eigens);

}  // namespace
