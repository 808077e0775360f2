#include "lib/file/json/frame_file.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(FrameFile, ReadsNumbersAndPointsByName) {
  const auto frame = read_frame_text(R"({"jawOpen": 0.5, "mouth.left/points/2": [60, 150]})", "f");
  ASSERT_TRUE(frame) << sentence(frame.error());
  ASSERT_EQ(frame->size(), 2u);
  EXPECT_EQ((*frame)[0].name, "jawOpen");
  EXPECT_EQ((*frame)[0].values, std::vector<double>{0.5});
  EXPECT_EQ((*frame)[1].values, (std::vector<double>{60, 150}));
  EXPECT_EQ((*frame)[0].where, "f:1:13: /jawOpen");
}

TEST(FrameFile, FindsAFrameInsideAnObject) {
  const auto frame = read_frame_text(R"({"timestamp": "1", "blendShapes": {"jawOpen": 0.5}})", "f");
  ASSERT_TRUE(frame) << sentence(frame.error());
  EXPECT_EQ(frame->size(), 1u);
}

TEST(FrameFile, SaysWhatIsWrongAndWhere) {
  const auto said = [](std::string_view text) {
    return sentence(read_frame_text(text, "f").error());
  };
  EXPECT_EQ(said(R"({"jawOpen": "wide"})"),
            "f:1:13: /jawOpen: expected 1 to 4 numbers, got a string");
  EXPECT_EQ(said("[]"), "f:1:1: expected an object, got an array");
  EXPECT_FALSE(read_frame("/no/such/file"));
}

TEST(FrameFile, SurvivesDamage) {
  std::string text = R"({"blendShapes": {"jawOpen": 0.5, "x": [1, 2]}})";
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(read_frame_text(text.substr(0, length)));
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char c : {'"', '{', ']', '9', '\0'}) {
      const char was = std::exchange(text[at], c);
      if (const auto frame = read_frame_text(text); !frame) {
        EXPECT_FALSE(frame.error().what.empty());
      }
      text[at] = was;
    }
}

}  // namespace
}  // namespace mien
