#pragma once
// Paths filled by the nonzero rule whose sides cross, touch or lie on each other.

#include <mien/shape.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/shapes/shape_examples/path.h"

namespace mien::test {

struct NamedPath {
  std::string name;
  Path path;
  bool hides;  ///< some side, or a part of one, is no outline
};

inline Path::Loop pentagram(double reach) {
  std::vector<glm::dvec2> points;
  for (int k = 0; k < 5; ++k) {
    const double turn = 4 * std::numbers::pi * k / 5;
    points.push_back(reach * glm::dvec2{std::sin(turn), std::cos(turn)});
  }
  return polygon(points);
}

inline Path::Loop box(glm::dvec2 lo, glm::dvec2 hi) {
  return polygon({lo, {hi.x, lo.y}, hi, {lo.x, hi.y}});
}

/// A smooth closed curve between bends.
inline Path::Loop smooth(const std::vector<glm::dvec2>& bends) {
  Path::Loop loop;
  const std::size_t n = bends.size();
  for (std::size_t i = 0; i < n; ++i)
    loop.sides.push_back({0.5 * (bends[(i + n - 1) % n] + bends[i]), bends[i],
                          0.5 * (bends[i] + bends[(i + 1) % n])});
  return loop;
}

inline Path::Loop round(glm::dvec2 center, double reach) {
  std::vector<glm::dvec2> bends;
  for (int k = 0; k < 6; ++k) {
    const double turn = std::numbers::pi * k / 3;
    bends.push_back(center + reach * glm::dvec2{std::cos(turn), std::sin(turn)});
  }
  return smooth(bends);
}

inline std::vector<NamedPath> overlapping_paths() {
  const Path::Loop low = box({-0.75, -0.7}, {0.25, 0.3}), high = box({-0.2, -0.25}, {0.7, 0.65}),
                   lobe = {{{{-0.6, 0.3}, {-0.6, -0.15}, {-0.6, -0.6}},
                            {{-0.6, -0.6}, {0.6, -0.6}, {0.6, 0.6}},
                            {{0.6, 0.6}, {-0.9, 0.8}, {-0.35, -0.05}},
                            {{-0.35, -0.05}, {0.2, -0.9}, {0.55, -0.4}},
                            {{0.55, -0.4}, {0.9, 0.1}, {-0.6, 0.3}}}};
  const std::vector<glm::dvec2> eight = {{-0.8, -0.6}, {0.8, 0.6}, {0.8, -0.6}, {-0.8, 0.6}};
  return {
      {"pentagram", {{pentagram(0.8)}}, true},
      {"pentagram, backwards", {{reversed_loop(pentagram(0.8))}}, true},
      {"two alike", {{low, high}}, true},
      {"two against each other", {{low, reversed_loop(high)}}, false},
      {"three", {{round({-0.3, -0.2}, 0.5), round({0.3, -0.2}, 0.5), round({0, 0.3}, 0.5)}}, true},
      {"a lobe", {{lobe}}, true},
      {"an eight", {{smooth(eight)}}, false},
      {"touching in a point", {{box({-0.7, -0.7}, {0, 0}), box({0, 0}, {0.7, 0.7})}}, false},
      {"a corner on a side",
       {{box({-0.7, -0.5}, {0.1, 0.5}), polygon({{0.1, 0.1}, {0.7, -0.3}, {0.7, 0.5}})}},
       false},
      {"side on side", {{box({-0.8, -0.4}, {0, 0.4}), box({0, -0.4}, {0.6, 0.2})}}, true},
      {"one in the other", {{box({-0.7, -0.7}, {0.7, 0.7}), box({-0.2, -0.2}, {0.4, 0.4})}}, true},
      {"a hole at the side",
       {{box({-0.7, -0.7}, {0.7, 0.7}), reversed_loop(box({-0.3, -0.7}, {0.3, 0}))}},
       true},
      {"twice the same", {{round({0, 0}, 0.7), round({0, 0}, 0.7)}}, true},
      {"a spur",
       {{polygon(
           {{-0.6, -0.6}, {0.6, -0.6}, {0.6, 0}, {0.9, 0}, {0.6, 0}, {0.6, 0.6}, {-0.6, 0.6}})}},
       true},
      {"a slit",
       {{polygon(
           {{-0.6, -0.6}, {0.6, -0.6}, {0.6, 0}, {0.1, 0}, {0.6, 0}, {0.6, 0.6}, {-0.6, 0.6}})}},
       true},
      {"a bend on its side",
       {{box({-0.7, -0.6}, {0.7, 0}),
         {{{{-0.5, -0.3}, {0, 0.9}, {0.5, -0.3}}, {{0.5, -0.3}, {0, -0.3}, {-0.5, -0.3}}}}}},
       false},
      {"bends on each other",
       {{{{{{-0.7, 0}, {0, 1}, {0.7, 0}}, {{0.7, 0}, {0, -0.4}, {-0.7, 0}}}},
         {{{{0.7, 0}, {0, 1}, {-0.7, 0}}, {{-0.7, 0}, {0, 1.6}, {0.7, 0}}}}}},
       true},
  };
}

}  // namespace mien::test
