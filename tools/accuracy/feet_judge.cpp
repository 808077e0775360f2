#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "sdf/distance/instruction_sets.h"
#include "tools/accuracy/feet.h"

namespace mien::accuracy {
namespace {

/// Gaps, barriers and slopes below that are rounding, in units of 2⁻⁵² S: twice what two distances may be wrong by.
constexpr double kUndecided = 4 * FeetContract::kDistance;

template <class Figure>
Feet batch_of_one(const Figure& figure, glm::dvec2 p) {
  std::int32_t piece[2];
  double n[2][5];
  const auto spans = [&](int i) {
    return FootSpans{{&piece[i], 1}, {&n[i][0], 1}, {&n[i][1], 1},
                     {&n[i][2], 1},  {&n[i][3], 1}, {&n[i][4], 1}};
  };
  nearest_feet(figure, std::span<const double>{&p.x, 1}, {&p.y, 1}, spans(0), spans(1));
  const auto foot = [&](int i) {
    return Foot{piece[i], n[i][0], n[i][1], {n[i][2], n[i][3]}, n[i][4]};
  };
  return {foot(0), foot(1)};
}

template <class F>
std::span<const F> listed(const std::vector<F>& all) {
  return all;
}
const Ellipse& listed(const Ellipse& e) {
  return e;
}

double reach_of(const QuadBezier& c, glm::dvec2 p) {
  return std::max({glm::distance(c.p0, p), glm::distance(c.p1, p), glm::distance(c.p2, p)});
}
double reach_of(const Line& l, glm::dvec2 p) {
  return std::max(glm::distance(l.a, p), glm::distance(l.b, p)) + l.half_width;
}
double reach_of(const TaperedStroke& s, glm::dvec2 p) {
  const double* w = s.half_width;
  return reach_of(s.spine, p) + std::max({w[0], w[1], w[2]});
}
double reach_of(const Ellipse& e, glm::dvec2 p) {
  return glm::distance(e.center, p) + std::max(e.radii.x, e.radii.y);
}
template <class F>
double reach_of(const std::vector<F>& all, glm::dvec2 p) {
  double most = 0;
  for (const F& one : all) most = std::max(most, reach_of(one, p));
  return most;
}

std::string numbers_of(glm::dvec2 p) {
  return fmt::format("{{{}, {}}}", p.x, p.y);
}
std::string numbers_of(const QuadBezier& c) {
  return fmt::format("{{{}, {}, {}}}", numbers_of(c.p0), numbers_of(c.p1), numbers_of(c.p2));
}
std::string numbers_of(const Line& l) {
  return fmt::format("{{{}, {}, {}}}", numbers_of(l.a), numbers_of(l.b), l.half_width);
}
std::string numbers_of(const TaperedStroke& s) {
  const double* w = s.half_width;
  return fmt::format("{{{}, {{{}, {}, {}}}}}", numbers_of(s.spine), w[0], w[1], w[2]);
}
std::string numbers_of(const Ellipse& e) {
  return fmt::format("{{{}, {}, {}}}", numbers_of(e.center), numbers_of(e.radii),
                     numbers_of(e.axis));
}
template <class F>
std::string numbers_of(const std::vector<F>& all) {
  std::string out = "{";
  for (const F& one : all) out += (out.size() > 1 ? ", " : "") + numbers_of(one);
  return out + "}";
}
std::string numbers_of(const FeetCase& k) {
  return std::visit([](const auto& f) { return numbers_of(f); }, k.figure) + ", " + numbers_of(k.p);
}

/// What one foot is to the truth.
struct Match {
  int which = -1;    ///< of the true feet; −1: none of them is there
  double apart = 0;  ///< along the outline
};
Match match_of(const FeetCase& k, const Foot& foot, const std::vector<TrueFoot>& truth) {
  Match match;
  for (size_t i = 0; i < truth.size(); ++i) {
    // Feet at a joint are at the end of one piece or the beginning of another; coincident ones differ in t.
    const double apart = apart_from(k, foot.piece, foot.t, truth[i]);
    const double odd = truth[i].foot.piece == foot.piece ? std::abs(truth[i].foot.t - foot.t) : 1;
    if (match.which < 0 || apart + 1e-200 * odd < match.apart)
      match = {int(i), apart + 1e-200 * odd};
  }
  return match;
}

double key_of(const FeetCase& k, const Foot& foot) {
  return std::holds_alternative<Ellipse>(k.figure) ? std::abs(foot.distance) : foot.distance;
}

class Judging {
 public:
  Judging(const FeetCase& k, const Feet& found, const std::vector<TrueFoot>& truth, FeetTally& to)
      : k_(k), found_(found), truth_(truth), to_(to), unit_(feet_unit(k)) {}

