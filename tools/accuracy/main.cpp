// mien-accuracy: how right are distances to curves? Runs every family of nasty cases on
// every kernel and instruction set (and on your solver) against a reference of 113 bits.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tools/accuracy/cubics.h"
#include "tools/accuracy/export.h"
#include "tools/accuracy/feet.h"
#include "tools/accuracy/fields.h"
#include "tools/accuracy/methods/published.h"
#include "tools/accuracy/tally.h"

namespace {

using namespace mien::accuracy;

struct Options {
  size_t count = 20'000;
  uint64_t seed = 1;
  std::vector<std::string> solvers, families, kernels;
  std::string csv, plot, exported;
  bool only_foreign = false, by_family = false, cubics = false, quick = false;
  bool published = false, times = false, fields = false, feet = false;
};

bool write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) fmt::print(stderr, "{}: cannot be written\n", path);
  return bool(file);
}

bool wanted(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Refuses unknown names, which would otherwise give an empty table that passes.
template <class All>
void require_names(const std::string& what, const std::vector<std::string>& names, const All& all) {
  for (const std::string& name : names) {
    const auto is_it = [&](const auto& one) { return one.name == name; };
    if (std::any_of(all.begin(), all.end(), is_it)) continue;
    std::string known;
    for (const auto& one : all) {
      const std::string quoted = "'" + one.name + "'";
      if (known.find(quoted) == std::string::npos) known += (known.empty() ? "" : ", ") + quoted;
    }
    throw std::runtime_error(fmt::format("no {} is named '{}'; there are {}", what, name, known));
  }
}

int export_cases(const Options& options) {
  require_names("family of curves", options.families, bezier_families());
  std::ofstream file(options.exported, std::ios::binary);
  write_cases_header(file, options.seed);
  for (const Family& family : bezier_families()) {
    if (wanted(options.families, family.name))
      write_cases(file, family, options.count, options.seed);
  }
  file.close();
  if (!file) return fmt::print(stderr, "{}: cannot be written\n", options.exported), 1;
  return 0;
}

int export_feet(const Options& options) {
  require_names("family of feet", options.families, feet_families());
  std::ofstream file(options.exported, std::ios::binary);
  write_feet_header(file, options.seed);
  for (const FeetFamily& family : feet_families())
    if (wanted(options.families, family.name))
      write_feet(file, family, options.count, options.seed);
  file.close();
  if (!file) return fmt::print(stderr, "{}: cannot be written\n", options.exported), 1;
  return 0;
}

int judge_cubics(const Options& options) {
  require_names("family of cubics", options.families, cubic_families());
  require_names("kernel for cubics", options.kernels, own_cubic_solvers());
  std::vector<CubicTally> tallies;
  for (const CubicFamily& family : cubic_families()) {
    if (!wanted(options.families, family.name)) continue;
    for (const CubicSolver& solver : own_cubic_solvers()) {
      if (!wanted(options.kernels, solver.name)) continue;
      tallies.push_back(judge_cubics(family, options.count, options.seed, solver));
    }
    fmt::print(stderr, "{}\n", family.name);
  }
  fmt::print("{}", cubic_table(tallies));
  const auto passes = [](const CubicTally& t) { return t.passes(); };
  return std::all_of(tallies.begin(), tallies.end(), passes) ? 0 : 2;
}

int judge_fields(const Options& options) {
  require_names("family of curves", options.families, field_families());
  FreetypeField field;
  std::vector<FieldTally> tallies;
  for (const Family& family : field_families()) {
    if (!wanted(options.families, family.name)) continue;
    for (const FieldSetting& setting : field_settings())
      tallies.push_back(judge_field(field, setting, family, options.count, options.seed));
    fmt::print(stderr, "{}\n", family.name);
  }
  fmt::print("{}", field_table(tallies));
  return options.csv.empty() || write_file(options.csv, field_csv(tallies)) ? 0 : 1;
}

int judge_feet(const Options& options) {
  require_names("family of feet", options.families, feet_families());
  std::vector<FeetSolver> solvers;
  if (!options.only_foreign) solvers = own_feet_solvers();
  for (const std::string& path : options.solvers) solvers.push_back(foreign_feet_solver(path));
  std::vector<FeetTally> tallies;
  for (const FeetFamily& family : feet_families()) {
    if (!wanted(options.families, family.name)) continue;
    const auto rows = judge_feet(family, solvers, options.count, options.seed);
    tallies.insert(tallies.end(), rows.begin(), rows.end());
    fmt::print(stderr, "{}\n", family.name);
  }
  if (options.by_family) fmt::print("{}\n", feet_table(tallies));
  fmt::print("{}", feet_table(over_feet_families(tallies)));
  if (!options.csv.empty() && !write_file(options.csv, feet_csv(tallies))) return 1;
  const auto own_passes = [](const FeetTally& t) {
    return (t.solver != "scalar" && t.solver != "batch") || t.passes();
  };
  return std::all_of(tallies.begin(), tallies.end(), own_passes) ? 0 : 2;
}

int judge(const Options& options) {
  require_names("family", options.families, families());
  require_names("kernel", options.kernels, own_solvers());
  std::vector<Solver> solvers;
  if (!options.only_foreign) solvers = own_solvers();
  if (!options.kernels.empty()) {
    std::erase_if(solvers, [&](const Solver& s) {
      return std::find(options.kernels.begin(), options.kernels.end(), s.name) ==
             options.kernels.end();
    });
  }
  if (options.published)
    for (const Solver& method : published_methods()) solvers.push_back(method);
  for (const std::string& path : options.solvers) solvers.push_back(foreign_solver(path));
  std::vector<Tally> tallies;
  for (const Family& family : families()) {
    if (!wanted(options.families, family.name)) continue;
    auto rows = run(family, solvers, options.count, options.seed,
                    options.quick ? Truth::scalar : Truth::binary128);
    if (options.times) measure_times(rows, family, solvers, options.seed);
    tallies.insert(tallies.end(), rows.begin(), rows.end());
    fmt::print(stderr, "{}\n", family.name);
  }
  if (options.by_family) fmt::print("{}\n", table(tallies));
  fmt::print("Over all families (seed {}; family: where it is worst)\n{}", options.seed,
             table(over_families(tallies)));
  if (!options.csv.empty() && !write_file(options.csv, csv(tallies))) return 1;
  if (!options.plot.empty() && !write_file(options.plot, svg(tallies))) return 1;
  return std::all_of(tallies.begin(), tallies.end(), [](const Tally& t) { return t.passes(); }) ? 0
                                                                                                : 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("How right are distances to Bezier curves, conics and strokes?", "mien-accuracy");
  app.add_option("--count", options.count, "Cases per family")->capture_default_str();
  app.add_option("--seed", options.seed, "Another seed, other cases")->capture_default_str();
  app.add_option("--family", options.families, "Only these families");
  app.add_option("--kernel", options.kernels, "Only these of mien's kernels (fast, accurate, …)");
  app.add_option("--solver", options.solvers,
                 "A shared library with mien_accuracy_solve (see solver.h)");
  app.add_flag("--published", options.published,
               "Judge methods that others have published, too (docs/solvers.md)");
  app.add_flag("--times", options.times,
               "Measure nanoseconds per point on quadratic curves, for --csv");
  app.add_flag("--quick", options.quick,
               "Measure float kernels alone, against the scalar form: for many cases");
  app.add_flag("--only-solver", options.only_foreign, "Leave mien's own kernels out");
  app.add_flag("--by-family", options.by_family, "Print a row per family too");
  app.add_flag("--cubics", options.cubics,
               "Judge solve_cubic and solve_cubics, on families of their own, instead");
  app.add_flag("--fields", options.fields,
               "Judge the distance fields of FreeType's rasteriser instead (docs/solvers.md)");
  app.add_flag("--feet", options.feet,
               "Judge feet instead: nearest branch, runner-up, distance and normal");
  app.add_option("--csv", options.csv, "Write the table as comma-separated values");
  app.add_option("--plot", options.plot, "Draw the table as SVG");
  app.add_option("--export", options.exported, "Write the cases and their true distances instead");
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.cubics) return judge_cubics(options);
    if (options.fields) return judge_fields(options);
    if (options.feet) return options.exported.empty() ? judge_feet(options) : export_feet(options);
    return options.exported.empty() ? judge(options) : export_cases(options);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "mien-accuracy: {}\n", problem.what());
    return 1;
  }
}
