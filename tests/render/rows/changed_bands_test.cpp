#include "render/rows/changed_bands.h"
#include "render/rows/drawing.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "tests/support/process/asked.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/changed_scene.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_lit_scene.h"
#include "tests/support/random/random_scene.h"

namespace mien {
namespace {

constexpr int kPictureWidth = 64, kPictureHeight = 160;
const View kPicture{.width = kPictureWidth, .height = kPictureHeight};

/// A pixel to a unit: discs below each other, the lowest one lit by its distance to another one far above.
struct Discs {
  double first = 16, radius = 4, second = 60, green = 1, lamp = 70, wide = 0;
  double opacity = 1;

  Scene scene() const {
    SceneBuilder build({{{0, 0}, {kPictureWidth, kPictureHeight}}, false}, {1, 1, 1, 1});
    build.layer("first", build.shape(Disc{{20, first}, radius}), {{0, 0, 0, 1}});
    build.layer("second", build.shape(Disc{{30, second}, 3}), {{0, green, 0, 1}});
    build.open_group("a group", opacity);
    const Area far_away = build.shape(Disc{{60, lamp}, 2});
    const auto glow =
        shared(Gradient{DistanceGradient{far_away, 0, 20}, {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 1}}}});
    build.layer("lit", build.shape(Disc{{30, 136}, 4}), {{1, 1, 1, 1}, glow});
    build.close_group();
    if (wide > 0)
      build.layer("wide",
                  build.intersect(build.shape(Disc{{30, 100}, 2}),
                                  build.complement(build.shape(Disc{{30, 16}, wide}))),
                  {{0, 0, 0, 1}});
    return std::move(build).finish();
  }
};

/// The bands that changed, from the one scene to the other.
std::vector<int> changed_between(const Scene& before, const Scene& now) {
  Drawing drawing;
  drawing.make(before, kPicture, Depth::u8);
  drawing.prepare(now, kPicture, Depth::u8, {1});
  std::vector<int> bands;
  for (int band = 0; band < drawing.bands(); ++band)
    if (drawing.changed(band)) bands.push_back(band);
  return bands;
}

std::vector<int> changed_by(const std::function<void(Discs&)>& change, const Discs& before = {}) {
  Discs now = before;
  change(now);
  return changed_between(before.scene(), now.scene());
}

using Bands = std::vector<int>;

TEST(ChangedBands, AreThoseOfOutlinesBeforeAndNow) {
  EXPECT_EQ(changed_by([](Discs&) {}), Bands{});
  EXPECT_EQ(changed_by([](Discs& d) { d.second = 62; }), (Bands{3, 4}));
  EXPECT_EQ(changed_by([](Discs& d) { d.second = 140; }), (Bands{3, 8})) << "57 … 63, 137 … 143";
  EXPECT_EQ(changed_by([](Discs& d) { d.second = 15; }), (Bands{0, 1, 3}));
}

TEST(ChangedBands, OneOfAChainThatEndsOnItsTopIsSeenFromThere) {
  const auto box_down_to = [](double y) {
    SceneBuilder build({{{0, 0}, {kPictureWidth, kPictureHeight}}, false}, {1, 1, 1, 1});
    const auto side = [](glm::dvec2 p, glm::dvec2 q) { return QuadBezier{p, 0.5 * (p + q), q}; };
    const glm::dvec2 a{9, 4}, b{20, 4}, c{20, y}, d{9, y};
    build.layer("", build.shape(Disc{{30, 60}, 3}), {{0, 0, 0, 1}});
    build.layer("", build.shape(Path{{{{side(a, b), side(b, c), side(c, d), side(d, a)}}}}),
                {{0, 0, 0, 1}});
    return std::move(build).finish();
  };
  EXPECT_EQ(changed_between(box_down_to(14), box_down_to(16)), (Bands{0, 1}));
  EXPECT_EQ(changed_between(box_down_to(14), box_down_to(15.5)), (Bands{0}));
}

