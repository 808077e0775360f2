#include <mien/tools/accuracy/solver.h>

#include <dlfcn.h>
#include <mien/sdf/batch/instruction_sets.h>
#include <mien/sdf/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mien::accuracy {
namespace {

using batch::InstructionSet;

double float_ulp(double x) {
  const float f = float(std::abs(x));
  return double(std::nextafter(f, std::numeric_limits<float>::infinity())) - double(f);
}

double size_of(const QuadBezier& c) {
  const auto extent = [](double a, double b, double d) {
    return std::max({a, b, d}) - std::min({a, b, d});
  };
  return std::max(extent(c.p0.x, c.p1.x, c.p2.x), extent(c.p0.y, c.p1.y, c.p2.y));
}

double farthest(const BezierCase& k) {
  double s = 0;
  for (const glm::dvec2& c : {k.curve.p0, k.curve.p1, k.curve.p2}) {
    s = std::max(s, std::hypot(k.p.x - c.x, k.p.y - c.y));
  }
  return s;
}

double batch_float(const BezierCase& k, Precision precision) {
  const float x = float(k.p.x), y = float(k.p.y);
  float d = 0;
  distances(k.curve, {&x, 1}, {&y, 1}, {&d, 1}, precision);
  return d;
}

double batch_double(const BezierCase& k) {
  double d = 0;
  distances(k.curve, std::span<const double>{&k.p.x, 1}, {&k.p.y, 1}, std::span<double>{&d, 1});
  return d;
}

double batch_many(const BezierCase& k) {  // among three, two of them certainly farther
  const auto moved = [&](double dx, double dy) {
    const glm::dvec2 by{dx, dy};
    return QuadBezier{k.curve.p0 + by, k.curve.p1 + by, k.curve.p2 + by};
  };
  const double away = 4 * farthest(k);
  const QuadBezier curves[3] = {moved(away, 0), k.curve, moved(0, -away)};
  const float x = float(k.p.x), y = float(k.p.y);
  float d = 0;
  distances(std::span<const QuadBezier>(curves), {&x, 1}, {&y, 1}, {&d, 1});
  return d;
}

Solver on(const InstructionSet& set, std::string name, Judge judge, double bar,
          std::function<double(const BezierCase&)> solve) {
  return {std::move(name), set.name, judge, bar, std::move(solve), [id = set.id] {
            batch::use_instruction_set(id);
          }};
}

}  // namespace

std::vector<Solver> own_solvers() {
  using C = DistancesContract;
  std::vector<Solver> all{{"scalar", "", Judge::exact, QuadBezierContract::kError / 0x1p-52,
                           [](const BezierCase& k) { return distance(k.curve, k.p); }}};
  for (const InstructionSet& set : batch::instruction_sets()) {
    all.push_back(on(set, "fast", Judge::fast, C::kFastError,
                     [](const BezierCase& k) { return batch_float(k, Precision::fast); }));
    all.push_back(on(set, "accurate", Judge::accurate, C::kAccurateUlps,
                     [](const BezierCase& k) { return batch_float(k, Precision::accurate); }));
    all.push_back(on(set, "double", Judge::exact, C::kDoubleError / 0x1p-52, batch_double));
    all.push_back(on(set, "many", Judge::fast, C::kFastError, batch_many));
  }
  return all;
}

Solver foreign_solver(const std::string& path) {
  using Solve = void(const double*, const double*, const double*, double*, size_t);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  auto* solve = reinterpret_cast<Solve*>(dlsym(library, "mien_accuracy_solve"));
  if (!solve) throw std::runtime_error(path + ": has no function mien_accuracy_solve");
  return {path.substr(path.find_last_of('/') + 1), "", Judge::fast, 0,
          [solve](const BezierCase& k) {
            const QuadBezier& c = k.curve;
            const double curve[6] = {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y};
            double d = std::numeric_limits<double>::quiet_NaN();
            solve(curve, &k.p.x, &k.p.y, &d, 1);
            return d;
          }};
}

double error_units(Judge judge, bool well_conditioned, const BezierCase& k, Quad truth,
                   double found) {
  if (!std::isfinite(found)) {
    const bool beyond_float = judge != Judge::exact && truth > std::numeric_limits<float>::max();
    return beyond_float && found > 0 ? 0 : std::numeric_limits<double>::infinity();
  }
  const double error = double(magnitude(Quad(found) - truth));
  const double size = size_of(k.curve), ulp = float_ulp(double(truth));
  switch (judge) {
    case Judge::fast:
      return error / std::max(0x1p-23 * size, ulp);
    case Judge::accurate: {
      using C = DistancesContract;
      const double slack = C::kAccurateSize / C::kAccurateUlps * size;
      return error / (well_conditioned ? ulp : std::max(ulp, slack));
    }
    case Judge::exact:
      break;
  }
  const double unit = 0x1p-52 * farthest(k);
  return error == 0 ? 0 : error / unit;
}

bool is_bad(const BezierCase& k, Quad truth, double found) {
  const double error = double(magnitude(Quad(found) - truth));
  return error > 1e-6 * size_of(k.curve) && error > 2 * float_ulp(double(truth));
}

}  // namespace mien::accuracy
