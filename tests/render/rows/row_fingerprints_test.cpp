#include "render/rows/row_fingerprints.h"
#include "render/rows/drawing.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace mien {
namespace {

constexpr int kPictureSide = 40;

/// A pixel to a unit: a translucent pair of discs over a gradient, high up and low down.
struct Numbers {
  double radius = 3, stop = 1, opacity = 0.5;
  glm::dvec2 hidden{20, 30};
  MixMode mix = MixMode::normal, mix_above = MixMode::normal;

  Scene scene() const {
    SceneBuilder build({{{0, 0}, {kPictureSide, kPictureSide}}, false}, {1, 1, 1, 1});
    const auto fade = [&](double middle) {
      return shared(Gradient{LinearGradient{{0, middle - 3}, {0, middle + 3}},
                             {{0, {stop, 0, 0, 1}}, {1, {0, 0, 1, 1}}}});
    };
    build.open_group("pair", opacity, {}, mix);
    build.layer("left", build.shape(Disc{{10, 8}, 3}), {{0, 0, 0, 1}});
    build.layer("right", build.shape(Disc{{20, 8}, radius}), {{0, 0, 0, 1}});
    build.close_group();
    build.layer("below", build.shape(Disc{hidden, 1}), {{0, 1, 0, 1}});
    build.open_group("one", 1, {}, mix_above);
    build.layer("above", build.shape(Disc{{20, 30}, 5}), {{1, 1, 1, 1}, fade(30)});
    build.close_group();
    return std::move(build).finish();
  }
};

std::vector<std::uint64_t> rows_of(const Scene& scene,
                                   const View& view = {.width = kPictureSide,
                                                       .height = kPictureSide}) {
  Drawing drawing;
  drawing.make(scene, view, Depth::u8);
  const RowFingerprints& prints = *drawing.fingerprints();
  std::vector<std::uint64_t> rows;
  for (int y = 0; y < view.height; ++y) rows.push_back(prints[y]);
  return rows;
}

/// Rows that differ: from the first to the last.
std::pair<int, int> differing(const std::function<void(Numbers&)>& change) {
  Numbers changed;
  change(changed);
  const auto before = rows_of(Numbers().scene()), after = rows_of(changed.scene());
  int first = kPictureSide, last = -1;
  for (int y = 0; y < kPictureSide; ++y)
    if (before[std::size_t(y)] != after[std::size_t(y)]) first = std::min(first, y), last = y;
  return {first, last};
}

TEST(RowFingerprints, ChangeWhereTheRowDoes) {
  using Rows = std::pair<int, int>;
  EXPECT_EQ(differing([](Numbers&) {}), (Rows{kPictureSide, -1}));
  EXPECT_EQ(differing([](Numbers& n) { n.radius = 3.5; }), (Rows{4, 11}));
  EXPECT_EQ(differing([](Numbers& n) { n.opacity = 0.6; }), (Rows{5, 10})) << "a group's";
  EXPECT_EQ(differing([](Numbers& n) { n.mix = MixMode::screen; }), (Rows{5, 10}));
  EXPECT_EQ(differing([](Numbers& n) { n.mix_above = MixMode::screen; }), (Rows{25, 34}));
  EXPECT_EQ(differing([](Numbers& n) { n.stop = 0.9; }), (Rows{25, 32})) << "a gradient's";
  EXPECT_EQ(differing([](Numbers& n) { n.hidden.x = 21; }), (Rows{kPictureSide, -1}))
      << "what is hidden";
}

TEST(RowFingerprints, AreThoseOfAView) {
  const Scene scene = Numbers().scene();
  const View plain{.width = kPictureSide, .height = kPictureSide};
  std::set<std::uint64_t> all;
  for (const auto& change : std::initializer_list<std::function<void(View&)>>{
           [](View&) {}, [](View& v) { v.width = 41; }, [](View& v) { v.blend = Blend::srgb; },
           [](View& v) {
             v.background = Color{0, 0, 0, 1};
           },
           [](View& v) { v.dither = false; },
           [](View& v) {
             v.light = glm::dvec3{0, 0, 1};
           }}) {
    View view = plain;
    change(view);
    all.insert(rows_of(scene, view)[30]);
  }
  EXPECT_EQ(all.size(), 6u);
}

}  // namespace
}  // namespace mien
