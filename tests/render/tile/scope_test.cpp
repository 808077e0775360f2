#include <mien/render/tile/scope.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

/// Two discs, the right one on top, in a picture of 100 × 100 pixels.
Tape two_discs(double top_opacity) {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {1, 1, 1, 1});
  build.layer("left", build.shape(Disc{{-20, 0}, 20}), {{1, 0, 0, 1}});
  build.layer("right", build.shape(Disc{{0, 0}, 20}), {{0, 0, 1, top_opacity}});
  return tape_from_scene(std::move(build).finish(), {.width = 100, .height = 100});
}

TEST(ScopeStack, ForgetsOutlinesFarAwayAndLayersHidden) {
  const Tape tape = two_discs(1);
  ScopeStack scopes(tape);
  const Scope all = scopes.everything();
  EXPECT_EQ(all.outline_count, 2);
  // Around the left disc's right end, deep inside the right disc: nothing is undecided any more.
  const Scope hidden = scopes.narrowed(all, {0, 0}, 3);
  EXPECT_EQ(hidden.outline_count, 0);
  EXPECT_EQ(scopes.color(hidden), (Mix{0, 0, 1, 1}));
  const Scope edge = scopes.narrowed(all, {20, 0}, 3);
  ASSERT_EQ(edge.outline_count, 1);
  EXPECT_EQ(edge.layer_count, 1);
  scopes.set_side(scopes.outlines(edge)[0], Side::in);
  EXPECT_EQ(scopes.color(edge), (Mix{0, 0, 1, 1}));
  scopes.set_side(scopes.outlines(edge)[0], Side::out);
  EXPECT_EQ(scopes.color(edge), (Mix{1, 1, 1, 1}));
}

TEST(ScopeStack, KeepsWhatIsSeenThroughATranslucentLayer) {
  const Tape tape = two_discs(0.5);
  ScopeStack scopes(tape);
  const Scope seen = scopes.narrowed(scopes.everything(), {0, 0}, 3);
  EXPECT_EQ(seen.outline_count, 1);
  for (const Side side : {Side::in, Side::out}) {
    scopes.set_side(scopes.outlines(seen)[0], side);
    EXPECT_EQ(scopes.color(seen), side == Side::in ? (Mix{0.5, 0, 0.5, 1}) : (Mix{0.5, 0.5, 1, 1}));
  }
}

TEST(ScopeStack, NarrowingNeverChangesAColour) {
  SceneBuilder build({.box = {{-50, -50}, {50, 50}}}, {0.5, 0.5, 0.5, 1});
  const Area a = build.shape(Disc{{-10, 0}, 25}), b = build.shape(Disc{{10, 5}, 20}),
             c = build.shape(Disc{{0, -9}, 15});
  build.layer("1", build.either(build.without(a, b), c), {{1, 0, 0, 0.5}});
  build.layer("2", build.both(build.complement(c), build.shell(b, 4)), {{0, 1, 0, 1}});
  build.layer("3", build.both(a, build.both(b, c)), {{0, 0, 1, 0.25}});
  const Tape tape = tape_from_scene(std::move(build).finish(), {.width = 100, .height = 100});
  ScopeStack scopes(tape);
  const auto at = [&](const Scope& scope, glm::dvec2 p) {
    for (const int i : scopes.outlines(scope))
      scopes.set_side(i, distance(tape.outlines[std::size_t(i)], p) <= 0 ? Side::in : Side::out);
    return scopes.color(scope);
  };
  const Scope all = scopes.everything();
  for (double y = -45; y < 45; y += 7.3)
    for (double x = -45; x < 45; x += 7.1) {
      const auto mark = scopes.mark();
      const Scope wide = scopes.narrowed(all, {x, y}, 12),
                  narrow = scopes.narrowed(wide, {x + 3, y - 2}, 5);
      for (double angle = 0; angle < 6.28; angle += 0.3) {
        const glm::dvec2 p =
            glm::dvec2{x + 3, y - 2} + 4.9 * glm::dvec2{std::cos(angle), std::sin(angle)};
        const Mix whole = at(all, p), cut = at(narrow, p);
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(whole[k], cut[k], 1e-15);
      }
      scopes.reset(mark);
    }
}

}  // namespace
}  // namespace mien
