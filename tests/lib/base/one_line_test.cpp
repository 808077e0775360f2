#include "lib/base/one_line.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(OneLine, KeepsWhatCanBePrinted) {
  EXPECT_EQ(one_line("faces/a b.json"), "faces/a b.json");
  EXPECT_EQ(one_line("Brauenbögen 眉 🙂"), "Brauenbögen 眉 🙂");
}

TEST(OneLine, EscapesControlCharactersAndBrokenUtf8) {
  EXPECT_EQ(one_line("a\nb\tc\x7F"), "a\\x0Ab\\x09c\\x7F");
  EXPECT_EQ(one_line("\xFF\xC3"), "\\xFF\\xC3");
  EXPECT_EQ(one_line("\xC0\xAF"), "\\xC0\\xAF");                    // overlong
  EXPECT_EQ(one_line("\xED\xA0\x80"), "\\xED\\xA0\\x80");           // a surrogate
  EXPECT_EQ(one_line("\xF5\x80\x80\x80"), "\\xF5\\x80\\x80\\x80");  // beyond Unicode
}

TEST(OneLine, CutsWhatIsLong) {
  EXPECT_EQ(one_line("abcdef", 3), "abc…");
  EXPECT_EQ(one_line("abc", 3), "abc");
  EXPECT_EQ(in_quotes("abc"), "\"abc\"");
  EXPECT_LT(in_quotes(std::string(100'000, '\n')).size(), 70u);
}

TEST(IsUtf8, IsOfWholeCharactersWithoutNuls) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("aö眉🙂\n"));
  EXPECT_FALSE(is_utf8("a\xE9"));
  EXPECT_FALSE(is_utf8(std::string_view("a\0b", 3)));
}

TEST(Utf8Length, CountsTheBytesOfOneCharacter) {
  EXPECT_EQ(utf8_length("a"), 1);
  EXPECT_EQ(utf8_length("ö"), 2);
  EXPECT_EQ(utf8_length("眉"), 3);
  EXPECT_EQ(utf8_length("🙂"), 4);
  EXPECT_EQ(utf8_length(""), 0);
  EXPECT_EQ(utf8_length("\x80"), 0);
}

}  // namespace
}  // namespace mien