TEST(ChangedBands, APaintReachesAsFarAsItsLayer) {
  EXPECT_EQ(changed_by([](Discs& d) { d.green = 0.5; }), (Bands{3}));
  EXPECT_EQ(changed_by([](Discs& d) { d.lamp = 76; }), (Bands{3, 4, 5, 6, 8}))
      << "its level lines, and what reads its distance farther down";
  EXPECT_EQ(changed_by([](Discs& d) { d.opacity = 0.5; }).size(), 10u) << "groups: everywhere";
}

TEST(ChangedBands, AProgramIsReadOnHeights) {
  EXPECT_EQ(changed_by([](Discs& d) { d.wide = 3; }, Discs{.wide = 2}), (Bands{0, 1}));
}

TEST(ChangedBands, AreAllOfAnotherView) {
  const Scene scene = Discs().scene();
  for (const auto& change : std::initializer_list<std::function<void(View&)>>{
           [](View& v) { v.width = 41; }, [](View& v) { v.blend = Blend::srgb; },
           [](View& v) {
             v.background = Color{0, 0, 0, 1};
           },
           [](View& v) { v.dither = false; },
           [](View& v) {
             v.light = glm::dvec3{0, 0, 1};
           }}) {
    View other = kPicture;
    change(other);
    Drawing drawing;
    drawing.make(scene, kPicture, Depth::u8);
    drawing.prepare(scene, other, Depth::u8, {1});
    for (int band = 0; band < drawing.bands(); ++band) EXPECT_TRUE(drawing.changed(band));
  }
}

/// A picture of which only some bands are drawn.
struct Picture {
  static constexpr std::size_t kRowBytes = std::size_t{8} * kPictureWidth;
  std::vector<std::byte> pixels = std::vector<std::byte>(kRowBytes * kPictureHeight);
  std::vector<std::uint32_t> odd;  ///< by band: its rows with pixels resolved by distances

  /// Those that changed, and those with such rows; all others stay.
  int draw(Drawing& drawing, const Scene& scene) {
    drawing.prepare(scene, kPicture, Depth::u16, {1});
    odd.resize(std::size_t(drawing.bands()), 1);
    const auto wanted = [&](int band) {
      return drawing.changed(band) || odd[std::size_t(band)] != 0;
    };
    drawing.arrange(std::ref(wanted), {1});
    StripScratch scratch;
    RenderStats stats;
    int kept = 0;
    for (int band = 0; band < drawing.bands(); ++band) {
      if (!wanted(band) && ++kept) continue;
      drawing.draw_strip(band, {pixels.data(), kRowBytes, {0, 0, kPictureWidth, kPictureHeight}},
                         scratch, stats);
      odd[std::size_t(band)] = scratch.odd_rows;
    }
    return kept;
  }
};

/// Of scenes in which one thing changes: what changed is arranged alone, and all of the other picture from nothing.
TEST(ChangedBands, OthersHaveTheSameBytes) {
  int kept = 0, all = 0;
  for (int seed = 1; seed <= test::times(test::asked_of("MIEN_SEQUENCES", 250) / 8); ++seed) {
    test::Random random{std::uint64_t(seed)};
    Scene scene = seed % 6 == 0   ? test::random_lit_scene(std::uint64_t(seed))
                  : seed % 2 == 0 ? test::degenerate_scene(std::uint64_t(seed), seed % 4 ? 0 : 1e-3)
                                  : test::random_painted_scene(std::uint64_t(seed));
    Drawing moving;
    Picture picture;
    picture.draw(moving, scene);
    for (int step = 0; step < 3; ++step) {
      scene = test::changed_scene(scene, random);
      Drawing fresh;
      Picture whole;
      kept += picture.draw(moving, scene), all += moving.bands();
      whole.draw(fresh, scene);
      ASSERT_EQ(moving.outlines().pieces, fresh.outlines().pieces);
      for (int y = 0; y < kPictureHeight; ++y) {
        const std::size_t at = std::size_t(y) * Picture::kRowBytes;
        ASSERT_EQ(std::memcmp(&picture.pixels[at], &whole.pixels[at], Picture::kRowBytes), 0)
            << "seed " << seed << ", step " << step << ", row " << y;
      }
    }
  }
  EXPECT_GT(kept, all / 5);
}

}  // namespace
}  // namespace mien
