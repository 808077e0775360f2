#include <mien/font.h>

#include <gtest/gtest.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(Font, TheShippedOneHasItsSigns) {
  const Font font = Font::shipped();
  EXPECT_EQ(font.glyph('l').loops.size(), 1u);
  EXPECT_EQ(font.glyph('e').loops.size(), 2u);
  EXPECT_EQ(font.glyph('8').loops.size(), 3u);
  EXPECT_EQ(font.glyph(' ').loops.size(), 0u);
  EXPECT_GT(font.glyph('W').advance, font.glyph('i').advance);
  EXPECT_EQ(font.glyph('1').advance, font.glyph('8').advance) << "figures stand in columns";
  for (const char32_t c : {U'é', U'ß', U'Ω', U'ά', U'Я', U'−', U'×', U'≤', U'→'}) {
    EXPECT_NE(font.glyph(c).loops.size(), 0u);
    EXPECT_FALSE(font.glyph(c).loops[0].sides[0].p0 == font.glyph(U'漢').loops[0].sides[0].p0 &&
                 font.glyph(c).advance == font.glyph(U'漢').advance)
        << "drawn as the box of those it does not have: " << unsigned(c);
  }
  EXPECT_LT(font.kerning('A', 'V'), 0);
  EXPECT_EQ(font.kerning('n', 'n'), 0);
  EXPECT_NEAR(font.ascent(), 0.93, 0.02);
  EXPECT_NEAR(font.descent(), 0.24, 0.02);
}

TEST(Font, LoopsAreClosed) {
  const Font font = Font::shipped();
  for (char32_t c = 0x21; c < 0x180; ++c) {
    for (const Path::Loop& loop : font.glyph(c).loops) {
      ASSERT_FALSE(loop.sides.empty());
      EXPECT_EQ(loop.sides.front().p0, loop.sides.back().p2);
      for (std::size_t i = 1; i < loop.sides.size(); ++i)
        EXPECT_EQ(loop.sides[i].p0, loop.sides[i - 1].p2);
    }
  }
}

TEST(Font, FilesAreReadOrRefused) {
  const std::string shipped = std::string(MIEN_SOURCE_DIR) + "/sdf/from_text/font/DejaVuSans.ttf";
  const auto font = Font::read(shipped);
  ASSERT_TRUE(font);
  EXPECT_EQ(font->glyph('a').advance, Font::shipped().glyph('a').advance);
  const test::ScratchFolder folder;
  EXPECT_EQ(sentence(Font::read(folder / "none.ttf").error()),
            (folder / "none.ttf").string() + ": cannot be read: No such file or directory");
  test::write_text(folder / "a.ttf", "no font");
  EXPECT_EQ(sentence(Font::read(folder / "a.ttf").error()),
            (folder / "a.ttf").string() + ": is no font that FreeType can read");
  test::write_text(folder / "a.ttf", test::read_text(shipped).substr(0, 9000));
  const auto cut = Font::read(folder / "a.ttf");  // refused, or a font whose signs are empty
  if (cut) cut->glyph('a');
}

}  // namespace
}  // namespace mien
