// What a distance costs: ns per distance of every batch kernel on every instruction set, on a
// raster tile (16 × 16 points, 1/1024 of the curve apart) and on incoherent points, to 1 and to 30
// curves; beside a scalar closed form in double precision and the machine's floor, in the same run.
// tools/bench_distances turns a run into the table of docs/numerics.md.

#include <benchmark/benchmark.h>

#include <mien/distance.h>
#include "sdf/distance/grid/grid_work.h"
#include "sdf/distance/instruction_sets.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "bench/support/floor.h"

namespace mien {
namespace {

constexpr size_t kPoints = 256, kCurves = 200, kLong = 64 * kPoints;

enum class Pattern { tile, incoherent };

/// kCurves random curves and, for each, kPoints points.
template <class T>
struct Work {
  std::vector<QuadBezier> curves;
  std::vector<T> x, y, d;

  explicit Work(Pattern pattern) : d(kPoints) {
    std::mt19937 bits(1);
    const auto unit = [&] { return double(bits() >> 8) * 0x1p-24; };
    for (size_t c = 0; c < kCurves; ++c) {
      const double n[8] = {unit(), unit(), unit(), unit(), unit(), unit(), unit(), unit()};
      curves.push_back({{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}});
      for (size_t i = 0; i < kPoints; ++i) {
        const bool tile = pattern == Pattern::tile;
        x.push_back(T(tile ? n[6] + double(i % 16) / 1024 : unit()));
        y.push_back(T(tile ? n[7] + double(i / 16) / 1024 : unit()));
      }
    }
  }
  std::span<const T> xs(size_t c) const { return std::span(x).subspan(c * kPoints, kPoints); }
  std::span<const T> ys(size_t c) const { return std::span(y).subspan(c * kPoints, kPoints); }
};

/// Runs body(c) over all sets of points; reports ns per distance.
template <class T, class Body>
void each_set(benchmark::State& state, Work<T>& work, Body body) {
  for (auto _ : state) {
    for (size_t c = 0; c < kCurves; ++c) body(c);
    benchmark::DoNotOptimize(work.d.data());
    benchmark::ClobberMemory();
  }
  state.counters["ns"] =
      benchmark::Counter(double(state.iterations()) * kCurves * kPoints * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void Float(benchmark::State& state, Pattern pattern, Precision precision, long long set) {
  batch::use_instruction_set(set);
  Work<float> work(pattern);
  each_set(state, work,
           [&](size_t c) { distances(work.curves[c], work.xs(c), work.ys(c), work.d, precision); });
  batch::use_instruction_set(0);
}

void Double(benchmark::State& state, Pattern pattern, long long set) {
  batch::use_instruction_set(set);
  Work<double> work(pattern);
  each_set(state, work, [&](size_t c) {
    distances(work.curves[c], work.xs(c), work.ys(c), std::span<double>(work.d));
  });
  batch::use_instruction_set(0);
}

/// One signed figure, through its float batch or its scalar form.
template <class T, class Figure>
void Signed(benchmark::State& state, Pattern pattern, const Figure& figure, long long set) {
  batch::use_instruction_set(set);
  Work<T> work(pattern);
  each_set(state, work,
           [&](size_t c) { distances(figure, work.xs(c), work.ys(c), std::span<T>(work.d)); });
  batch::use_instruction_set(0);
}
template <class Figure>
void SignedScalar(benchmark::State& state, Pattern pattern, const Figure& figure) {
  Work<double> work(pattern);
  each_set(state, work, [&](size_t c) {
    for (size_t i = 0; i < kPoints; ++i) {
      work.d[i] = distance(figure, {work.xs(c)[i], work.ys(c)[i]});
    }
  });
}

const Ellipse kEllipse{{0.4, 0.55}, {0.5, 0.2}, {0.8, 0.6}};
const ParabolaSide kParabola{{0.4, 0.2}, {0.6, 0.8}, 1.3};
const TaperedStroke kStroke{{{0.1, 0.2}, {0.4, 0.9}, {0.9, 0.3}}, {0.05, 0.1, 0.02}};
const CubicBezier kCubic{{0.1, 0.2}, {0.3, 1.1}, {0.7, -0.3}, {0.9, 0.8}};

/// 30 curves; counted per point and curve.
void Many(benchmark::State& state, Pattern pattern, long long set) {
  batch::use_instruction_set(set);
  Work<float> work(pattern);
  const std::span<const QuadBezier> thirty = std::span(work.curves).first(30);
  each_set(state, work, [&](size_t c) {
    if (c < kCurves / 30 + 1) distances(thirty, work.xs(c), work.ys(c), work.d);
  });
  state.counters["ns"] =
      benchmark::Counter(double(state.iterations()) * (kCurves / 30 + 1) * 30 * kPoints * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  batch::use_instruction_set(0);
}

/// Calls of kLong points: 64 tiles, one after the other, or as many points at random.
void Long(benchmark::State& state, Pattern pattern, Precision precision, long long set) {
  constexpr size_t kFew = 20;
  batch::use_instruction_set(set);
  Work<float> work(pattern);
  std::vector<float> x(kLong), y(kLong), d(kLong);
  for (size_t i = 0; i < kLong; ++i) {
    const size_t tile = i / kPoints;
    const bool is_tile = pattern == Pattern::tile;
    x[i] = is_tile ? work.x[i % kPoints] + float(tile % 8) / 64 : work.x[i];
    y[i] = is_tile ? work.y[i % kPoints] + float(tile / 8) / 64 : work.y[i];
  }
  for (auto _ : state) {
    for (size_t c = 0; c < kFew; ++c) {
      distances(work.curves[c * 10], x, y, d, precision);
      benchmark::DoNotOptimize(d.data());
      benchmark::ClobberMemory();
    }
  }
  state.counters["ns"] =
      benchmark::Counter(double(state.iterations()) * kFew * kLong * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  batch::use_instruction_set(0);
}

/// Square grids of `side` points, 1/1024 apart, to the curves one by one; some of their tiles are
/// certified and some are not, as chance has it, or all are.
void Grid(benchmark::State& state, size_t side, bool only_certified, long long set) {
  batch::use_instruction_set(set);
  Work<float> work(Pattern::tile);
  const size_t most = side > 16 ? 20 : kCurves, tiles = (side / 16) * (side / 16);
  std::vector<float> d(side * side);
  std::vector<size_t> curves;
  for (size_t c = 0; c < kCurves && curves.size() < most; ++c) {
    const batch::Grid grid{{work.xs(c)[0], work.ys(c)[0]}, 1.0 / 1024, side, side};
    const size_t certified = batch::distances_on_grid(work.curves[c], grid, d);
    if (!only_certified || certified == tiles) curves.push_back(c);
  }
  for (auto _ : state) {
    for (const size_t c : curves) {
      const glm::dvec2 origin{work.xs(c)[0], work.ys(c)[0]};
      distances_on_grid(work.curves[c], origin, 1.0 / 1024, side, side, d);
    }
    benchmark::DoNotOptimize(d.data());
    benchmark::ClobberMemory();
  }
  state.counters["ns"] =
      benchmark::Counter(double(state.iterations()) * double(curves.size() * side * side) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  batch::use_instruction_set(0);
}

void Scalar(benchmark::State& state, Pattern pattern) {
  Work<double> work(pattern);
  each_set(state, work, [&](size_t c) {
    for (size_t i = 0; i < kPoints; ++i) {
      work.d[i] = distance(work.curves[c], {work.xs(c)[i], work.ys(c)[i]});
    }
  });
}

/// The textbook's closed form, for comparison only: Cardano with a cube root or a cosine, in double
/// precision. Not right on nearly straight curves, and no attempt is made to mend it.
double closed_form(const QuadBezier& c, glm::dvec2 p) {
  const glm::dvec2 a = c.p1 - c.p0, b = c.p0 - 2.0 * c.p1 + c.p2, d = c.p0 - p;
  const double bb = glm::dot(b, b), v = glm::dot(a, b) / bb;
  const double k = (2 * glm::dot(a, a) + glm::dot(d, b)) / (3 * bb) - v * v;
  const double q =
      (v * (2 * glm::dot(a, a) + glm::dot(d, b)) - glm::dot(d, a)) / bb / 2 - v * v * v;
  const double disc = q * q + k * k * k;
  const auto square_at = [&](double t) {
    t = std::fmin(std::fmax(t, 0), 1);
    const glm::dvec2 r = d + t * (2.0 * a + t * b);
    return glm::dot(r, r);
  };
  if (disc >= 0) {
    const double r = std::sqrt(disc);
    return std::sqrt(square_at(std::cbrt(q + r) + std::cbrt(q - r) - v));
  }
  const double r = std::sqrt(-k), angle = std::acos(q / (r * -k)) / 3;
  const double third = 2 * std::numbers::pi / 3;
  return std::sqrt(std::fmin(square_at(2 * r * std::cos(angle) - v),
                             square_at(2 * r * std::cos(angle + third) - v)));
}

void ClosedForm(benchmark::State& state, Pattern pattern) {
  Work<double> work(pattern);
  each_set(state, work, [&](size_t c) {
    for (size_t i = 0; i < kPoints; ++i) {
      work.d[i] = closed_form(work.curves[c], {work.xs(c)[i], work.ys(c)[i]});
    }
  });
}

void register_all() {
  using benchmark::RegisterBenchmark;
  for (const Pattern pattern : {Pattern::tile, Pattern::incoherent}) {
    const std::string where = pattern == Pattern::tile ? "/tile" : "/incoherent";
    const auto add = [&](const std::string& name, auto run) {
      RegisterBenchmark((name + where).c_str(), run)->MinTime(0.1);
    };
    add("closed form f64/scalar", [=](auto& s) { ClosedForm(s, pattern); });
    add("distance f64/scalar", [=](auto& s) { Scalar(s, pattern); });
    add("ellipse f64/scalar", [=](auto& s) { SignedScalar(s, pattern, kEllipse); });
    add("parabola f64/scalar", [=](auto& s) { SignedScalar(s, pattern, kParabola); });
    add("tapered stroke f64/scalar", [=](auto& s) { SignedScalar(s, pattern, kStroke); });
    add("cubic f64/scalar", [=](auto& s) { SignedScalar(s, pattern, kCubic); });
    for (const batch::InstructionSet& set : batch::instruction_sets()) {
      const auto id = set.id;
      add("ellipse f32/" + set.name, [=](auto& s) { Signed<float>(s, pattern, kEllipse, id); });
      add("ellipse f64/" + set.name, [=](auto& s) { Signed<double>(s, pattern, kEllipse, id); });
      add("parabola f32/" + set.name, [=](auto& s) { Signed<float>(s, pattern, kParabola, id); });
      add("parabola f64/" + set.name, [=](auto& s) { Signed<double>(s, pattern, kParabola, id); });
      add("tapered stroke f32/" + set.name,
          [=](auto& s) { Signed<float>(s, pattern, kStroke, id); });
      add("tapered stroke f64/" + set.name,
          [=](auto& s) { Signed<double>(s, pattern, kStroke, id); });
      add("cubic f32/" + set.name, [=](auto& s) { Signed<float>(s, pattern, kCubic, id); });
      add("cubic f64/" + set.name, [=](auto& s) { Signed<double>(s, pattern, kCubic, id); });
      add("fast f32/" + set.name, [=](auto& s) { Float(s, pattern, Precision::fast, id); });
      add("fast f32, long spans/" + set.name,
          [=](auto& s) { Long(s, pattern, Precision::fast, id); });
      add("accurate f32, long spans/" + set.name,
          [=](auto& s) { Long(s, pattern, Precision::accurate, id); });
      add("accurate f32/" + set.name, [=](auto& s) { Float(s, pattern, Precision::accurate, id); });
      add("30 curves f32/" + set.name, [=](auto& s) { Many(s, pattern, id); });
      add("double f64/" + set.name, [=](auto& s) { Double(s, pattern, id); });
    }
  }
  for (const batch::InstructionSet& set : batch::instruction_sets()) {
    const auto id = set.id;
    const auto add = [&](const std::string& name, auto run) {
      RegisterBenchmark((name + "/" + set.name + "/alone").c_str(), run)->MinTime(0.1);
    };
    add("grid 16 × 16", [=](auto& s) { Grid(s, 16, false, id); });
    add("grid 128 × 128", [=](auto& s) { Grid(s, 128, false, id); });
    add("grid 128 × 128, all certified", [=](auto& s) { Grid(s, 128, true, id); });
  }
  bench::register_floor();
}

}  // namespace
}  // namespace mien

int main(int argc, char** argv) {
  mien::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
