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

/// FaceLandmarker's result, its parts, and its shares by name.
TEST(FrameFile, TakesWhatMediaPipeGives) {
  const std::string list =
      R"([{"index": 0, "score": 1e-7, "categoryName": "_neutral", "displayName": ""},
          {"index": 1, "score": 0.5, "categoryName": "jawOpen", "displayName": ""}])";
  const std::string result =
      R"({"faceLandmarks": [[{"x": 0}]], "faceBlendshapes": [{"headIndex": -1,
      "headName": "", "categories": )" +
      list + "}]}";
  for (const std::string& text : {list, R"({"categories": )" + list + "}", result,
                                  std::string(R"({"_neutral": 1e-7, "jawOpen": 0.5})"),
                                  std::string(R"([{"category_name": "jawOpen", "score": 0.5}])")}) {
    const auto frame = read_frame_text(text, "f");
    ASSERT_TRUE(frame) << text << sentence(frame.error());
    ASSERT_EQ(frame->size(), 1u) << text;
    EXPECT_EQ((*frame)[0].name, "jawOpen");
    EXPECT_EQ((*frame)[0].values, std::vector<double>{0.5});
  }
}

TEST(FrameFile, HidesNoNumbersBesideAFrame) {
  const auto said = [](std::string_view text) {
    const auto frame = read_frame_text(text, "f");
    return frame ? "is read" : sentence(frame.error());
  };
  const std::string inside = ", which is the frame: put it inside, or leave it out";
  EXPECT_EQ(said(R"({"blendShapes": {"jawOpen": 0.5}, "mouthPucker": 1})"),
            "f:1:50: /mouthPucker: stands beside \"blendShapes\"" + inside);
  EXPECT_EQ(said(R"({"blendShapes": {"jawOpen": 0.5}, "points": {"a": 1}})"),
            "f:1:45: /points: stands beside \"blendShapes\"" + inside);
  EXPECT_EQ(said(R"({"faceBlendshapes": [{"categories": []}, {"categories": []}]})"),
            "f:1:21: /faceBlendshapes: holds 2 faces; a frame is of one");
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
