#include <mien/parallel.h>
#include <mien/piece_drawer.h>
#include <mien/render.h>

#include <gtest/gtest.h>

#include <mutex>

#include "tests/support/pictures/rendered.h"

namespace mien {
namespace {

Scene discs() {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.layer("one", build.shape(Disc{{-0.2, 0.1}, 0.5}), {{0.1, 0.2, 0.7, 0.6}});
  build.layer("two", build.shape(Disc{{0.3, -0.1}, 0.4}), {{0.8, 0.2, 0.1, 0.6}});
  return std::move(build).finish();
}

TEST(PieceDrawer, PiecesOnThreadsAreThePicture) {
  const View view{.width = 300, .height = 230};
  const Image whole = test::rendered(discs(), view);
  Image image = whole;
  std::fill(image.bytes.begin(), image.bytes.end(), std::byte(0));
  auto drawer = PieceDrawer::of(discs(), view);
  ASSERT_TRUE(drawer);
  RenderStats sum;
  std::mutex mutex;
  parallel_for(2 * 23, {.count = 4}, [&](int i) {
    const PixelRect piece{i % 2 * 130, i / 2 * 10, i % 2 ? 170 : 130, 10};
    RenderStats stats;
    EXPECT_TRUE(drawer->draw(
        {image.bytes.data() + image.stride() * std::size_t(piece.y) + 4 * std::size_t(piece.x),
         image.stride(), Depth::u8},
        piece, [] { return false; }, &stats));
    const std::lock_guard lock(mutex);
    sum.add(stats);
  });
  EXPECT_TRUE(image.bytes == whole.bytes);
  EXPECT_EQ(sum.pixels, 300 * 230);
  RenderStats at_once;
  ASSERT_TRUE(render(discs(), view, {}, &at_once));
  EXPECT_EQ(sum.memory, at_once.memory);  // making the outlines counts, and once
  EXPECT_GE(sum.steps, at_once.steps / 2);
  EXPECT_GT(sum.pieces, 0);
}

TEST(PieceDrawer, StopsWhenAsked) {
  std::vector<std::byte> pixels(4 * 64 * 4000);
  auto drawer = PieceDrawer::of(discs(), {.width = 64, .height = 4000});
  ASSERT_TRUE(drawer);
  RenderStats stats;
  int asked = 0;
  EXPECT_FALSE(drawer->draw(
      {pixels.data(), 256, Depth::u8}, {0, 0, 64, 4000}, [&] { return ++asked == 1; }, &stats));
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(stats.cancelled);
}

TEST(PieceDrawer, RefusesWhatIsNotInThePicture) {
  EXPECT_FALSE(PieceDrawer::of(discs(), {.width = 0, .height = 9}));
  auto drawer = PieceDrawer::of(discs(), {.width = 64, .height = 40});
  ASSERT_TRUE(drawer);
  std::vector<std::byte> pixels(4 * 64 * 40);
  for (const PixelRect& piece : {PixelRect{-1, 0, 9, 9}, PixelRect{60, 0, 5, 1},
                                 PixelRect{0, 39, 1, 2}, PixelRect{0, 0, 0, 1}})
    EXPECT_FALSE(drawer->draw({pixels.data(), 256}, piece));
  EXPECT_EQ(drawer->draw({pixels.data(), 256}, {60, 0, 5, 1}).error().what,
            "the piece 60,0,5,1 is not in a picture of 64 x 40 pixels");
}

}  // namespace
}  // namespace mien