  void run() {
    ++to_.cases;
    const double best = double(truth_.front().key);
    if (!is_foot(found_.nearest) ||
        !(std::abs(key_of(k_, found_.nearest) - best) <= kUndecided * unit_)) {
      fail(to_.wrong);
      return;
    }
    const Match near = match_of(k_, found_.nearest, truth_);
    measure(found_.nearest, near);
    judge_next(near.which);
  }

 private:
  void fail(size_t& counter) {
    if (to_.wrong + to_.wrong_next == 0) to_.wrong_case = k_;
    ++counter;
  }
  bool is_foot(const Foot& foot) const {
    if (foot.piece < 0 || !std::isfinite(foot.distance)) return false;
    const Match match = match_of(k_, foot, truth_);
    const double off = std::abs(double(truth_[match.which].key) - key_of(k_, foot));
    // Beside a true foot, or so nearly one that rounding decides.
    if (off <= kUndecided * unit_ && match.apart <= 1e-3 * unit_ * 0x1p52) return true;
    return is_nearly_foot(k_, foot.piece, foot.t, kUndecided * unit_);
  }
  void judge_next(int near) {
    const TrueFoot* next = nullptr;
    for (size_t i = 0; i < truth_.size() && !next; ++i)
      if (int(i) != near && double(truth_[i].barrier) > kUndecided * unit_) next = &truth_[i];
    const bool is_there = found_.next.piece >= 0;
    if (next) ++to_.with_next;
    if (!is_there && !next) return;
    if (!is_there || !is_foot(found_.next)) return fail(to_.wrong_next);
    const double key = key_of(k_, found_.next);
    if (next && key - double(next->key) > kUndecided * unit_) return fail(to_.wrong_next);
    const Match match = match_of(k_, found_.next, truth_);
    // The same foot twice.
    const bool is_same = std::abs(found_.next.t - found_.nearest.t) < 0x1p-30;
    if (match.which == near && found_.next.piece == found_.nearest.piece && is_same)
      return fail(to_.wrong_next);
    // What is nearly a foot has no true one to be measured by.
    const double off = std::abs(key - double(truth_[match.which].key));
    if (match.which != near && off <= kUndecided * unit_) measure(found_.next, match);
  }
  void measure(const Foot& foot, const Match& match) {
    const TrueFoot& truth = truth_[match.which];
    const double off = std::abs(key_of(k_, foot) - double(truth.key)) / unit_;
    const bool may_be_end = truth.from_end < kUndecided * unit_;
    const double bend = std::max(std::abs(truth.foot.bend), may_be_end ? 1 / truth.reach : 0);
    const double slack = bend + 1 / std::max(truth.reach, truth.speed);
    // Where moving the place by a few units turns the normal by more than that nothing can be asked.
    constexpr double kLevel = 0x1p-16;
    double turned = glm::length(foot.normal - truth.foot.normal);
    // On the figure itself either side is right.
    const bool is_on = truth.reach < kUndecided * unit_;
    if (is_on) turned = std::min(turned, glm::length(foot.normal - truth.mirrored));
    turned /= unit_ * slack;
    const bool asks = unit_ * slack < kLevel;
    if (off > to_.distance || (asks && turned > to_.normal)) to_.worst_case = k_;
    to_.distance = std::max(to_.distance, off);
    if (asks) to_.normal = std::max(to_.normal, turned);
  }

