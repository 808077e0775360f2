#include "tests/support/random/degenerate_scene.h"

#include <array>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

constexpr int kSide = 16;  // of the canvas; the lattice has a point every 2 units

class Maker {
 public:
  Maker(std::uint64_t seed, double jitter)
      : r_(seed * 7919 + 11),
        jitter_(jitter),
        build_({.box = {{0, 0}, {kSide, kSide}}, .y_up = r_.chance(0.5)}, color(false)) {
    for (glm::dvec2& p : meeting_points_) p = lattice_point();
  }

  Scene made() {
    for (int i = 0; i < 8; ++i) areas_.push_back(build_.shape(shape()));
    for (int i = 0; i < 9; ++i) {
      combine();
      const Area area = any();
      build_.layer("layer", area, {color(true)});
    }
    return std::move(build_).finish();
  }

 private:
  Color color(bool translucent) {
    const double r = r_.unit(), g = r_.unit(), b = r_.unit();
    return {r, g, b, translucent && r_.chance(0.3) ? r_.unit() : 1.0};
  }

  double shaken(double v) { return jitter_ > 0.0 ? v + jitter_ * r_.between(-1, 1) : v; }

  glm::dvec2 lattice_point() {
    const double x = shaken(2 * r_.below(kSide / 2 + 1));
    return {x, shaken(2 * r_.below(kSide / 2 + 1))};
  }

  /// Most of them one of a few.
  glm::dvec2 point() {
    const glm::dvec2 p = r_.chance(0.6)
                             ? meeting_points_[std::size_t(r_.below(int(meeting_points_.size())))]
                             : lattice_point();
    const double x = shaken(p.x);
    return {x, shaken(p.y)};
  }

  double size(int least, int most, double unit) {
    const int n = least + r_.below(most - least + 1);
    return n == 0 ? 0.0 : shaken(unit * n);
  }

  QuadBezier bow() {
    const glm::dvec2 a = point(), b = point();
    return {a, b, point()};
  }

  Shape shape() {
    const glm::dvec2 p = point();
    switch (r_.below(9)) {
      case 0:
        return Disc{p, size(0, 4, 1.0)};
      case 1: {
        const double a = size(0, 4, 1.0);
        return Ellipse{p, {a, size(1, 4, 1.0)}};
      }
      case 2:
        return Line{p, point(), size(0, 3, 0.5)};
      case 3: {
        const glm::dvec2 a = point(), b = point();
        return Polyline{{p, a, b, point()}, size(1, 3, 0.5)};
      }
      case 4: {
        const QuadBezier spine = bow();
        return QuadStroke{spine, size(1, 3, 0.25)};
      }
      case 5: {
        const QuadBezier spine = bow();
        const double a = size(0, 2, 0.25), b = size(1, 3, 0.25);
        return TaperedStroke{spine, {a, b, size(0, 2, 0.25)}};
      }
      default:
        return path();
    }
  }

  Path path() {
    Path path;
    path.rule = r_.chance(0.5) ? FillRule::nonzero : FillRule::even_odd;
    for (int loops = 1 + r_.below(2); loops > 0; --loops) {
      std::vector<glm::dvec2> corners(std::size_t(3 + r_.below(3)));
      for (glm::dvec2& p : corners) p = point();
      Path::Loop loop;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 a = corners[k], b = corners[(k + 1) % corners.size()];
        loop.sides.push_back({a, r_.chance(0.5) ? 0.5 * (a + b) : point(), b});
      }
      path.loops.push_back(std::move(loop));
    }
    return path;
  }

  Area any() { return areas_[std::size_t(r_.below(int(areas_.size())))]; }

  void combine() {
    const int how = r_.below(6);
    if (how > 2) return;
    const Area a = any(), b = any();
    areas_.push_back(how == 0   ? build_.unite(a, b)
                     : how == 1 ? build_.intersect(a, b)
                                : build_.subtract(a, b));
  }

  Random r_;
  double jitter_;
  SceneBuilder build_;
  std::array<glm::dvec2, 6> meeting_points_;
  std::vector<Area> areas_;
};

}  // namespace

Scene degenerate_scene(std::uint64_t seed, double jitter) {
  return Maker(seed, jitter).made();
}

}  // namespace mien::test
