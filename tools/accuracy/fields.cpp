#include "tools/accuracy/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tools/accuracy/reference.h"
#include "tools/accuracy/solver.h"

namespace mien::accuracy {
namespace {

/// Pixels per unit of the case.
double scale_of(const Case& k, FieldSetting setting) {
  return setting.size / size_of(k);
}

}  // namespace

std::vector<FieldSetting> field_settings() {
  return {{16, 16}, {32, 8}, {128, 2}};
}

std::vector<Family> field_families() {
  std::vector<Family> curves;
  for (const Family& family : families()) {
    const Figure figure = cases_of(family, 1, 1).front().figure;
    if (std::holds_alternative<QuadBezier>(figure) || std::holds_alternative<CubicBezier>(figure))
      curves.push_back(family);
  }
  return curves;
}

FieldTally judge_field(FreetypeField& field, FieldSetting setting, const Family& family,
                       std::size_t count, uint64_t seed) {
  FieldTally tally{family.name, setting};
  std::size_t pixels = 0;
  std::clock_t spent = 0;  // of the processor: a field takes milliseconds, and others want it, too
  for (const Case& k : cases_of(family, count, seed)) {
    ++tally.cases;
    if (!FreetypeField::can_draw(k)) continue;
    const double truth = double(true_distance(k)) * scale_of(k, setting);
    if (!(truth < setting.spread - 2 * setting.step())) continue;
    ++tally.within;
    const std::clock_t begin = std::clock();
    const auto found = field.distance(k, setting);
    spent += std::clock() - begin, pixels += field.pixels();
    if (!found) {
      ++tally.silent;
      continue;
    }
    const double error = std::abs(*found - truth) / setting.step();
    tally.worst = std::max(tally.worst, error), tally.mean += error;
  }
  const std::size_t answers = tally.within - tally.silent;
  if (answers > 0) tally.mean /= double(answers);
  if (pixels > 0) tally.ns = double(spent) / CLOCKS_PER_SEC * 1e9 / double(pixels);
  return tally;
}

std::string field_table(const std::vector<FieldTally>& tallies) {
  std::string out =
      fmt::format("{:<24} {:>5} {:>6} {:>6} {:>6} {:>6} {:>8} {:>8} {:>10}\n", "family", "size",
                  "spread", "cases", "within", "silent", "worst", "mean", "ns/pixel");
  for (const FieldTally& t : tallies)
    out += fmt::format("{:<24} {:>5} {:>6} {:>6} {:>6} {:>6} {:>8.3g} {:>8.3g} {:>10.3g}\n",
                       t.family, t.setting.size, t.setting.spread, t.cases, t.within, t.silent,
                       t.worst, t.mean, t.ns);
  return out;
}

std::string field_csv(const std::vector<FieldTally>& tallies) {
  std::string out = "family,size,spread,cases,within,silent,worst,mean,ns\n";
  for (const FieldTally& t : tallies)
    out += fmt::format("\"{}\",{},{},{},{},{},{},{},{:.4g}\n", t.family, t.setting.size,
                       t.setting.spread, t.cases, t.within, t.silent, t.worst, t.mean, t.ns);
  return out;
}

}  // namespace mien::accuracy
