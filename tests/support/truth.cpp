#include "tests/support/truth.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::test {
namespace {

/// Which layers a square must still be asked about, and what the rest amounts to.
struct Ambiguous {
  std::vector<const TruthLayer*> layers;  // top to bottom
  glm::dvec3 below;
  int undecided = 0;
};

/// Layers that no longer matter are dropped; `undecided` counts those whose outline comes within
/// the radius.
Ambiguous ambiguous(const Ambiguous& outer, glm::dvec2 center, double radius) {
  Ambiguous result{{}, outer.below};
  for (const TruthLayer* layer : outer.layers) {
    const bool near = layer->clearance(center) <= radius;
    if (!near && !layer->inside(center)) continue;
    if (!near && layer->opacity == 1) {
      result.below = layer->rgb;
      break;
    }
    result.layers.push_back(layer);
    result.undecided += near;
  }
  return result;
}

Ambiguous everything(const TruthScene& scene) {
  Ambiguous all{{}, scene.background};
  for (std::size_t i = scene.layers.size(); i-- > 0;) all.layers.push_back(&scene.layers[i]);
  all.undecided = int(all.layers.size());
  return all;
}

glm::dvec3 sample(const Ambiguous& at, glm::dvec2 p) {
  glm::dvec3 sum{0.0};
  double through = 1;
  for (const TruthLayer* layer : at.layers) {
    if (!layer->inside(p)) continue;
    sum += through * layer->opacity * layer->rgb;
    through *= 1 - layer->opacity;
    if (through == 0) break;
  }
  return sum + through * at.below;
}

/// The sum over the grid × grid samples of a square; grid a power of two. Squares that no outline
/// reaches are counted as a whole: the same sum as sample by sample, in time that follows the
/// outline.
glm::dvec3 sum_of_samples(const Ambiguous& outer, glm::dvec2 center, double side, int grid) {
  const Ambiguous at = ambiguous(outer, center, 0.7072 * side);
  if (at.undecided == 0 || grid == 1) return double(grid) * grid * sample(at, center);
  glm::dvec3 sum{0.0};
  for (const double y : {-0.25, 0.25})
    for (const double x : {-0.25, 0.25})
      sum += sum_of_samples(at, center + side * glm::dvec2{x, y}, side / 2, grid / 2);
  return sum;
}

glm::dvec2 to_units(const TruthScene& s, double x, double y) {
  return s.top_left + s.pixel * glm::dvec2{x, s.y_up ? -y : y};
}

}  // namespace

glm::dvec3 truth_pixel(const TruthScene& scene, int x, int y, int grid) {
  return sum_of_samples(everything(scene), to_units(scene, x + 0.5, y + 0.5), scene.pixel, grid) /
         (double(grid) * grid);
}

TruthError compare_with_truth(const Image& image, const TruthScene& scene, int grid, int every) {
  TruthError error;
  const Ambiguous all = everything(scene);
  for (int y = 0; y < image.height; ++y)
    for (int x = y % every; x < image.width; x += every) {
      const glm::dvec2 center = to_units(scene, x + 0.5, y + 0.5);
      const Ambiguous at = ambiguous(all, center, 0.7072 * scene.pixel);
      const glm::dvec3 truth =
          at.undecided == 0 ? sample(at, center)
                            : sum_of_samples(at, center, scene.pixel, grid) / (double(grid) * grid);
      error.edge_pixels += at.undecided > 0;
      double off = 0;
      for (int k = 0; k < 3; ++k)
        off = std::max(off,
                       std::abs(double(image.row(y)[4 * x + k]) - double(std::lround(truth[k]))));
      error.over_one += off > 1;
      if (off > error.worst) {
        error.worst = off;
        error.where =
            fmt::format("({}, {}): truth {} {} {}, drawn {} {} {}", x, y, truth.x, truth.y, truth.z,
                        image.row(y)[4 * x], image.row(y)[4 * x + 1], image.row(y)[4 * x + 2]);
      }
    }
  return error;
}

namespace {

/// Squared distance to a quadratic Bézier by bracketing its stationary points between those of the
/// derivative.
class TruthCurve {
 public:
  TruthCurve(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) : a_(a), d1_(b - a), d2_(a - 2.0 * b + c) {}

