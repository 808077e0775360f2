// Items G9, G10: effects as people write them.

#include <gtest/gtest.h>

#include <mien/effect.h>

namespace mien {
namespace {

TEST(Effect, ReadsEveryForm) {
  const auto mosaic = std::get<MosaicEffect>(*read_effect("mosaic:24,0.3,center"));
  EXPECT_EQ(mosaic.tiles, 24);
  EXPECT_EQ(mosaic.border, 0.3);
  EXPECT_TRUE(mosaic.center);
  EXPECT_EQ(std::get<MosaicEffect>(*read_effect("mosaic:8")).border, 0);
  const auto grid = std::get<GridEffect>(*read_effect("grid:12,2.5,#ff000080"));
  EXPECT_EQ(grid.cells, 12);
  EXPECT_EQ(grid.width, 2.5);
  EXPECT_EQ(grid.color.r, 1);
  EXPECT_NEAR(grid.color.a, 128 / 255.0, 1e-12);
}

TEST(Effect, RefusesTheRestInASentence) {
  const std::pair<const char*, const char*> bads[] = {
      {"mosaic:0", "expected 1 to 65536 tiles across"},
      {"mosaic:1000000", "expected 1 to 65536 tiles across"},
      {"mosaic", "expected 1 to 65536 tiles across"},
      {"mosaic:4.5", "expected 1 to 65536 tiles across"},
      {"mosaic:4,2", "a border goes from 0 (none) to 1 (pyramids)"},
      {"mosaic:4,0,x", "a tile shows its \"mean\" or its \"center\""},
      {"mosaic:4,0,mean,1", "expected mosaic:TILES,BORDER,mean|center"},
      {"grid:0", "expected 1 to 65536 cells across"},
      {"grid:4,-1", "a line's width is a number of pixels, 0 or more"},
      {"grid:4,nan", "a line's width is a number of pixels, 0 or more"},
      {"grid:4,1,red", "expected a colour like #rrggbb or #rrggbbaa"},
      {"mosiac:4", "no effect named \"mosiac\"; did you mean \"mosaic\"?"}};
  for (const auto& [text, what] : bads) {
    const auto effect = read_effect(text);
    ASSERT_FALSE(effect) << text;
    EXPECT_EQ(effect.error().what, what);
    EXPECT_EQ(effect.error().where, text);
  }
}

}  // namespace
}  // namespace mien
