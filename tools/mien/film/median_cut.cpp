#include "tools/mien/film/median_cut.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

namespace mien::command {
namespace {

constexpr int kLloydSteps = 4;  // more change little

/// A group of colours and what it would gain by a cut.
struct ColorGroup {
  std::size_t begin, end;
  int axis = 0;       // along which it is widest
  double middle = 0;  // there: its mean
  double error = 0;   // count times squared distance to the mean along the axis
  glm::dvec3 mean{0};
};

glm::dvec3 mean_of(std::span<const CountedColor> colors) {
  glm::dvec3 sum{0};
  double count = 0;
  for (const CountedColor& color : colors) {
    sum += double(color.count) * glm::dvec3(color.lab);
    count += color.count;
  }
  return sum / count;
}

ColorGroup group_of(std::span<const CountedColor> colors, std::size_t begin, std::size_t end) {
  ColorGroup group{begin, end};
  group.mean = mean_of(colors.subspan(begin, end - begin));
  glm::dvec3 spread{0};
  for (std::size_t i = begin; i < end; ++i) {
    const glm::dvec3 off = glm::dvec3(colors[i].lab) - group.mean;
    spread += double(colors[i].count) * off * off;
  }
  for (int axis = 1; axis < 3; ++axis)
    if (spread[axis] > spread[group.axis]) group.axis = axis;
  group.error = end - begin > 1 ? spread[group.axis] : 0;
  group.middle = group.mean[group.axis];
  return group;
}

std::vector<ColorGroup> cut_groups(std::vector<CountedColor>& colors, int most) {
  std::vector<ColorGroup> groups{group_of(colors, 0, colors.size())};
  while (int(groups.size()) < most) {
    const auto widest = std::max_element(
        groups.begin(), groups.end(),
        [](const ColorGroup& a, const ColorGroup& b) { return a.error < b.error; });
    const ColorGroup group = *widest;
    if (!(group.error > 0)) break;
    const auto first = colors.begin() + std::ptrdiff_t(group.begin);
    const auto cut = std::partition(
        first, colors.begin() + std::ptrdiff_t(group.end),
        [&](const CountedColor& c) { return double(c.lab[group.axis]) < group.middle; });
    const std::size_t at = std::size_t(cut - colors.begin());
    if (at == group.begin || at == group.end) {  // equal but for rounding
      widest->error = 0;
      continue;
    }
    *widest = group_of(colors, group.begin, at);
    groups.push_back(group_of(colors, at, group.end));
  }
  return groups;
}

/// The nearest of some means.
class NearestMean {
 public:
  explicit NearestMean(const std::vector<glm::dvec3>& means) {
    for (const glm::dvec3& mean : means)
      l_.push_back(float(mean.x)), a_.push_back(float(mean.y)), b_.push_back(float(mean.z));
    far_.resize(means.size());
  }
  std::size_t of(const glm::vec3& lab) {
    for (std::size_t i = 0; i < far_.size(); ++i) {
      const float l = l_[i] - lab.x, a = a_[i] - lab.y, b = b_[i] - lab.z;
      far_[i] = l * l + a * a + b * b;
    }
    return std::size_t(std::min_element(far_.begin(), far_.end()) - far_.begin());
  }

 private:
  std::vector<float> l_, a_, b_, far_;
};

/// One of Lloyd's steps: every mean goes to the middle of what is nearest to it.
void move_means(const std::vector<CountedColor>& colors, std::vector<glm::dvec3>& means) {
  NearestMean nearest(means);
  std::vector<glm::dvec3> sums(means.size(), glm::dvec3(0));
  std::vector<double> counts(means.size(), 0.0);
  for (const CountedColor& color : colors) {
    const std::size_t at = nearest.of(color.lab);
    sums[at] += double(color.count) * glm::dvec3(color.lab);
    counts[at] += color.count;
  }
  for (std::size_t i = 0; i < means.size(); ++i)
    if (counts[i] > 0) means[i] = sums[i] / counts[i];
}

}  // namespace

std::vector<CountedColor> chosen_colors(std::vector<CountedColor>& colors, int most) {
  if (colors.size() <= std::size_t(most)) return colors;
  std::vector<glm::dvec3> means;
  for (const ColorGroup& group : cut_groups(colors, most)) means.push_back(group.mean);
  for (int step = 0; step < kLloydSteps; ++step) move_means(colors, means);

  NearestMean nearest(means);
  std::vector<double> far(means.size(), std::numeric_limits<double>::infinity());
  std::vector<CountedColor> chosen(means.size());
  for (const CountedColor& color : colors) {
    const std::size_t at = nearest.of(color.lab);
    const glm::dvec3 off = glm::dvec3(color.lab) - means[at];
    if (const double distance = glm::dot(off, off); distance < far[at])
      far[at] = distance, chosen[at] = color;
  }
  std::erase_if(chosen, [](const CountedColor& color) { return !(color.count > 0); });
  return chosen;
}

}  // namespace mien::command
