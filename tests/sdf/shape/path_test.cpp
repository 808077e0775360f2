#include <mien/sdf/shape/path.h>

#include "tests/support/bezier_cases.h"
#include "tests/support/shape_laws.h"

namespace mien::test {
namespace {

/// The winding number by the vertical ray upwards (the code takes a horizontal one), roots in
/// binary128.
int winding_upwards(const Path& path, glm::dvec2 p) {
  int count = 0;
  for (const Path::Loop& loop : path.loops)
    for (const QuadBezier& c : loop.sides) {
      const Real a = Real(c.p1.x) - c.p0.x, b = Real(c.p2.x) - c.p1.x - a;
      const Real e = Real(c.p1.y) - c.p0.y, f = Real(c.p2.y) - c.p1.y - e;
      for (const Real t : roots_in({Real(c.p0.x) - p.x, 2 * a, b}, 0, 1)) {
        if (t == 1) continue;  // the next side's
        const Real y = c.p0.y + t * (2 * e + t * f), speed = a + t * b;
        if (y > p.y) count += speed < 0 ? 1 : speed > 0 ? -1 : 0;
      }
    }
  return count;
}

Path::Loop polygon(const std::vector<glm::dvec2>& points) {
  Path::Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 a = points[i], b = points[(i + 1) % points.size()];
    loop.sides.push_back({a, 0.5 * (a + b), b});
  }
  return loop;
}

Path::Loop reversed_loop(const Path::Loop& loop) {
  Path::Loop out;
  for (auto side = loop.sides.rbegin(); side != loop.sides.rend(); ++side)
    out.sides.push_back(reversed(*side));
  return out;
}

const Path::Loop kSquare = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
const Path::Loop kSmallSquare = polygon({{-0.4, -0.4}, {0.4, -0.4}, {0.45, 0.45}, {-0.4, 0.4}});
const Path::Loop kStar = polygon({{0, 1}, {0.6, -0.8}, {-0.95, 0.3}, {0.95, 0.3}, {-0.6, -0.8}});
const Path::Loop kLens{{{{-1, 0.1}, {0, 1}, {1, 0.1}}, {{1, 0.1}, {0.1, -0.7}, {-1, 0.1}}}};
const Path::Loop kBlob{{{{0, -1}, {1.5, -1}, {1, 0}},
                        {{1, 0}, {0.7, 1.2}, {0, 1}},
                        {{0, 1}, {-1.2, 0.7}, {-1, 0}},
                        {{-1, 0}, {-0.4, -1}, {0, -1}}}};
/// A cusp at (0, 1), a side of no length, a side that turns back on itself, collinear neighbours.
const Path::Loop kRough{{{{-1, -1}, {0, -1}, {0.5, -1}},
                         {{0.5, -1}, {0.75, -1}, {1, -1}},
                         {{1, -1}, {0, -0.5}, {0, 1}},
                         {{0, 1}, {0, 1}, {0, 1}},
                         {{0, 1}, {0, -0.5}, {-1, 0}},
                         {{-1, 0}, {-1, -1.6}, {-1, -1}}}};

const std::vector<Path> kPaths = {
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

}  // namespace

template <>
std::vector<Example<Path>> examples() {
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
Path backwards(Path s) {
  for (Path::Loop& loop : s.loops) loop = reversed_loop(loop);
  return s;
}
INSTANTIATE_TYPED_TEST_SUITE_P(Path, ShapeLaws, Path);

TEST(Path, IsTheDistanceToTheNearestSide) {
  Random r(4);
  for (const Path& s : kPaths)
    for (int i = 0; i < 500; ++i) {
      const glm::dvec2 p = r.point(-2, 2);
      Real nearest = 1e9;
      for (const Path::Loop& loop : s.loops)
        for (const QuadBezier& side : loop.sides)
          nearest = std::min(nearest, exact_distance(side, p));
      EXPECT_NEAR(std::abs(distance(s, p)), double(nearest), 16 * 0x1p-52);
    }
}

TEST(Path, WindsRightAtTheHeightOfEveryJoint) {
  Random r(5);
  for (const Path& s : kPaths)
    for (const Path::Loop& loop : s.loops)
      for (const QuadBezier& side : loop.sides)
        for (int i = 0; i < 200; ++i) {
          const glm::dvec2 p{r.between(-2, 2), side.p0.y};
          if (std::abs(distance(s, p)) < 1e-12) continue;
          EXPECT_EQ(winding(s, p), winding_upwards(s, p)) << p.x << ' ' << p.y;
        }
}

TEST(Path, SaysWhereItsDistanceIsABound) {
  const bool simple[] = {true, false, false, true, true, true, false, false, false};
  for (std::size_t i = 0; i < kPaths.size(); ++i) {
    EXPECT_EQ(is_simple(kPaths[i]), simple[i]) << i;
    EXPECT_EQ(exactness(Shape(kPaths[i])), (Exactness{true, simple[i]})) << i;
  }
}

TEST(Path, ClosesALoopThatIsOpen) {
  Path open{{kSquare}, FillRule::nonzero};
  open.loops[0].sides.pop_back();
  EXPECT_EQ(distance(open, {0, 0}), -1);
  EXPECT_DOUBLE_EQ(distance(open, {-1.25, 0}), 0.25);
}

TEST(Path, WithoutSidesIsNowhere) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(distance(Path{}, {0, 0}), inf);
  EXPECT_EQ(distance(Path{{Path::Loop{}}, FillRule::nonzero}, {0, 0}), inf);
  EXPECT_TRUE(bounds(Shape(Path{})).empty());
}

}  // namespace mien::test
