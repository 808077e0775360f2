#include "tools/accuracy/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/accuracy/reference.h"
#include "tools/accuracy/timing.h"

namespace mien::accuracy {
namespace {

std::string kernel_of(const Tally& t) {
  return t.instruction_set.empty() ? t.solver : t.solver + " " + t.instruction_set;
}

bool same_row(const Tally& a, const Tally& b) {
  return kernel_of(a) == kernel_of(b) && a.worst_case.figure.index() == b.worst_case.figure.index();
}

std::string text(glm::dvec2 p) {
  return fmt::format("{{{}, {}}}", p.x, p.y);
}
std::string text(const QuadBezier& c) {
  return fmt::format("{{{}, {}, {}}}", text(c.p0), text(c.p1), text(c.p2));
}
std::string text(const CubicBezier& c) {
  return fmt::format("{{{}, {}, {}, {}}}", text(c.p0), text(c.p1), text(c.p2), text(c.p3));
}
std::string text(const Ellipse& e) {
  return fmt::format("{{{}, {}, {}}}", text(e.center), text(e.radii), text(e.axis));
}
std::string text(const ParabolaSide& s) {
  return fmt::format("{{{}, {}, {}}}", text(s.vertex), text(s.axis), s.bend);
}
std::string text(const TaperedStroke& s) {
  const double* w = s.half_width;
  return fmt::format("{{{}, {{{}, {}, {}}}}}", text(s.spine), w[0], w[1], w[2]);
}
/// Every number, so that the case can be pasted into a test.
std::string text(const Case& k) {
  return std::visit([](const auto& f) { return text(f); }, k.figure) + ", " + text(k.p);
}

Tally tally_of(const Family& family, const Solver& solver, const std::vector<Case>& cases,
               const std::vector<Quad>& truths) {
  Tally t{family.name, solver.name, solver.instruction_set};
  t.cases = cases.size(), t.bar = solver.bar, t.worst_case = cases.front();
  std::vector<double> errors(cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    const double found = solver.solve(cases[i]);
    errors[i] = error_units(solver.judge, family.well_conditioned, cases[i], truths[i], found);
    if (std::isinf(errors[i])) {
      ++t.nan;
      if (!t.bad_case) t.bad_case = cases[i];
      continue;
    }
    if (errors[i] > 0 && is_bad(cases[i], truths[i], found)) {
      ++t.bad;
      t.bad_case = cases[i];
    }
    if (errors[i] > t.worst) t.worst = errors[i], t.worst_case = cases[i];
  }
  const auto at = errors.begin() + std::ptrdiff_t(double(errors.size() - 1) * 0.999);
  std::nth_element(errors.begin(), at, errors.end());
  t.p999 = *at;
  return t;
}

}  // namespace

std::vector<Tally> run(const Family& family, const std::vector<Solver>& solvers, size_t count,
                       uint64_t seed, Truth truth) {
  const auto cases = cases_of(family, std::max<size_t>(count, 1), seed);
  const auto judged = [&](const Solver& solver) {
    const bool exact = solver.judge == Judge::exact;
    return solver.figure == cases.front().figure.index() && (family.float_exact || exact) &&
           !(exact && truth == Truth::scalar);
  };
  if (std::none_of(solvers.begin(), solvers.end(), judged)) return {};
  std::vector<Quad> truths;
  truths.reserve(cases.size());
  for (const Case& k : cases) {
    truths.push_back(truth == Truth::scalar ? Quad(scalar_distance(k)) : true_distance(k));
  }
  std::vector<Tally> tallies;
  for (const Solver& solver : solvers) {
    if (!judged(solver)) continue;
    solver.prepare();
    tallies.push_back(tally_of(family, solver, cases, truths));
  }
  return tallies;
}

void measure_times(std::vector<Tally>& tallies, const Family& family,
                   const std::vector<Solver>& solvers, uint64_t seed) {
  const auto cases = cases_of(family, 40, seed);
  for (Tally& t : tallies)
    for (const Solver& solver : solvers)
      if (t.solver == solver.name && t.instruction_set == solver.instruction_set &&
          solver.figure == cases.front().figure.index())
        t.ns = ns_per_point(solver, cases);
}

std::vector<Tally> over_families(const std::vector<Tally>& tallies) {
  std::vector<Tally> rows;
  for (const Tally& t : tallies) {
    auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Tally& r) { return same_row(r, t); });
    if (row == rows.end()) {
      rows.push_back(t);
      continue;
    }
    row->cases += t.cases, row->bad += t.bad, row->nan += t.nan;
    row->p999 = std::max(row->p999, t.p999);
    row->ns = std::max(row->ns, t.ns);
    if (!row->bad_case) row->bad_case = t.bad_case;
    if (t.worst > row->worst) {
      row->worst = t.worst, row->worst_case = t.worst_case, row->family = t.family;
    }
  }
  return rows;
}

