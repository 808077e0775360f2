#include <mien/face_code.h>

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

const FaceCode kHeld{.seed = 0x123456789abcd, .held = {{6, 3}, {200, 1023}}};

TEST(FaceCode, IsReadBack) {
  for (const FaceCode& code : {FaceCode{}, kHeld, FaceCode{.seed = (std::uint64_t{1} << 50) - 1}}) {
    const auto read = read_face_code(face_code_text(code));
    ASSERT_TRUE(read) << read.error().what;
    EXPECT_EQ(*read, code);
  }
}

TEST(FaceCode, DoesNotCareForCaseHyphensAndLookalikes) {
  const std::string text = face_code_text({.seed = 0});
  EXPECT_EQ(text.substr(1), "0000-00000-0" + text.substr(13));
  std::string other;
  for (const char c : text)
    if (c != '-') other += c == '0' ? 'o' : char(std::tolower(c));
  EXPECT_EQ(read_face_code(other).value(), read_face_code(text).value());
}

TEST(FaceCode, FindsEveryWrongSignAndEverySwapOfNeighbours) {
  constexpr std::string_view kSigns = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  const std::string text = face_code_text(kHeld);
  int wrong = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '-' || text[i] == '~') continue;
    for (const char sign : kSigns) {
      if (sign == text[i]) continue;
      std::string slip = text;
      slip[i] = sign;
      EXPECT_FALSE(read_face_code(slip)) << slip;
      ++wrong;
    }
  }
  EXPECT_EQ(wrong, 31 * 20);
  std::string signs;
  for (const char c : text)
    if (c != '-' && c != '~') signs += c;
  for (std::size_t i = 0; i + 1 < signs.size(); ++i) {
    if (signs[i] == signs[i + 1]) continue;
    std::string slip = signs;
    std::swap(slip[i], slip[i + 1]);
    EXPECT_FALSE(read_face_code(slip.insert(12, "~"))) << slip;
  }
}

TEST(FaceCode, SaysWhatIsWrong) {
  const auto what = [](std::string_view text) { return read_face_code(text).error().what; };
  EXPECT_NE(what("Z0000").find("12 signs"), std::string::npos) << what("Z0000");
  EXPECT_NE(what("Z0000-0000U-0").find("no sign"), std::string::npos);
  EXPECT_NE(what(face_code_text({}) + "~00").find("four signs"), std::string::npos);
  EXPECT_NE(what(std::string(100000, '0')).find("longer"), std::string::npos);
  EXPECT_FALSE(read_face_code(""));
}

TEST(FaceCode, LooksLikeOneOrLikeAFile) {
  EXPECT_TRUE(looks_like_face_code(face_code_text(kHeld)));
  EXPECT_TRUE(
      looks_like_face_code("Z0000-00000-01"));  // a wrong one, too: it gets a better sentence
  EXPECT_FALSE(looks_like_face_code("toon.face.json"));
  EXPECT_FALSE(looks_like_face_code("faces/a"));
  EXPECT_FALSE(looks_like_face_code(""));
}

TEST(FaceCode, WordsAreSeedsOfTheirOwn) {
  EXPECT_EQ(seed_from_word("hello"), seed_from_word("hello"));
  std::set<std::uint64_t> seeds;
  for (int i = 0; i < 10000; ++i) seeds.insert(seed_from_word(std::to_string(i)));
  EXPECT_EQ(seeds.size(), 10000u);
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << FaceCode::kSeedBits);
  EXPECT_EQ(seed_from_word("hello"), read_face_code("A66CB-AA5S0-14").value().seed);  // for ever
}

}  // namespace
}  // namespace mien
