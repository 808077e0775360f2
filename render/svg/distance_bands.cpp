#include "render/svg/distance_bands.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mien {
namespace {

/// Levels of the distance, rising, and the colours before, between and beyond them.
struct ColorSteps {
  std::vector<double> levels;
  std::vector<Mix> mixes;  ///< one more
};

ColorSteps color_steps(const DistanceGradient& along, const Ramp& ramp) {
  const auto distance = [&](double t) { return along.from + t * (along.to - along.from); };
  ColorSteps steps{{}, {ramp.mixes().front()}};
  const auto add = [&](double t, const Mix& beyond) {
    steps.levels.push_back(distance(t));
    steps.mixes.push_back(beyond);
  };
  for (std::size_t i = 1; i < ramp.at().size(); ++i) {
    const double a = ramp.at()[i - 1], length = ramp.at()[i] - a;
    const Mix &from = ramp.mixes()[i - 1], by = ramp.mixes()[i] - from;
    if (!(length > 0.0)) continue;
    const int count = std::max(1, int(std::ceil(largest(by) / kBandStep)));
    for (int k = 0; k < count; ++k) add(a + length * k / count, from + (k + 0.5) / count * by);
  }
  add(ramp.at().back(), ramp.mixes().back());
  if (along.to < along.from) {
    std::reverse(steps.levels.begin(), steps.levels.end());
    std::reverse(steps.mixes.begin(), steps.mixes.end());
  }
  return steps;
}

/// The colour that makes `wanted` when it is laid over `below`, if there is one.
std::optional<Mix> laid_over(const Mix& below, const Mix& wanted) {
  constexpr double kRounding = 1e-9;
  const double a = below.a < 1.0    ? (wanted.a - below.a) / (1.0 - below.a)
                   : wanted.a < 1.0 ? -1.0
                                    : 1.0;
  Mix p = wanted - (1.0 - a) * below;
  p.a = a;
  for (int i = 0; i < 4; ++i)
    if (!(p[i] >= -kRounding && p[i] <= p.a + kRounding && p.a <= 1.0 + kRounding)) return {};
  return p;
}

/// Each step on top of those before it; `mixes` in that order.
std::optional<std::vector<Mix>> laid_mixes(const std::vector<Mix>& mixes) {
  std::vector<Mix> laid;
  Mix below{0.0};
  for (const Mix& wanted : mixes) {
    const auto mix = laid_over(below, wanted);
    if (!mix) return {};
    laid.push_back(*mix);
    below = wanted;
  }
  return laid;
}

DistanceBands nested(const Area& area, const ColorSteps& steps, const std::vector<Mix>& laid,
                     bool inwards) {
  DistanceBands made;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    DistanceBand band{{}, laid[i]};
    const std::size_t level = inwards ? steps.levels.size() - i : i - 1;
    if (i > 0) band.within.push_back({area, steps.levels[level], !inwards});
    made.bands.push_back(band);
  }
  return made;
}

DistanceBands side_by_side(const Area& area, const ColorSteps& steps) {
  DistanceBands made;
  for (std::size_t i = 0; i < steps.mixes.size(); ++i) {
    DistanceBand band{{}, steps.mixes[i]};
    if (i > 0) band.within.push_back({area, steps.levels[i - 1], true});
    if (i < steps.levels.size()) band.within.push_back({area, steps.levels[i]});
    made.bands.push_back(band);
  }
  return made;
}

}  // namespace

DistanceBands distance_bands(const DistanceGradient& along, const Ramp& ramp) {
  ColorSteps steps = color_steps(along, ramp);
  double opacity = 1.0;
  if (ramp.least_opacity() == ramp.most_opacity() && ramp.most_opacity() > 0.0) {
    opacity = ramp.most_opacity();
    for (Mix& mix : steps.mixes) mix /= opacity, mix.a = 1.0;
  }
  DistanceBands made;
  const std::vector<Mix> from_outside(steps.mixes.rbegin(), steps.mixes.rend());
  if (const auto inwards = laid_mixes(from_outside))
    made = nested(along.area, steps, *inwards, true);
  else if (const auto outwards = laid_mixes(steps.mixes))
    made = nested(along.area, steps, *outwards, false);
  else
    made = side_by_side(along.area, steps);
  std::erase_if(made.bands, [](const DistanceBand& band) { return !(band.mix.a > 0.0); });
  made.opacity = opacity;
  return made;
}

}  // namespace mien
