#include "sdf/from_face/caption.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Caption, StandsInsideItsStrip) {
  const Scene scene = caption_scene("surprise 50%", 8);
  ASSERT_EQ(scene.layers().size(), 1u);
  const Box2 box = scene.bounds(scene.layers()[0].area);
  EXPECT_GE(box.lo.x, 0);
  EXPECT_LE(box.hi.x, 8);
  EXPECT_GE(box.lo.y, 0);
  EXPECT_LE(box.hi.y, 1);
  EXPECT_NEAR(box.center().x, 4, 0.3);
}

TEST(Caption, GrowsByItsLetters) {
  EXPECT_GT(caption_width("ab"), caption_width("a"));
  EXPECT_TRUE(caption_scene("", 4).layers().empty());
  EXPECT_TRUE(caption_scene("?!", 4).layers().empty());
}

/// An l is a line, from its baseline up: pixels on it are inside.
TEST(Caption, DrawsLetters) {
  SceneBuilder build({.box = {{0, 0}, {4, 8}}}, {1, 1, 1, 1});
  draw_caption(build, "l", {0, 0}, 8, true, {0, 0, 0, 1});
  const Scene scene = std::move(build).finish();
  const Area l = scene.layers()[0].area;
  EXPECT_LT(scene.distance(l, {2, 5}), 0);
  EXPECT_GT(scene.distance(l, {0, 5}), 0);
  EXPECT_GT(scene.distance(l, {2, 1}), 0);
}

}  // namespace
}  // namespace mien
