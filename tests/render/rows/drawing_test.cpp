#include "render/rows/drawing.h"

#include <gtest/gtest.h>

#include <mien/render.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random_plain_scene.h"
#include "tests/support/random/random_scene.h"
#include "tests/support/shapes/outline_sight.h"
#include "tests/support/shapes/sweep_probe.h"

namespace mien {

/// A picture whose outlines, areas or looks are not those of its scene.
class DrawingProbe {
 public:
  DrawingProbe(const Scene& scene, const View& view) : view_(view) {
    drawing_.make(scene, view, Depth::u16);
  }

  Outlines& outlines() { return drawing_.now().outlines; }
  /// Arranges the outlines as they are now.
  void arrange() { drawing_.forget_order(), drawing_.arrange_all({1}); }
  void arrange_in_parts(int rows) {
    drawing_.rows_in_part_ = rows;
    arrange();
  }
  std::size_t parts() const { return drawing_.parts().size(); }
  /// The same in steps that are never halved, so that more is in doubt.
  void arrange_coarsely() {
    SweepProbe::never_halve(drawing_.parts_[0].sweep);
    arrange();
  }
  /// The fragments' two sides changed for each other.
  void turn_jumps() {
    for (Rgba& jump : drawing_.parts_[0].jumps) jump = Rgba{} - jump;
  }

  /// Whether a row has pixels resolved by distances.
  bool odd(int y) const {
    std::vector<std::byte> pixels(std::size_t(8 * view_.width));
    StripScratch scratch;
    RenderStats stats;
    drawing_.draw_strip(y / Drawing::kRows, {pixels.data(), pixels.size(), {0, y, view_.width, 1}},
                        scratch, stats);
    return scratch.odd_rows == std::uint32_t{1} << y % Drawing::kRows;
  }
  std::span<const Doubt> doubts() const { return drawing_.parts()[0].sweep.doubts(); }

  /// What the pixels may be off by, in levels of 255.
  std::vector<float> errors() const {
    std::vector<std::byte> pixels(std::size_t(8 * view_.width * view_.height));
    std::vector<float> levels(pixels.size() / 8);
    std::vector<std::uint8_t> estimated(levels.size());
    const RowTarget target{
        pixels.data(), std::size_t(8 * view_.width), {0, 0, view_.width, view_.height}};
    StripScratch scratch;
    for (int strip = 0; strip * Drawing::kRows < view_.height; ++strip)
      drawing_.draw_strip_with_errors(strip, target, scratch,
                                      {target.rect, levels.data(), estimated.data()});
    return levels;
  }

  /// The reference's own bound, of 1.
  double bound_of_reference(int x, int y) const {
    return SquareResolver(drawing_.scene(), view_, drawing_.paints(), 0x1p-14).pixel(x, y).bound;
  }

  std::vector<std::uint16_t> drawn(RenderStats& stats) const {
    std::vector<std::uint16_t> pixels(std::size_t(4 * view_.width * view_.height));
    const RowTarget target{reinterpret_cast<std::byte*>(pixels.data()),
                           std::size_t(8 * view_.width),
                           {0, 0, view_.width, view_.height}};
    StripScratch scratch;
    for (int strip = 0; strip * Drawing::kRows < view_.height; ++strip)
      drawing_.draw_strip(strip, target, scratch, stats);
    drawing_.tell(stats);
    return pixels;
  }

  /// The most that a channel of a pixel is off by beside the reference, of 1.
  double off(RenderStats& stats) {
    const std::vector<std::uint16_t> pixels = drawn(stats);
    SquareResolver resolver(drawing_.scene(), view_, drawing_.paints(), 0x1p-15);
    double most = 0;
    for (int y = 0; y < view_.height; ++y)
      for (int x = 0; x < view_.width; ++x) {
        const Mix mix = resolver.pixel(x, y).mix;
        for (int k = 0; k < 4; ++k)
          most = std::max(
              most,
              std::abs(mix[k] - pixels[std::size_t(4 * (y * view_.width + x) + k)] / 65535.0));
      }
    return most;
  }