std::string table(const std::vector<Tally>& tallies) {
  std::string out = fmt::format("{:<24} {:<16} {:>10} {:>10} {:>10} {:>6} {:>6} {:>6}\n", "family",
                                "kernel", "cases", "worst", "p99.9", "bad", "NaN", "bar");
  for (const Tally& t : tallies) {
    out += fmt::format("{:<24} {:<16} {:>10} {:>10.4g} {:>10.4g} {:>6} {:>6} {:>6.3g}{}\n",
                       t.family, kernel_of(t), t.cases, t.worst, t.p999, t.bad, t.nan, t.bar,
                       t.passes() ? "" : "  MISSED at " + text(t.bad_case.value_or(t.worst_case)));
  }
  return out;
}

std::string csv(const std::vector<Tally>& tallies) {
  std::string out = "family,kernel,instruction_set,cases,worst,p99.9,bad,nan,bar,ns\n";
  for (const Tally& t : tallies) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{:.4g}\n", t.family, t.solver, t.instruction_set,
                       t.cases, t.worst, t.p999, t.bad, t.nan, t.bar, t.ns);
  }
  return out;
}

std::string svg(const std::vector<Tally>& tallies) {
  constexpr double kLeft = 190, kWidth = 620, kRow = 16, kLow = -3, kHigh = 7;
  std::map<std::string, int> rows;
  const auto x_of = [&](double units) {
    const double decades = std::clamp(std::log10(std::max(units, 1e-30)), kLow, kHigh);
    return kLeft + kWidth * (decades - kLow) / (kHigh - kLow);
  };
  std::string marks;
  for (const Tally& t : tallies) {
    const auto [row, is_new] = rows.try_emplace(t.family, int(rows.size()));
    const double y = 40 + kRow * row->second;
    if (is_new) {
      marks += fmt::format("<text x='{}' y='{}' text-anchor='end'>{}</text>\n", kLeft - 8, y + 4,
                           t.family);
    }
    const double units = t.bar > 0 ? t.worst / t.bar : t.worst;
    marks += fmt::format(
        "<circle cx='{:.1f}' cy='{}' r='3.5' fill='{}' fill-opacity='0.6'><title>{}: {:.4g}</title>"
        "</circle>\n",
        x_of(units), y, t.passes() ? "#2a6fbb" : "#cc2222", kernel_of(t), t.worst);
  }
  const double height = 60 + kRow * double(rows.size());
  std::string grid;
  for (int decade = int(kLow); decade <= int(kHigh); ++decade) {
    grid += fmt::format(
        "<line x1='{0:.1f}' x2='{0:.1f}' y1='26' y2='{1}' stroke='{2}'/><text x='{0:.1f}' y='18' "
        "text-anchor='middle'>1e{3}</text>\n",
        x_of(std::pow(10, decade)), height - 20, decade == 0 ? "#000" : "#ddd", decade);
  }
  return fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='{}' font-family='sans-serif' "
      "font-size='11'>\n<rect width='100%' height='100%' fill='#fff'/>\n{}{}"
      "<text x='{}' y='{}'>worst error over its bar (1e0 = the bar); right edge: not a "
      "number</text>"
      "\n</svg>\n",
      kLeft + kWidth + 30, height, grid, marks, kLeft, height - 4);
}

}  // namespace mien::accuracy
