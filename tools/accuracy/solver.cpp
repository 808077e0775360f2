#include "tools/accuracy/solver.h"

#include <dlfcn.h>
#include <mien/distance.h>
#include "sdf/distance/instruction_sets.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>

namespace mien::accuracy {
namespace {

using batch::InstructionSet;

double float_ulp(double x) {
  const float f = float(std::abs(x));
  return double(std::nextafter(f, std::numeric_limits<float>::infinity())) - double(f);
}

double extent(std::initializer_list<double> v) {
  return std::max(v) - std::min(v);
}
double apart(glm::dvec2 a, glm::dvec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// A figure's own size, for "mix".
double size_of(const QuadBezier& c, glm::dvec2) {
  return std::max(extent({c.p0.x, c.p1.x, c.p2.x}), extent({c.p0.y, c.p1.y, c.p2.y}));
}
double size_of(const CubicBezier& c, glm::dvec2) {
  return std::max(extent({c.p0.x, c.p1.x, c.p2.x, c.p3.x}),
                  extent({c.p0.y, c.p1.y, c.p2.y, c.p3.y}));
}
double size_of(const Ellipse& e, glm::dvec2) {
  return std::max(e.radii.x, e.radii.y);
}
double size_of(const ParabolaSide& s, glm::dvec2 p) {
  return apart(nearest(s, p).point, s.vertex) + apart(p, s.vertex);
}
double size_of(const TaperedStroke& s, glm::dvec2 p) {
  return size_of(s.spine, p) + std::max({s.half_width[0], s.half_width[1], s.half_width[2]});
}

/// S of each figure's contract.
double scale_of(const QuadBezier& c, glm::dvec2 p) {
  return std::max({apart(c.p0, p), apart(c.p1, p), apart(c.p2, p)});
}
double scale_of(const CubicBezier& c, glm::dvec2 p) {
  return std::max({apart(c.p0, p), apart(c.p1, p), apart(c.p2, p), apart(c.p3, p)});
}
double scale_of(const Ellipse& e, glm::dvec2 p) {
  return apart(e.center, p) + size_of(e, p);
}
double scale_of(const ParabolaSide& s, glm::dvec2 p) {
  return std::abs(nearest(s, p).distance) + size_of(s, p);
}
double scale_of(const TaperedStroke& s, glm::dvec2 p) {
  return scale_of(s.spine, p) + std::max({s.half_width[0], s.half_width[1], s.half_width[2]});
}

template <class F>
constexpr size_t kIndex = Figure(F{}).index();

template <class F>
double batch_float(const Case& k) {
  const float x = float(k.p.x), y = float(k.p.y);
  float d = 0;
  distances(std::get<F>(k.figure), {&x, 1}, {&y, 1}, std::span<float>{&d, 1});
  return d;
}

double batch_accurate(const Case& k) {
  const float x = float(k.p.x), y = float(k.p.y);
  float d = 0;
  distances(std::get<QuadBezier>(k.figure), {&x, 1}, {&y, 1}, {&d, 1}, Precision::accurate);
  return d;
}

template <class F>
double batch_double(const Case& k) {
  double d = 0;
  distances(std::get<F>(k.figure), std::span<const double>{&k.p.x, 1}, {&k.p.y, 1},
            std::span<double>{&d, 1});
  return d;
}

double batch_many(const Case& k) {  // among three, two of them certainly farther
  const auto& curve = std::get<QuadBezier>(k.figure);
  const auto moved = [&](double dx, double dy) {
    const glm::dvec2 by{dx, dy};
    return QuadBezier{curve.p0 + by, curve.p1 + by, curve.p2 + by};
  };
  const double away = 4 * scale_of(curve, k.p);
  const QuadBezier curves[3] = {moved(away, 0), curve, moved(0, -away)};
  const float x = float(k.p.x), y = float(k.p.y);
  float d = 0;
  distances(std::span<const QuadBezier>(curves), {&x, 1}, {&y, 1}, {&d, 1});
  return d;
}

/// The distance at the corner of a tile, where a certified start is farthest off. The tile is as fine as in
/// a small picture, or much finer. It is alone, or one of three above each other, which are certified in
/// lanes.
double batch_grid(const Case& k) {
  constexpr size_t kTile = 16;
  const auto& curve = std::get<QuadBezier>(k.figure);
  float tiles[3 * kTile * kTile];
  const double step = size_of(curve, k.p) / (std::abs(k.p.x) < std::abs(k.p.y) ? 1024 : 16384);
  const size_t rows = std::abs(k.p.x) < 2 * std::abs(k.p.y) ? 3 * kTile : kTile;
  distances_on_grid(curve, k.p, step, kTile, rows, std::span(tiles).first(rows * kTile));
  return double(tiles[0]);
}

template <class F>
Solver scalar(double error) {
  Solver solver{"scalar",     "",
                Judge::exact, error / 0x1p-52,
                kIndex<F>,    [](const Case& k) { return distance(std::get<F>(k.figure), k.p); }};
  if constexpr (kIndex<F> == kIndex<QuadBezier>)
    solver.many = [](const QuadBezier& c, Points& p) {
      for (size_t i = 0; i < p.xd.size(); ++i) p.dd[i] = distance(c, {p.xd[i], p.yd[i]});
    };
  return solver;
}

Solver on(const InstructionSet& set, std::string name, Judge judge, double bar, size_t figure,
          std::function<double(const Case&)> solve,
          std::function<void(const QuadBezier&, Points&)> many = {}) {
  return {std::move(name),
          set.name,
          judge,
          bar,
          figure,
          std::move(solve),
          [id = set.id] { batch::use_instruction_set(id); },
          std::move(many)};
}

void many_fast(const QuadBezier& c, Points& p) {
  distances(c, p.xf, p.yf, p.df);
}
void many_accurate(const QuadBezier& c, Points& p) {
  distances(c, p.xf, p.yf, p.df, Precision::accurate);
}
void many_double(const QuadBezier& c, Points& p) {
  distances(c, p.xd, p.yd, p.dd);
}

}  // namespace

std::vector<Solver> own_solvers() {
  using C = DistancesContract;
  std::vector<Solver> all{scalar<QuadBezier>(QuadBezierContract::kError),
                          scalar<Ellipse>(EllipseContract::kError),
                          scalar<ParabolaSide>(ParabolaSideContract::kError),
                          scalar<TaperedStroke>(TaperedStrokeContract::kError),
                          scalar<CubicBezier>(CubicBezierContract::kError)};
  constexpr size_t kBezier = kIndex<QuadBezier>;
  for (const InstructionSet& set : batch::instruction_sets()) {
    all.push_back(
        on(set, "fast", Judge::fast, C::kFastError, kBezier, batch_float<QuadBezier>, many_fast));
    all.push_back(on(set, "accurate", Judge::accurate, C::kAccurateUlps, kBezier, batch_accurate,
                     many_accurate));
    all.push_back(on(set, "double", Judge::exact, C::kDoubleError / 0x1p-52, kBezier,
                     batch_double<QuadBezier>, many_double));
    all.push_back(on(set, "many", Judge::fast, C::kFastError, kBezier, batch_many));
    all.push_back(on(set, "grid", Judge::fast, C::kFastError, kBezier, batch_grid));
    all.push_back(on(set, "ellipse", Judge::fast, EllipseBatchContract::kError, kIndex<Ellipse>,
                     batch_float<Ellipse>));
    all.push_back(on(set, "ellipse double", Judge::exact, EllipseContract::kError / 0x1p-52,
                     kIndex<Ellipse>, batch_double<Ellipse>));
    all.push_back(on(set, "parabola", Judge::fast, ParabolaBatchContract::kError,
                     kIndex<ParabolaSide>, batch_float<ParabolaSide>));
    all.push_back(on(set, "parabola double", Judge::exact, ParabolaSideContract::kError / 0x1p-52,
                     kIndex<ParabolaSide>, batch_double<ParabolaSide>));
    all.push_back(on(set, "tapered", Judge::fast, TaperedBatchContract::kError,
                     kIndex<TaperedStroke>, batch_float<TaperedStroke>));
    all.push_back(on(set, "tapered double", Judge::exact, TaperedStrokeContract::kError / 0x1p-52,
                     kIndex<TaperedStroke>, batch_double<TaperedStroke>));
    all.push_back(on(set, "cubic", Judge::fast, CubicBatchContract::kError, kIndex<CubicBezier>,
                     batch_float<CubicBezier>));
    all.push_back(on(set, "cubic double", Judge::exact, CubicBezierContract::kError / 0x1p-52,
                     kIndex<CubicBezier>, batch_double<CubicBezier>));
  }
  return all;
}

double size_of(const Case& k) {
  return std::visit([&](const auto& f) { return size_of(f, k.p); }, k.figure);
}

double scalar_distance(const Case& k) {
  return std::visit([&](const auto& f) { return distance(f, k.p); }, k.figure);
}

Solver foreign_solver(const std::string& path) {
  using Solve = void(const double*, const double*, const double*, double*, size_t);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  auto* solve = reinterpret_cast<Solve*>(dlsym(library, "mien_accuracy_solve"));
  if (!solve) throw std::runtime_error(path + ": has no function mien_accuracy_solve");
  return {path.substr(path.find_last_of('/') + 1),
          "",
          Judge::fast,
          0,
          kIndex<QuadBezier>,
          [solve](const Case& k) {
            const QuadBezier& c = std::get<QuadBezier>(k.figure);
            const double curve[6] = {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y};
            double d = std::numeric_limits<double>::quiet_NaN();
            solve(curve, &k.p.x, &k.p.y, &d, 1);
            return d;
          }};
}

double error_units(Judge judge, bool well_conditioned, const Case& k, Quad truth, double found) {
  if (!std::isfinite(found)) {
    const bool beyond_float = judge != Judge::exact && truth > std::numeric_limits<float>::max();
    return beyond_float && found > 0 ? 0 : std::numeric_limits<double>::infinity();
  }
  const double error = double(magnitude(Quad(found) - truth));
  const double size = size_of(k), ulp = float_ulp(double(truth));
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
  const double unit =
      0x1p-52 * std::visit([&](const auto& f) { return scale_of(f, k.p); }, k.figure);
  return error == 0 ? 0 : error / unit;
}

bool is_bad(const Case& k, Quad truth, double found) {
  const double error = double(magnitude(Quad(found) - truth));
  return error > 1e-6 * size_of(k) && error > 2 * float_ulp(double(truth));
}

}  // namespace mien::accuracy
