#include "sdf/from_face/caption.h"
#include <mien/text_path.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Caption, StandsInsideItsStrip) {
  const Scene scene = caption_scene(shipped_lettering(), "surprise 50%", 8);
  ASSERT_EQ(scene.layers().size(), 1u);
  const Box2 box = scene.bounds(scene.layers()[0].area);
  EXPECT_GE(box.lo.x, 0);
  EXPECT_LE(box.hi.x, 8);
  EXPECT_GE(box.lo.y, 0);
  EXPECT_LE(box.hi.y, 1);
  EXPECT_NEAR(box.center().x, 4, 0.3);
}

TEST(Caption, GrowsByItsLetters) {
  const Lettering letters = shipped_lettering();
  EXPECT_GT(caption_width(letters, "ab"), caption_width(letters, "a"));
  EXPECT_TRUE(caption_scene(letters, "", 4).layers().empty());
  EXPECT_TRUE(caption_scene({}, "a", 4).layers().empty()) << "nothing to write with";
}

TEST(Caption, HasCapitalsUmlautsDigitsAndSigns) {
  const Lettering letters = shipped_lettering();
  for (const char* sign : {"G", "\u00f6", "\u00df", "7", "?", "\u00d7", "(", "\u03b1"})
    EXPECT_EQ(caption_scene(letters, sign, 4).layers().size(), 1u) << sign;
}

/// An l is a line, from its base up: pixels on it are inside.
TEST(Caption, DrawsLetters) {
  const Lettering letters = shipped_lettering();
  SceneBuilder build({.box = {{0, 0}, {4, 8}}}, {1, 1, 1, 1});
  draw_caption(build, letters, "l", {0, 0}, 8, true, {0, 0, 0, 1});
  const Scene scene = std::move(build).finish();
  const Area l = scene.layers()[0].area;
  const double middle = 4 * caption_width(letters, "l");
  EXPECT_LT(scene.distance(l, {middle, 5}), 0);
  EXPECT_GT(scene.distance(l, {0, 5}), 0);
  EXPECT_GT(scene.distance(l, {middle, 1}), 0) << "below the base";
}

}  // namespace
}  // namespace mien