 private:
  View view_;
  Drawing drawing_;
};

namespace {

constexpr double kAllowed = 32.0 / 65535;

/// Two squares beside each other in plain colours.
Scene two_squares() {
  SceneBuilder build({.box = {{0, 0}, {32, 32}}, .y_up = false}, {0, 0, 0, 1});
  const auto square = [&](double left, double right, double middle) {
    Path path;
    const glm::dvec2 a{left, 2}, b{right, 2}, c{right, 30}, d{left, 30}, m{left, middle};
    const auto side = [](glm::dvec2 p, glm::dvec2 q) { return QuadBezier{p, 0.5 * (p + q), q}; };
    path.loops.push_back({{side(a, b), side(b, c), side(c, d), side(d, m), side(m, a)}});
    return build.shape(path);
  };
  build.layer("left", square(2, 10, 16), {{1, 0.2, 0.1, 1}});
  build.layer("right", square(12, 20, 6), {{0.1, 0.3, 1, 1}});
  return std::move(build).finish();
}

const View kDrawnView{.width = 32, .height = 32, .blend = Blend::srgb, .dither = false};

TEST(Drawing, IsWhatTheReferenceSays) {
  RenderStats stats;
  EXPECT_LT(DrawingProbe(two_squares(), kDrawnView).off(stats), kAllowed);
  EXPECT_EQ(stats.doubts, 0);
  EXPECT_EQ(stats.resolved_pixels, 0);
}

TEST(Drawing, WhatEndedEarlyIsMadeAnew) {
  constexpr int kBands = 4;
  const View view{.width = 32, .height = kBands * Drawing::kRows};
  const auto drawn = [&](const Drawing& drawing) {
    std::vector<std::byte> pixels(std::size_t(4 * view.width * view.height));
    StripScratch scratch;
    RenderStats stats;
    for (int band = 0; band < kBands; ++band)
      drawing.draw_strip(band,
                         {pixels.data(), std::size_t(4 * view.width), {0, 0, 32, view.height}},
                         scratch, stats);
    return pixels;
  };
  Drawing drawing, fresh;
  const Scene scene = two_squares();
  drawing.prepare(scene, view, Depth::u8, {1});
  const std::function<bool(int)> wanted = [](int band) {
    return band < 2 ? band == 0 : throw std::string("the end");
  };
  EXPECT_THROW(drawing.arrange(wanted, {1}), std::string);
  drawing.make(scene, view, Depth::u8);
  fresh.make(scene, view, Depth::u8);
  EXPECT_EQ(drawn(drawing), drawn(fresh));
}

/// A side with a bulge in most rows, over a straight one.
Scene bulges_over_a_line() {
  SceneBuilder build({.box = {{0, 0}, {32, 32}}, .y_up = false}, {0, 0, 0, 1});
  const auto side = [](glm::dvec2 p, glm::dvec2 q) { return QuadBezier{p, 0.5 * (p + q), q}; };
  std::vector<QuadBezier> sides{side({3, 2}, {15.8, 2})};
  for (double y = 4; y < 28; ++y) {
    sides.push_back(side(sides.back().p2, {15.8, y + 0.1}));
    sides.push_back({sides.back().p2, {16.8, y + 0.5}, {15.8, y + 0.9}});
  }
  for (const glm::dvec2 to : {glm::dvec2{15.8, 30}, {3, 30}, {3, 2}})
    sides.push_back(side(sides.back().p2, to));
  build.layer("bulging", build.shape(Path{{{sides}}}), {{1, 0.2, 0.1, 0.6}});
  const QuadBezier box[] = {side({16, 2}, {28, 2}), side({28, 2}, {28, 30}),
                            side({28, 30}, {16, 30}), side({16, 30}, {16, 2})};
  build.layer("right", build.shape(Path{{{{box[0], box[1], box[2], box[3]}}}}),
              {{0.1, 0.3, 1, 0.6}});
  return std::move(build).finish();
}

TEST(Drawing, HasTheSameRowsInAnyParts) {
  for (int seed = 0; seed < test::times(20); ++seed) {
    const Scene scene = seed % 2 ? test::degenerate_scene(std::uint64_t(seed), 0)
                                 : test::random_painted_scene(std::uint64_t(seed));
    DrawingProbe probe(scene, {.width = 40, .height = 200});
    ASSERT_EQ(probe.parts(), 1u);
    RenderStats stats;
    const auto whole = probe.drawn(stats);
    for (const int rows : {16, 48, 100}) {
      probe.arrange_in_parts(rows);
      EXPECT_EQ(probe.parts(), rows == 16 ? 7u : rows == 48 ? 4u : 2u);
      EXPECT_EQ(probe.drawn(stats), whole) << seed << ", " << rows;
    }
  }
}

TEST(Drawing, HasTheSameOutlinesOfAnyNumberOfThreads) {
  for (int seed = 0; seed < test::times(20); ++seed) {
    const Scene scene = test::random_painted_scene(std::uint64_t(seed));
    Drawing one, three;
    const View view{.width = 40, .height = 320};
    one.make(scene, view, Depth::u8), three.make(scene, view, Depth::u8, {3});
    const Outlines &a = one.outlines(), &b = three.outlines();
    EXPECT_EQ(a.pieces, b.pieces);
    EXPECT_EQ(a.rules, b.rules);
    ASSERT_EQ(a.chains.size(), b.chains.size());
    for (std::size_t i = 0; i < a.chains.size(); ++i) {
      EXPECT_EQ(a.chains[i].first, b.chains[i].first);
      EXPECT_EQ(a.chains[i].last, b.chains[i].last);
      EXPECT_EQ(a.chains[i].outline, b.chains[i].outline);
      EXPECT_EQ(a.chains[i].turn, b.chains[i].turn);
    }
    ASSERT_EQ(a.ends.size(), b.ends.size());
    for (std::size_t i = 0; i < a.ends.size(); ++i) {
      EXPECT_EQ(a.ends[i].chain, b.ends[i].chain);
      EXPECT_EQ(a.ends[i].other, b.ends[i].other);
      EXPECT_EQ(a.ends[i].begins, b.ends[i].begins);
    }
  }
}

TEST(Drawing, AnOrderThatIsNotProvenIsDoubtedAndDrawnByDistances) {
  DrawingProbe probe(bulges_over_a_line(), kDrawnView);
  RenderStats exact;
  EXPECT_LT(probe.off(exact), kAllowed);
  EXPECT_EQ(exact.doubts, 0);
  probe.arrange_coarsely();
  RenderStats stats;
  EXPECT_LT(probe.off(stats), kAllowed);
  EXPECT_GT(stats.doubts, 0);
  EXPECT_GE(stats.resolved_pixels, 24);
  int doubted = 0;
  for (int y = 0; y < kDrawnView.height; ++y) {
    const bool doubt = std::ranges::any_of(
        probe.doubts(), [&](const Doubt& d) { return d.top < y + 1 && d.bottom > y; });
    EXPECT_EQ(probe.odd(y), doubt) << y;
    doubted += doubt;
  }
  EXPECT_GT(doubted, 5);
  EXPECT_LT(doubted, kDrawnView.height);
}

/// Generic ones, and those whose points lie on a lattice, or nearly so.
TEST(Drawing, OfRandomScenesIsWhatTheReferenceSays) {
  constexpr double kGeneric = -1;
  RenderStats stats;
  for (int seed = 0; seed < test::times(10); ++seed)
    for (const double jitter : {kGeneric, 0.0, 1e-3, 1e-6, 1e-9, 1e-13}) {
      const std::uint64_t s = std::uint64_t(seed) + 2000;
      const Scene scene =
          jitter == kGeneric ? test::random_plain_scene(s) : test::degenerate_scene(s, jitter);
      const int side = 24 + 3 * seed;
      const View view{.width = side, .height = side, .blend = Blend::srgb, .dither = false};
      EXPECT_LT(DrawingProbe(scene, view).off(stats), kAllowed) << "seed " << s << ' ' << jitter;
    }
  EXPECT_LT(stats.resolved_pixels, stats.edge_pixels / 100);
}

/// What distances prove of a pixel may be much less than what its outlines would.
TEST(Drawing, TheBoundOfAResolvedPixelIsTheReferences) {
  constexpr double kLeastSteep = 1.055 / 2.4;  // of encoding, in white
  const View view{.width = 24, .height = 24, .dither = false};
  double most = 0;
  for (const auto& [seed, jitter] : {std::pair{21, 1e-3}, {1, 1e-6}}) {
    DrawingProbe probe(test::degenerate_scene(std::uint64_t(seed), jitter), view);
    probe.arrange_coarsely();
    const std::vector<float> levels = probe.errors();
    for (const Doubt& d : probe.doubts())
      for (int y = int(d.top); y < std::min(view.height, int(std::ceil(d.bottom))); ++y)
        for (int x = std::max(0, int(d.left)); x < std::min(view.width, int(std::ceil(d.right)));
             ++x) {
          const double bound = 255 * kLeastSteep * probe.bound_of_reference(x, y);
          EXPECT_GE(levels[std::size_t(y * view.width + x)], bound) << x << ' ' << y;
          most = std::max(most, bound);
        }
  }
  EXPECT_GT(most, 0.2);
}

TEST(Drawing, FaultsInWindingsAndJumpsAreSeen) {
  const auto off_with = [](auto fault) {
    DrawingProbe probe(two_squares(), kDrawnView);
    for (OutlinePiece& p : probe.outlines().pieces)
      if (test::chain_of(probe.outlines(), p).outline == 0 && p.x0 == 10) fault(p);
    probe.arrange();
    RenderStats stats;
    return probe.off(stats);
  };
  EXPECT_LT(off_with([](OutlinePiece&) {}), kAllowed);
  EXPECT_GT(off_with([](OutlinePiece& p) { p.x0 += 0.002, p.ax -= 0.001; }), kAllowed);
  EXPECT_GT(off_with([](OutlinePiece& p) { p.bx = 0.003, p.ax = -0.0015; }), 0.0);
  SceneBuilder build({.box = {{0, 0}, {32, 32}}}, {0, 0, 0, 1});
  const QuadBezier round[] = {{{4, 4}, {28, 4}, {28, 28}}, {{28, 28}, {4, 28}, {4, 4}}};
  build.layer("twice", build.shape(Path{{{{round[0], round[1], round[0], round[1]}}}}),
              {{1, 1, 1, 1}});
  DrawingProbe wound(std::move(build).finish(), kDrawnView);
  wound.outlines().rules[0] = FillRule::even_odd;
  wound.arrange();
  RenderStats of_wound;
  EXPECT_GT(wound.off(of_wound), 0.1);
  DrawingProbe turned(two_squares(), kDrawnView);
  turned.turn_jumps();
  RenderStats stats;
  EXPECT_GT(turned.off(stats), 0.1);
}

TEST(Drawing, OfAPartIsThatPartOfTheWhole) {
  for (int seed = 1; seed <= 2; ++seed) {
    const Scene scene = test::random_painted_scene(std::uint64_t(seed));
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
      View view{.width = 71, .height = 53};
      const Image whole = test::rendered(scene, view, {.depth = depth});
      const std::size_t pixel = 4 * bytes_per_channel(depth);
      for (const PixelRect part :
           {PixelRect{0, 0, 1, 1}, {70, 52, 1, 1}, {13, 15, 40, 3}, {64, 0, 7, 53}}) {
        view.region = part;
        const Image piece = test::rendered(scene, view, {.depth = depth});
        for (int y = 0; y < part.height; ++y)
          ASSERT_EQ(std::memcmp(piece.row(y), whole.row(y + part.y) + pixel * std::size_t(part.x),
                                pixel * std::size_t(part.width)),
                    0)
              << "seed " << seed << " row " << y;
      }
    }
  }
}

TEST(Drawing, OfAnySizeIsFilledToItsBorders) {
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 0, 0, 1});
  const Scene scene = std::move(build).finish();
  for (const int width : {1, 63, 64, 65})
    for (int height = 1; height <= 17; ++height) {
      const Image image = test::rendered(scene, {.width = width, .height = height});
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(image.row(y)[4 * x], 255);
    }
}

TEST(Drawing, CountsWhatItDid) {
  SceneBuilder build({.box = {{0, 0}, {100, 100}}}, {0, 0, 0, 1});
  build.layer("disc", build.shape(Disc{{50, 50}, 30}), {{1, 1, 1, 1}});
  RenderStats stats;
  test::rendered(std::move(build).finish(), {.width = 100, .height = 100}, {}, &stats);
  EXPECT_EQ(stats.fill_pixels + stats.edge_pixels, 10'000);
  EXPECT_EQ(stats.regions, 2);
  EXPECT_EQ(stats.doubts, 0);
  EXPECT_GT(stats.roots, 190);
}

}  // namespace
}  // namespace mien