  const FeetCase& k_;
  const Feet& found_;
  const std::vector<TrueFoot>& truth_;
  FeetTally& to_;
  const double unit_;
};

std::string feet_kernel_of(const FeetTally& t) {
  return t.instruction_set.empty() ? t.solver : t.solver + " " + t.instruction_set;
}

}  // namespace

double feet_unit(const FeetCase& k) {
  return 0x1p-52 * std::visit([&](const auto& f) { return reach_of(f, k.p); }, k.figure);
}

std::vector<FeetSolver> own_feet_solvers() {
  std::vector<FeetSolver> all{
      {"scalar", "", [](const FeetCase& k) {
         return std::visit([&](const auto& f) { return nearest_feet(listed(f), k.p); }, k.figure);
       }}};
  for (const auto& set : batch::instruction_sets())
    all.push_back({"batch", set.name,
                   [](const FeetCase& k) {
                     return std::visit([&](const auto& f) { return batch_of_one(listed(f), k.p); },
                                       k.figure);
                   },
                   false, [id = set.id] { batch::use_instruction_set(id); }});
  return all;
}

FeetSolver foreign_feet_solver(const std::string& path) {
  using Solve = void(const double*, const double*, const double*, double*, size_t);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  auto* solve = reinterpret_cast<Solve*>(dlsym(library, "mien_accuracy_feet"));
  if (!solve) throw std::runtime_error(path + ": has no function mien_accuracy_feet");
  const auto ask = [solve](const FeetCase& k) {
    const QuadBezier& c = std::get<std::vector<QuadBezier>>(k.figure).front();
    const double curve[6] = {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y};
    double n[10];
    std::fill(std::begin(n), std::end(n), std::numeric_limits<double>::quiet_NaN());
    solve(curve, &k.p.x, &k.p.y, n, 1);
    const auto foot = [](const double* f) {
      const bool is_there =
          f[1] < std::numeric_limits<double>::infinity() && f[0] >= 0 && f[0] <= 1;
      return is_there ? Foot{0, f[0], f[1], {f[2], f[3]}, f[4]} : Foot{};
    };
    return Feet{foot(n), foot(n + 5)};
  };
  return {path.substr(path.find_last_of('/') + 1), "", ask, true};
}

std::vector<FeetTally> judge_feet(const FeetFamily& family, const std::vector<FeetSolver>& solvers,
                                  size_t count, uint64_t seed) {
  const auto cases = feet_cases_of(family, std::max<size_t>(count, 1), seed);
  const auto* curves = std::get_if<std::vector<QuadBezier>>(&cases.front().figure);
  const bool is_one_curve = curves && curves->size() == 1;
  std::vector<std::vector<TrueFoot>> truths;
  for (const FeetCase& k : cases) truths.push_back(true_feet(k));
  std::vector<FeetTally> tallies;
  for (const FeetSolver& solver : solvers) {
    if (solver.only_one_curve && !is_one_curve) continue;
    solver.prepare();
    FeetTally tally{family.name, solver.name, solver.instruction_set};
    tally.worst_case = tally.wrong_case = cases.front();
    for (size_t i = 0; i < cases.size(); ++i)
      Judging(cases[i], solver.solve(cases[i]), truths[i], tally).run();
    tallies.push_back(tally);
  }
  return tallies;
}

std::vector<FeetTally> over_feet_families(const std::vector<FeetTally>& tallies) {
  std::vector<FeetTally> rows;
  for (const FeetTally& t : tallies) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const FeetTally& r) {
      return feet_kernel_of(r) == feet_kernel_of(t);
    });
    if (row == rows.end()) {
      rows.push_back(t);
      continue;
    }
    if (row->wrong + row->wrong_next == 0) row->wrong_case = t.wrong_case;
    row->cases += t.cases, row->wrong += t.wrong, row->wrong_next += t.wrong_next,
        row->with_next += t.with_next;
    if (t.normal > row->normal) row->family = t.family, row->worst_case = t.worst_case;
    row->distance = std::max(row->distance, t.distance),
    row->normal = std::max(row->normal, t.normal);
  }
  return rows;
}

std::string feet_table(const std::vector<FeetTally>& tallies) {
  std::string out =
      fmt::format("{:<26} {:<14} {:>9} {:>9} {:>7} {:>7} {:>10} {:>10}\n", "family", "solver",
                  "cases", "with next", "wrong", "next", "distance", "normal");
  for (const FeetTally& t : tallies)
    out += fmt::format(
        "{:<26} {:<14} {:>9} {:>9} {:>7} {:>7} {:>10.4g} {:>10.4g}{}\n", t.family,
        feet_kernel_of(t), t.cases, t.with_next, t.wrong, t.wrong_next, t.distance, t.normal,
        t.passes()
            ? ""
            : "  MISSED at " + numbers_of(t.wrong + t.wrong_next ? t.wrong_case : t.worst_case));
  return out;
}

std::string feet_csv(const std::vector<FeetTally>& tallies) {
  std::string out =
      "family,solver,instruction_set,cases,with_next,wrong,wrong_next,distance,normal\n";
  for (const FeetTally& t : tallies)
    out += fmt::format("{},{},{},{},{},{},{},{},{}\n", t.family, t.solver, t.instruction_set,
                       t.cases, t.with_next, t.wrong, t.wrong_next, t.distance, t.normal);
  return out;
}

}  // namespace mien::accuracy
