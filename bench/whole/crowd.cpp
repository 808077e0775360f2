#include "bench/whole/crowd.h"

#include <array>
#include <cmath>
#include <random>
#include <string>

#ifdef MIEN_HAVE_TEXT
#include <mien/text_path.h>
#endif

namespace mien::bench {
namespace {

constexpr int kSteps = 100;
constexpr double kShrink = 1e-5;

constexpr Crowd kCrowds[] = {
    Crowd::discs,
    Crowd::translucent,
    Crowd::strokes,
#ifdef MIEN_HAVE_TEXT
    Crowd::text,
#endif
};

/// Random numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}

  double number(double lo, double hi) { return lo + (hi - lo) * double(random_()) / 4294967296.0; }
  glm::dvec2 place() {
    const double x = number(0, kCrowdSide);
    return {x, number(0, kCrowdSide)};
  }
  glm::dvec2 way(double length) {
    const double angle = number(0, 6.283185307179586);
    return length * glm::dvec2{std::cos(angle), std::sin(angle)};
  }
  Color color(double opacity) {
    const double r = number(0, 1), g = number(0, 1);
    return {r, g, number(0, 1), opacity};
  }

 private:
  std::mt19937 random_;
};

Disc disc(Dice& dice, double by) {
  const glm::dvec2 at = dice.place();
  return {by * at, by * dice.number(2, 40)};
}

QuadStroke stroke(Dice& dice, double by) {
  const double length = dice.number(20, 120);
  const glm::dvec2 middle = dice.place(), half = dice.way(length / 2),
                   bend = dice.way(dice.number(0, length / 2));
  return {{by * (middle - half), by * (middle + bend), by * (middle + half)},
          by * dice.number(0.5, 3)};
}

#ifdef MIEN_HAVE_TEXT
Path word(Dice& dice, double by) {
  static const TextStyle style{.anchor = TextAnchor::middle, .y_up = false};
  static constexpr std::array kWords{"canthus", "sclera",     "limbus", "iris", "brow",
                                     "crease",  "commissure", "spine",  "lid",  "Outline"};
  const char* const text = kWords[std::size_t(dice.number(0, kWords.size()))];
  const double size = dice.number(8, 24);
  return text_path(text, by * size, by * dice.place(), style);
}
#endif

Shape shape(Crowd crowd, Dice& dice, double by) {
  switch (crowd) {
    case Crowd::strokes:
      return stroke(dice, by);
#ifdef MIEN_HAVE_TEXT
    case Crowd::text:
      return word(dice, by);
#endif
    default:
      return disc(dice, by);
  }
}

}  // namespace

std::span<const Crowd> crowds() {
  return kCrowds;
}

std::string_view crowd_name(Crowd crowd) {
  constexpr std::string_view kNames[] = {"discs", "translucent", "strokes", "text"};
  return kNames[int(crowd)];
}

Scene crowd_scene(Crowd crowd, int count, unsigned seed, int step) {
  SceneBuilder build({{{0, 0}, {kCrowdSide, kCrowdSide}}, false}, {1, 1, 1, 1});
  Dice dice(seed);
  const double by = 1 - kShrink * (step % kSteps);
  for (int i = 0; i < count; ++i) {
    const Color color = dice.color(crowd == Crowd::translucent ? 0.5 : 1);
    build.layer("", build.shape(shape(crowd, dice, by)), {color});
  }
  return std::move(build).finish();
}

}  // namespace mien::bench