  double distance(glm::dvec2 p) const {
    const glm::dvec2 m = a_ - p;
    const double k3 = glm::dot(d2_, d2_), k2 = 3 * glm::dot(d1_, d2_);
    const double k1 = 2 * glm::dot(d1_, d1_) + glm::dot(m, d2_), k0 = glm::dot(m, d1_);
    std::array<double, 4> stops{0, 1, 1, 1};
    int n = 1;
    if (const double disc = k2 * k2 - 3 * k3 * k1; disc > 0 && k3 > 0)
      for (const double t :
           {(-k2 - std::sqrt(disc)) / (3 * k3), (-k2 + std::sqrt(disc)) / (3 * k3)})
        if (t > 0 && t < 1) stops[std::size_t(n++)] = t;
    stops[std::size_t(n)] = 1;
    double best = std::min(squared(p, 0), squared(p, 1));
    for (int i = 0; i < n; ++i) {
      double lo = stops[std::size_t(i)], hi = stops[std::size_t(i) + 1];
      const auto slope = [&](double t) { return ((k3 * t + k2) * t + k1) * t + k0; };
      if (!(slope(lo) <= 0 && slope(hi) >= 0)) continue;
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (lo + hi);
        (slope(middle) > 0 ? hi : lo) = middle;
      }
      best = std::min(best, squared(p, lo));
    }
    return std::sqrt(best);
  }

 private:
  double squared(glm::dvec2 p, double t) const {
    const glm::dvec2 q = a_ + t * (2.0 * d1_ + t * d2_) - p;
    return glm::dot(q, q);
  }
  glm::dvec2 a_, d1_, d2_;
};

double to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 ab = b - a;
  const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::distance(p, a + t * ab);
}

/// The key-shape tables of the source: E4 (A, B, C, D) and E5 (lid control points), blend b in [0,
/// 1].
template <std::size_t N>
std::array<double, N> key_shape(const std::array<std::array<double, N>, 4>& keys, double b) {
  const double s = 3 * std::clamp(b, 0.0, 1.0);
  const int i = std::min(int(s), 2);
  std::array<double, N> out;
  for (std::size_t k = 0; k < N; ++k)
    out[k] =
        keys[std::size_t(i)][k] + (s - i) * (keys[std::size_t(i) + 1][k] - keys[std::size_t(i)][k]);
  return out;
}

constexpr std::array<std::array<double, 4>, 4> kOpenings{
    {{.9, .04, -1, .34}, {.7, .06, -.7, .30}, {.5, .10, -.4, .24}, {.3, .20, -.1, .20}}};
constexpr std::array<std::array<double, 6>, 4> kLids{{{.01, .19, .26, .50, .47, .15},
                                                      {.01, .19, .30, .44, .47, .15},
                                                      {.01, .19, .30, .32, .47, .15},
                                                      {.01, .19, .30, .23, .47, .17}}};

struct Lens {
  std::array<double, 4> k;
  double shift;
  bool inside(glm::dvec2 p) const {
    const double q = (p.x - shift) * 1.8 - 0.42;
    return p.y >= k[0] * q * q + k[1] && p.y <= k[2] * q * q + k[3];
  }
  double clearance(glm::dvec2 p) const {  // the slope is below 5 on the canvas
    const double q = (p.x - shift) * 1.8 - 0.42;
    return std::min(std::abs(p.y - k[0] * q * q - k[1]), std::abs(k[2] * q * q + k[3] - p.y)) / 5.0;
  }
};

TruthLayer stroke(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, double half_width) {
  const TruthCurve curve(a, b, c);
  return {[=](glm::dvec2 p) { return curve.distance(p) <= half_width; },
          [=](glm::dvec2 p) { return std::abs(curve.distance(p) - half_width); }, glm::dvec3{0.0}};
}

}  // namespace

