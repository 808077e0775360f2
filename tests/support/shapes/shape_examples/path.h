#pragma once
#include "sdf/shape/curve/path.h"

#include <algorithm>
#include <cmath>

#include "tests/support/shapes/shape_example.h"
#include "tests/support/shapes/winding_upwards.h"

namespace mien::test {

inline Path::Loop polygon(const std::vector<glm::dvec2>& points) {
  Path::Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 a = points[i], b = points[(i + 1) % points.size()];
    loop.sides.push_back({a, 0.5 * (a + b), b});
  }
  return loop;
}

inline Path::Loop reversed_loop(const Path::Loop& loop) {
  Path::Loop out;
  for (auto side = loop.sides.rbegin(); side != loop.sides.rend(); ++side)
    out.sides.push_back(reversed(*side));
  return out;
}

inline const Path::Loop kSquare = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
inline const Path::Loop kSmallSquare =
    polygon({{-0.4, -0.4}, {0.4, -0.4}, {0.45, 0.45}, {-0.4, 0.4}});
inline const Path::Loop kStar =
    polygon({{0, 1}, {0.6, -0.8}, {-0.95, 0.3}, {0.95, 0.3}, {-0.6, -0.8}});
inline const Path::Loop kLens{{{{-1, 0.1}, {0, 1}, {1, 0.1}}, {{1, 0.1}, {0.1, -0.7}, {-1, 0.1}}}};
inline const Path::Loop kBlob{{{{0, -1}, {1.5, -1}, {1, 0}},
                               {{1, 0}, {0.7, 1.2}, {0, 1}},
                               {{0, 1}, {-1.2, 0.7}, {-1, 0}},
                               {{-1, 0}, {-0.4, -1}, {0, -1}}}};
/// A cusp at (0, 1), a side of no length, a side that turns back on itself, collinear neighbours.
inline const Path::Loop kRough{{{{-1, -1}, {0, -1}, {0.5, -1}},
                                {{0.5, -1}, {0.75, -1}, {1, -1}},
                                {{1, -1}, {0, -0.5}, {0, 1}},
                                {{0, 1}, {0, 1}, {0, 1}},
                                {{0, 1}, {0, -0.5}, {-1, 0}},
                                {{-1, 0}, {-1, -1.6}, {-1, -1}}}};

inline const std::vector<Path> kPaths = {
    {{kSquare}, FillRule::nonzero},
    {{kStar}, FillRule::nonzero},
    {{kStar}, FillRule::even_odd},
    {{kLens}, FillRule::nonzero},
    {{kBlob, reversed_loop(kSmallSquare)}, FillRule::nonzero},
    {{kBlob, kSmallSquare}, FillRule::even_odd},
    {{kBlob, kSmallSquare}, FillRule::nonzero},
    {{kRough}, FillRule::nonzero},
    {{kLens, kSquare, kRough}, FillRule::even_odd},
};

template <>
inline std::vector<Example<Path>> examples() {
  std::vector<Example<Path>> all;
  for (const Path& s : kPaths)
    all.push_back(
        {s, [s](glm::dvec2 p) { return is_inside(s.rule, winding_upwards(s, p)) ? 1.0 : -1.0; },
         1.8});
  const Path flat{{polygon({{-1, 0}, {1, 0.5}})}, FillRule::nonzero};  // there and back: no inside
  all.push_back({flat, [](glm::dvec2) { return -1.0; }, 1.8, true});
  return all;
}
template <>
inline Path backwards(Path s) {
  for (Path::Loop& loop : s.loops) loop = reversed_loop(loop);
  return s;
}

}  // namespace mien::test
