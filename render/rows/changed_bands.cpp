#include "render/rows/changed_bands.h"
#include "sdf/arrange/sweep.h"

#include <algorithm>
#include <cmath>

namespace mien {

void ChangedBands::find(const PreparedScene& before, const PreparedScene& now,
                        const InCommon& common, const std::vector<int>& same_as) {
  now_.assign(before.outlines.rules.size(), -1);
  for (std::size_t i = 0; i < same_as.size(); ++i) {
    if (same_as[i] < 0)
      add(now.outlines.heights(int(i)));
    else
      now_[std::size_t(same_as[i])] = int(i);
  }
  for (std::size_t i = 0; i < now_.size(); ++i)
    if (now_[i] < 0) add(before.outlines.heights(int(i)));
  // Where nothing was added yet, nothing is inside of outlines that differ: all of them are alike.
  const auto same_step = [&](const AreaStep& a, const AreaStep& b) {
    return a.kind == b.kind &&
           (a.kind != AreaStep::Kind::outline ||
            now_[std::size_t(a.outline)] == (same_as[std::size_t(b.outline)] < 0 ? -1 : b.outline));
  };
  for (std::size_t i = 0; i < now.paints.layers.size(); ++i) {
    const AreaProgram &was = before.paints.layers[i].program, &is = now.paints.layers[i].program;
    const auto a = before.paints.programs.steps(was), b = now.paints.programs.steps(is);
    if (common.layer(i) && std::equal(a.begin(), a.end(), b.begin(), b.end(), same_step)) continue;
    add(reach(before, was)), add(reach(now, is));
  }
}

void ChangedBands::add(const Heights& heights) {
  if (!(heights.first <= heights.second)) return;
  const double last = double(changed_.size()) - 1;
  const auto band = [](double y) { return std::floor(y / Sweep::kBandRows); };
  for (int i = int(std::max(band(heights.first), 0.0)),
           end = int(std::min(band(heights.second), last));
       i <= end; ++i)
    changed_[std::size_t(i)] = 1;
}

ChangedBands::Heights ChangedBands::reach(const PreparedScene& of, const AreaProgram& program) {
  constexpr Heights kNowhere{HUGE_VAL, -HUGE_VAL}, kEverywhere{-HUGE_VAL, HUGE_VAL};
  stack_.clear();
  for (const AreaStep& step : of.paints.programs.steps(program)) {
    using Kind = AreaStep::Kind;
    if (step.kind == Kind::outline) {
      stack_.push_back(of.outlines.heights(step.outline));
    } else if (step.kind == Kind::nothing) {
      stack_.push_back(kNowhere);
    } else if (step.kind == Kind::not_) {
      stack_.back() = kEverywhere;
    } else {
      const Heights b = stack_.back();
      stack_.pop_back();
      const Heights a = stack_.back();
      stack_.back() = step.kind == Kind::and_
                          ? Heights{std::max(a.first, b.first), std::min(a.second, b.second)}
                          : Heights{std::min(a.first, b.first), std::max(a.second, b.second)};
    }
  }
  return stack_.empty() ? kEverywhere : stack_.back();
}

}  // namespace mien
