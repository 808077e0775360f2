#include "tools/accuracy/cubics.h"
#include <mien/distance.h>
#include "sdf/distance/instruction_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tools/accuracy/quad.h"

namespace mien::accuracy {
namespace {

/// a (x − r)(x − s)(x − t), its coefficients rounded once.
Cubic with_roots(Quad a, Quad r, Quad s, Quad t) {
  return {double(a), double(-a * (r + s + t)), double(a * (r * s + s * t + t * r)),
          double(-a * r * s * t)};
}

Cubic three_roots(Random& r) {
  const double x = r.between(-1, 1), y = r.between(-1, 1);
  return with_roots(1, x, y, r.between(-1, 1));
}
Cubic one_root(Random& r) {  // and a complex pair, close to the axis or not
  const Quad x = r.between(-1, 1), re = r.between(-1, 1), im = r.magnitude(-8, 0);
  const Quad pair = re * re + im * im;
  return {1, double(-x - 2 * re), double(pair + 2 * re * x), double(-x * pair)};
}
Cubic foot(Random& r) {  // of a point on a quadratic Bézier
  const glm::dvec2 p0 = r.point(), p1 = r.point(), p2 = r.point(), q = p0 - r.point();
  const glm::dvec2 a = p1 - p0, b = (p2 - p1) - a;
  return {glm::dot(b, b), 3 * glm::dot(a, b), 2 * glm::dot(a, a) + glm::dot(q, b), glm::dot(q, a)};
}
Cubic two_close(Random& r) {
  const Quad x = r.between(-1, 1), gap = r.magnitude(-12, -1);
  return with_roots(r.between(0.5, 2), x, x + gap, r.between(-1, 1));
}
Cubic three_close(Random& r) {
  const Quad x = r.between(-1, 1), gap = r.magnitude(-12, -1);
  return with_roots(r.between(0.5, 2), x, x + gap, x - Quad(r.magnitude(-12, -1)));
}
Cubic exactly_double(Random& r) {  // of small fractions: the coefficients are exact
  const auto few = [&] { return std::floor(r.between(-64, 65)) / 16; };
  const double x = few();
  return with_roots(r.sign(), x, x, r.chance(0.1) ? x : few());
}
Cubic small_lead(Random& r) {
  const double a = r.magnitude(-16, -1) * r.sign(), b = r.between(-1, 1), c = r.between(-1, 1);
  return {a, b, c, r.between(-1, 1)};
}
Cubic small_ends(Random& r) {  // each coefficient of its own size, some nothing
  Cubic f{};
  for (double& v : f) v = r.chance(0.1) ? 0 : r.magnitude(-16, 0) * r.sign();
  return f;
}
Cubic any_cubic_scale(Random& r) {
  Cubic f{};
  for (double& v : f) v = r.magnitude(-20, 20) * r.sign();
  return f;
}
Cubic scaled_roots(Random& r) {
  const double k = r.magnitude(-20, 20), x = k * r.between(-1, 1), y = k * r.between(-1, 1);
  return with_roots(r.magnitude(-20, 20), x, y, k * r.between(-1, 1));
}

struct Exact {
  Quad a, b, c, d;

  explicit Exact(const Cubic& f) : a(f[0]), b(f[1]), c(f[2]), d(f[3]) {}
  Quad operator()(Quad x) const { return ((a * x + b) * x + c) * x + d; }
  Quad slope(Quad x) const { return (3 * a * x + 2 * b) * x + c; }
  Quad terms(Quad x) const {
    const Quad y = magnitude(x);
    return ((magnitude(a) * y + magnitude(b)) * y + magnitude(c)) * y + magnitude(d);
  }
  Quad condition_unit(Quad x) const {
    return Quad(0x1p-52) * (terms(x) / magnitude(slope(x)) + magnitude(x));
  }

  /// The critical points, ascending.
  std::vector<Quad> turns() const {
    if (a == 0) return b == 0 ? std::vector<Quad>{} : std::vector<Quad>{-c / (2 * b)};
    const Quad square = b * b - 3 * a * c;
    if (!(square > 0)) return {};
    const Quad r = square_root(square), q = -(b < 0 ? b - r : b + r);
    const Quad x = q / (3 * a), y = c / q;
    return {std::min(x, y), std::max(x, y)};
  }

  /// −1, 0 or 1; 0 where rounded coefficients might have either sign.
  int robust_sign(Quad x) const {
    const Quad v = (*this)(x);
    if (magnitude(v) <= 16 * Quad(0x1p-52) * terms(x)) return 0;
    return v < 0 ? -1 : 1;
  }
  int sign_beyond(int side) const {  // towards −infinity (−1) or infinity (1)
    for (const auto& [value, even] : {std::pair{a, false}, {b, true}, {c, false}, {d, true}}) {
      if (value != 0) return (value < 0 ? -1 : 1) * (even ? 1 : side);
    }
    return 0;
  }

