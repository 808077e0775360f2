#include "tests/support/exact/exact_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/support/exact/exact_compare.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

/// The pictures of a window, and those who judge them.
class Window {
 public:
  Window(const Scene& scene, View view, const PixelRect& rect, const ExactTruth& truth,
         const Wanted& wanted, const Choice& choice, Tallies& tallies)
      : rect_(rect),
        spread_(view.dither ? 1 : 0),
        truth_(truth),
        choice_(choice),
        tallies_(tallies) {
    view.region = rect;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      view.blend = kStorages[i].blend;
      if (wanted[i]) images_[i] = drawn_image(scene, view, kStorages[i].depth);
    }
  }

  /// Halves what is not of one colour.
  void judge(const PixelRect& part) {
    if (truth_.flat(part)) {
      const Mixes color = truth_.means(part.x, part.y);
      for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) compare(x, y, color);
    } else if (part.width == 1 && part.height == 1) {
      if (choice_(part.x, part.y)) compare(part.x, part.y, truth_.means(part.x, part.y));
    } else if (part.width >= part.height) {
      const int half = part.width / 2;
      judge({part.x, part.y, half, part.height});
      judge({part.x + half, part.y, part.width - half, part.height});
    } else {
      const int half = part.height / 2;
      judge({part.x, part.y, part.width, half});
      judge({part.x, part.y + half, part.width, part.height - half});
    }
  }

 private:
  /// How far apart a picture's pixel and what it should be are [levels].
  double off(std::size_t i, int x, int y, const Mixes& exact) const {
    const Storage& storage = kStorages[i];
    return apart(drawn_levels(images_[i], x - rect_.x, y - rect_.y),
                 levels_of(exact, storage.blend, storage.top), storage.top);
  }

  /// A coarse truth may miss what is thinner than a few hundredths of a pixel: it condemns nothing that a fine one does
  /// not.
  void compare(int x, int y, Mixes exact) {
    for (std::size_t i = 0; i < std::size(kStorages); ++i) {
      if (images_[i].bytes.empty() || off(i, x, y, exact) <= kStorages[i].allowed + spread_)
        continue;
      exact = truth_.fine_means(x, y);
      break;
    }
    for (std::size_t i = 0; i < std::size(kStorages); ++i) {
      if (images_[i].bytes.empty()) continue;
      const Storage& storage = kStorages[i];
      Tally& tally = tallies_[i];
      const glm::dvec4 want = levels_of(exact, storage.blend, storage.top);
      const glm::dvec4 drawn = drawn_levels(images_[i], x - rect_.x, y - rect_.y);
      const double off = this->off(i, x, y, exact);
      ++tally.judged;
      if (off > storage.allowed + spread_) ++tally.over;
      if (off <= tally.worst) continue;
      tally.worst = off;
      tally.where =
          fmt::format("({}, {}) drawn {} {} {} {} exact {:.2f} {:.2f} {:.2f} {:.2f}", x, y, drawn.r,
                      drawn.g, drawn.b, drawn.a, want.r, want.g, want.b, want.a);
    }
  }

  PixelRect rect_;
  double spread_;  ///< of a dither [levels]
  const ExactTruth& truth_;
  const Choice& choice_;
  Tallies& tallies_;
  std::array<Image, std::size(kStorages)> images_;
};

/// A place near the outline of an area or inside it, if some tries find one.
bool find_place(const Scene& scene, Area area, double near, Random& random, glm::dvec2& p) {
  const Box2 canvas = scene.canvas().box, around = scene.bounds(area);
  const glm::dvec2 lo = glm::max(canvas.lo, around.lo), hi = glm::min(canvas.hi, around.hi);
  if (!(lo.x < hi.x && lo.y < hi.y)) return false;
  const bool at_the_outline = random.chance(0.7);
  for (int tries = 0; tries < 2000; ++tries) {
    p.x = random.between(lo.x, hi.x), p.y = random.between(lo.y, hi.y);
    const double d = scene.distance(area, p);
    if (at_the_outline ? std::abs(d) < near : d <= 0) return true;
  }
  return false;
}

}  // namespace

void judge_window(const Scene& scene, View view, const PixelRect& window, const ExactTruth& truth,
                  const Wanted& wanted, const Choice& choice, Tallies& tallies) {
  Window(scene, view, window, truth, wanted, choice, tallies).judge(window);
}

std::vector<PixelRect> windows_of(const Scene& scene, const View& view, int side, int anywhere,
                                  int each_relief, std::uint64_t seed) {
  Random random(seed);
  std::vector<PixelRect> windows;
  const auto add = [&](double x, double y) {
    windows.push_back({std::clamp(int(x) - side / 2, 0, view.width - side),
                       std::clamp(int(y) - side / 2, 0, view.height - side), side, side});
  };
  for (int i = 0; i < anywhere; ++i) {
    const double x = random.between(0, view.width);
    add(x, random.between(0, view.height));
  }
  const auto add_around = [&](glm::dvec2 place) {
    const glm::dvec2 from_center = pixel_from_face(scene.canvas(), view)(place);
    add(from_center.x + 0.5 * view.width, from_center.y + 0.5 * view.height);
  };
  for (const Layer& layer : scene.layers()) {
    if (!layer.paint.relief) continue;
    glm::dvec2 place;
    for (int i = 0; i < each_relief; ++i)
      if (find_place(scene, layer.area, 0.004 * scene.canvas().box.size().x, random, place))
        add_around(place);
    for (const Dome& dome : layer.paint.relief->domes) add_around(dome.center);
  }
  return windows;
}

}  // namespace mien::test