TruthScene eyes_truth(int width, int height, glm::dvec2 gaze, double dilation, double blink) {
  const double pixel = 1.0 / width;
  TruthScene scene{{247, 219, 156}, {}, {0, height * pixel}, pixel, true};
  // The whole canvas [0, 1] × [0, 0.5625] is centred in the picture.
  const double scale = std::min(width / 1.0, height / 0.5625);
  scene.pixel = 1.0 / scale;
  scene.top_left = {0.5 - 0.5 * width / scale, 0.28125 + 0.5 * height / scale};
  for (const bool second : {false, true}) {
    const Lens white{kOpenings[0], second ? 0.53 : 0.0},
        open{key_shape(kOpenings, blink), white.shift};
    scene.layers.push_back(
        {[=](glm::dvec2 p) { return white.inside(p) && open.inside(p); },
         [=](glm::dvec2 p) { return std::min(white.clearance(p), open.clearance(p)); },
         {255, 255, 255}});
    const glm::dvec2 center = glm::dvec2{second ? .76 : .23, .19} + gaze,
                     radii = dilation * glm::dvec2{.09, .105};
    const auto norm = [=](glm::dvec2 p) { return glm::length((p - center) / radii); };
    scene.layers.push_back({[=](glm::dvec2 p) { return norm(p) <= 1 && open.inside(p); },
                            [=](glm::dvec2 p) {
                              return std::min(std::abs(norm(p) - 1) * std::min(radii.x, radii.y),
                                              open.clearance(p));
                            },
                            {0, 0, 0}});
  }
  const auto lid = key_shape(kLids, blink);
  for (const bool second : {false, true}) {
    const auto m = [&](double x, double y) { return glm::dvec2{second ? 1 - x : x, y}; };
    scene.layers.push_back(stroke(m(lid[0], lid[1]), m(lid[2], lid[3]), m(lid[4], lid[5]), .0095));
    scene.layers.push_back(stroke(m(.44, .35), m(.17, .52), m(.03, .41), .0215));
    scene.layers.push_back(stroke(m(.44, .35), m(.14, .61), m(.03, .41), .0255));
  }
  return scene;
}

TruthScene male_truth(int width) {
  TruthScene scene{{255, 255, 255}, {}, {-200, -120}, 400.0 / width, false};
  const auto line = [&](std::vector<glm::dvec2> points, double weight) {
    for (const double side : {1.0, -1.0}) {
      auto at = points;
      for (glm::dvec2& p : at) p.x *= side;
      const auto d = [=](glm::dvec2 p) {
        double nearest = 1e300;
        for (std::size_t i = 1; i < at.size(); ++i)
          nearest = std::min(nearest, to_segment(p, at[i - 1], at[i]));
        return nearest;
      };
      const double half = 2.5 * weight;
      scene.layers.push_back({[=](glm::dvec2 p) { return d(p) <= half; },
                              [=](glm::dvec2 p) { return std::abs(d(p) - half); },
                              glm::dvec3{0.0}});
    }
  };
  line({{40, -34}, {112, -45}, {142, -36}}, 1);
  line({{0, 170}, {30, 170}, {60, 170}, {30, 172}, {0, 172}}, 1);
  line({{50, 5}, {65, -15}, {105, -15}, {120, 5}}, .3);
  line({{0, 115}, {30, 112}}, 1);
  line({{0, 229}, {10, 230}}, 1);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec2 center{82 * side, 0};
    const double r = 13;
    scene.layers.push_back({[=](glm::dvec2 p) {
                              return glm::distance(p, center) <= r && p.y >= -.7 * r &&
                                     p.y <= .94 * r;
                            },
                            [=](glm::dvec2 p) {
                              return std::min({std::abs(glm::distance(p, center) - r),
                                               std::abs(p.y + .7 * r), std::abs(p.y - .94 * r)});
                            },
                            glm::dvec3{0.0}});
  }
  return scene;
}

TruthScene scene_truth(const Scene& scene, int width, int height) {
  const auto encoded = [](const Color& c) {
    const auto in = [](double v) {
      return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
    };
    return glm::dvec3{in(c.r), in(c.g), in(c.b)};
  };
  const Box2& box = scene.canvas().box;
  const double pixel = 1 / std::min(width / box.size().x, height / box.size().y);
  const double half_height = 0.5 * height * pixel;
  TruthScene truth{encoded(scene.background()), {}, {}, pixel, scene.canvas().y_up};
  truth.top_left =
      box.center() + glm::dvec2{-0.5 * width * pixel, truth.y_up ? half_height : -half_height};
  for (const Layer& layer : scene.layers())
    truth.layers.push_back({[=](glm::dvec2 p) { return scene.distance(layer.area, p) <= 0; },
                            [=](glm::dvec2 p) { return std::abs(scene.distance(layer.area, p)); },
                            encoded(layer.paint.color), layer.paint.color.a});
  return truth;
}

}  // namespace mien::test