  /// The only root in (lo, hi), by Newton's method from x. A missing end stands for infinity.
  std::optional<Quad> root_near(Quad x, std::optional<Quad> lo, std::optional<Quad> hi) const {
    for (int i = 0; i < 100; ++i) {
      const Quad v = (*this)(x), s = slope(x);
      if (v == 0) break;
      if (s == 0) return std::nullopt;
      const Quad step = v / s;
      x -= step;
      if (magnitude(step) <= Quad(0x1p-100L) * magnitude(x)) break;
    }
    const bool inside = (!lo || x > *lo) && (!hi || x < *hi);
    return inside ? std::optional(x) : std::nullopt;
  }
};

/// How far the nearest of the roots found is from the one of this piece, in its condition units.
double error_of_piece(const Exact& f, const Roots& found, std::optional<Quad> lo,
                      std::optional<Quad> hi) {
  double least = HUGE_VAL;
  for (int i = 0; i < found.count; ++i) {
    const Quad x = found.x[size_t(i)];
    if (const auto root = f.root_near(x, lo, hi)) {
      const Quad off = magnitude(x - *root);
      least = std::min(least, off == 0 ? 0.0 : double(off / f.condition_unit(*root)));
    }
  }
  return least;
}

bool judge(const Cubic& k, const Roots& found, CubicTally& tally) {
  const Exact f(k);
  bool fine = true;
  for (int i = 0; i < found.count; ++i) {
    const Quad x = found.x[size_t(i)], v = magnitude(f(x));
    const double error = v == 0 ? 0 : double(v / (Quad(0x1p-52) * f.terms(x)));
    tally.worst_value = std::max(tally.worst_value, error);
    const bool invented = !(error <= 16),
               disordered = i > 0 && !(found.x[size_t(i - 1)] < double(x));
    tally.invented += invented, tally.disordered += disordered;
    fine = fine && !invented && !disordered;
  }
  const std::vector<Quad> turns = f.turns();
  int sign = f.sign_beyond(-1);
  std::optional<Quad> lo;
  for (size_t i = 0; i <= turns.size(); ++i) {
    const auto hi = i < turns.size() ? std::optional(turns[i]) : std::nullopt;
    const int next = hi ? f.robust_sign(*hi) : f.sign_beyond(1);
    if (sign * next < 0) {
      const double error = error_of_piece(f, found, lo, hi);
      const bool missed = !(error <= CubicContract::kConditionUnits);
      if (!missed) tally.worst_root = std::max(tally.worst_root, error);
      tally.missed += missed;
      fine = fine && !missed;
    }
    lo = hi, sign = next;
  }
  return fine;
}

}  // namespace

const std::vector<CubicFamily>& cubic_families() {
  static const std::vector<CubicFamily> all{{"three roots in [-1, 1]", three_roots},
                                            {"one root", one_root},
                                            {"foot on a Bezier", foot},
                                            {"two within 1e-12 to 0.1", two_close},
                                            {"three within 1e-12 to 0.1", three_close},
                                            {"exactly double or triple", exactly_double},
                                            {"leading 1e-16 to 0.1", small_lead},
                                            {"coefficients 0 or small", small_ends},
                                            {"coefficients 1e-20 to 1e20", any_cubic_scale},
                                            {"roots 1e-20 to 1e20", scaled_roots}};
  return all;
}

bool CubicTally::passes() const {
  return missed == 0 && invented == 0 && disordered == 0 &&
         worst_root <= CubicContract::kConditionUnits &&
         worst_value <= CubicContract::kConditionUnits;
}

CubicSolver one_by_one(std::string name, Roots (*solve)(double, double, double, double)) {
  return {std::move(name), [solve](std::span<const Cubic> all, std::span<Roots> out) {
            for (std::size_t i = 0; i < out.size(); ++i) {
              const Cubic& k = all[i];
              out[i] = solve(k[0], k[1], k[2], k[3]);
            }
          }};
}

std::vector<CubicSolver> own_cubic_solvers() {
  batch::use_instruction_set(0);  // all of them
  std::vector<CubicSolver> all{one_by_one("scalar", solve_cubic)};
  const auto in_a_batch = [](std::span<const Cubic> cubics, std::span<Roots> out) {
    std::array<std::vector<double>, 4> of;
    for (std::size_t n = 0; n < 4; ++n) {
      for (const Cubic& k : cubics) of[n].push_back(k[n]);
    }
    solve_cubics(of[0], of[1], of[2], of[3], out);
  };
  for (const auto& set : batch::instruction_sets()) {
    all.push_back({set.name, in_a_batch, [id = set.id] { batch::use_instruction_set(id); }});
  }
  return all;
}

CubicTally judge_cubics(const CubicFamily& family, std::size_t count, uint64_t seed,
                        const CubicSolver& solver) {
  constexpr std::size_t kChunk = 1000;
  uint64_t mixed = seed;
  for (const char c : family.name) mixed = (mixed ^ uint64_t(c)) * 0x100000001B3u;
  Random random(mixed);
  CubicTally tally{.family = family.name, .solver = solver.name, .cases = count};
  solver.prepare();
  std::vector<Cubic> cubics;
  std::vector<Roots> found;
  for (std::size_t done = 0; done < count; done += cubics.size()) {
    cubics.resize(std::min(kChunk, count - done)), found.resize(cubics.size());
    for (Cubic& k : cubics) k = family.draw(random);
    solver.solve(cubics, found);
    for (std::size_t i = 0; i < cubics.size(); ++i) {
      if (!judge(cubics[i], found[i], tally) && !tally.fault) tally.fault = cubics[i];
    }
  }
  return tally;
}

std::string cubic_table(const std::vector<CubicTally>& tallies) {
  std::string out =
      fmt::format("{:<28} {:<7} {:>10} {:>7} {:>9} {:>11} {:>11} {:>4}\n", "solve_cubic", "kernel",
                  "cases", "missed", "invented", "worst root", "worst value", "bar");
  for (const CubicTally& t : tallies) {
    out += fmt::format("{:<28} {:<7} {:>10} {:>7} {:>9} {:>11.4g} {:>11.4g} {:>4}", t.family,
                       t.solver, t.cases, t.missed, t.invented, t.worst_root, t.worst_value,
                       CubicContract::kConditionUnits);
    if (t.fault) {
      const auto& [a, b, c, d] = *t.fault;
      out += fmt::format("  MISSED at solve_cubic({}, {}, {}, {})", a, b, c, d);
    }
    out += '\n';
  }
  return out;
}

}  // namespace mien::accuracy
