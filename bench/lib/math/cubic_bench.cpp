// solve_cubic, and solve_cubics on every instruction set, beside Eigen's polynomial solver (companion
// matrix): ns per cubic, on cubics with three roots in [−1, 1] and with one.

#include <benchmark/benchmark.h>
#include <mien/distance.h>
#include "sdf/distance/instruction_sets.h"

#include <array>
#include <random>
#include <string>
#include <unsupported/Eigen/Polynomials>
#include <vector>

namespace {

/// Coefficients of x⁰ … x³.
using Cubic = std::array<double, 4>;

/// With three roots in [−1, 1], or one and a complex pair.
std::vector<Cubic> cubics(bool three) {
  std::mt19937_64 bits(1);
  const auto root = [&] { return double(bits() >> 11) * 0x1p-52 - 1; };
  std::vector<Cubic> all;
  for (int i = 0; i < 1000; ++i) {
    const double a = root(), b = root(), c = root();
    const double sum = three ? b + c : 2 * b, product = three ? b * c : b * b + c * c;
    all.push_back({-a * product, product + a * sum, -(a + sum), 1});
  }
  return all;
}

void report(benchmark::State& state, size_t count) {
  state.counters["ns"] =
      benchmark::Counter(double(state.iterations()) * double(count) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void OneByOne(benchmark::State& state, bool three) {
  const auto all = cubics(three);
  for (auto _ : state) {
    for (const Cubic& c : all) {
      const mien::Roots roots = mien::solve_cubic(c[3], c[2], c[1], c[0]);
      benchmark::DoNotOptimize(roots);
    }
  }
  report(state, all.size());
}

void Batch(benchmark::State& state, bool three, long long set) {
  mien::batch::use_instruction_set(set);
  std::array<std::vector<double>, 4> of;
  for (const Cubic& c : cubics(three)) {
    for (size_t n = 0; n < 4; ++n) of[n].push_back(c[n]);
  }
  std::vector<mien::Roots> roots(of[0].size());
  for (auto _ : state) {
    mien::solve_cubics(of[3], of[2], of[1], of[0], roots);
    benchmark::DoNotOptimize(roots.data());
    benchmark::ClobberMemory();
  }
  report(state, roots.size());
  mien::batch::use_instruction_set(0);
}

void Eigens(benchmark::State& state, bool three) {
  const auto all = cubics(three);
  std::vector<double> roots;
  for (auto _ : state) {
    for (const Cubic& c : all) {
      Eigen::PolynomialSolver<double, 3> solver;
      solver.compute(Eigen::Vector4d(c[0], c[1], c[2], c[3]));
      roots.clear();
      solver.realRoots(roots);
      benchmark::DoNotOptimize(roots.data());
    }
  }
  report(state, all.size());
}

void register_all() {
  for (const bool three : {true, false}) {
    const std::string roots = three ? "three" : "one";
    const auto add = [&](const std::string& name, auto run) {
      benchmark::RegisterBenchmark((name + "/" + roots).c_str(), run)->MinTime(0.1);
    };
    add("solve_cubic/scalar", [=](auto& s) { OneByOne(s, three); });
    for (const auto& set : mien::batch::instruction_sets()) {
      add("solve_cubics/" + set.name, [=, id = set.id](auto& s) { Batch(s, three, id); });
    }
    add("Eigen/scalar", [=](auto& s) { Eigens(s, three); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
