#include "tools/mien/serve/face_request.h"

#include <mien/face_code.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "tests/support/process/run_command.h"

namespace mien::command {
namespace {

using Texts = std::vector<std::string>;

FaceRequest understood(const std::string& target) {
  auto read = read_face_request(target, {});
  if (const auto* refusal = std::get_if<Refusal>(&read)) {
    ADD_FAILURE() << target << ": " << sentence(refusal->error);
    return {};
  }
  return std::get<FaceRequest>(std::move(read));
}

/// "400 SENTENCE"
std::string refused(const std::string& target, const RequestLimits& limits = {}) {
  const auto read = read_face_request(target, limits);
  const auto* refusal = std::get_if<Refusal>(&read);
  return refusal ? std::to_string(refusal->code) + " " + sentence(refusal->error) : "understood";
}

TEST(FaceRequest, IsAFaceInAFormat) {
  const FaceRequest png = understood("/A66CB-AA5S0-14.png");
  EXPECT_EQ(png.arguments.posed.face, "A66CB-AA5S0-14");
  EXPECT_EQ(png.format, FaceFormat::png);
  EXPECT_EQ(png.arguments.size, "256");
  EXPECT_FALSE(png.of_word);
  EXPECT_EQ(understood("/a66cbaa5s014.svg").format, FaceFormat::svg);
  EXPECT_EQ(understood("/a66cbaa5s014.svg").arguments.posed.face, "A66CB-AA5S0-14");
  EXPECT_EQ(understood("/A66CB-AA5S0-14.webp").format, FaceFormat::webp);
}

TEST(FaceRequest, IsSomebodyForAnyWord) {
  const auto face_of = [](const std::string& word) {
    const FaceRequest request = understood("/seed/" + word + ".png");
    EXPECT_TRUE(request.of_word);
    return request.arguments.posed.face;
  };
  const auto code_of = [](const std::string& word) {
    return face_code_text({.seed = seed_from_word(word), .held = {}});
  };
  EXPECT_EQ(face_of("ada"), code_of("ada"));
  EXPECT_EQ(face_of("ada%20l%C3%B6"), code_of("ada l\xc3\xb6"));
  EXPECT_EQ(face_of("ada+b"), code_of("ada+b")) << "a path is no form";
  EXPECT_EQ(face_of("a.b@c.org"), code_of("a.b@c.org"));
  EXPECT_EQ(face_of("..%2F..%2Fetc%2Fpasswd"), code_of("../../etc/passwd")) << "a word, no file";
  EXPECT_EQ(face_of("../../etc/passwd"), code_of("../../etc/passwd"));
}

TEST(FaceRequest, TakesTheCommandsWords) {
  const FaceRequest request = understood(
      "/A66CB-AA5S0-14.png?size=64x48&emotion=joy%3D0.5&emotion=left.anger&style=ink&blink=.3&"
      "background=%23ffcc00&time=1.5&clip=idle&neutral&set=jaw.open%3D0.2");
  const RenderArguments& asked = request.arguments;
  EXPECT_EQ(asked.size, "64x48");
  EXPECT_EQ(asked.posed.emotions, (Texts{"joy=0.5", "left.anger"}));
  EXPECT_EQ(asked.posed.style, "ink");
  EXPECT_EQ(asked.posed.blink, ".3");
  EXPECT_EQ(asked.background, "#ffcc00");
  EXPECT_EQ(asked.posed.time, "1.5");
  EXPECT_EQ(asked.posed.clips, Texts{"idle"});
  EXPECT_TRUE(asked.posed.neutral);
  EXPECT_EQ(asked.posed.settings, Texts{"jaw.open=0.2"});
}

TEST(FaceRequest, HasShorterWords) {
  EXPECT_EQ(understood("/seed/a.png?transparent").arguments.background, "transparent");
  EXPECT_EQ(understood("/seed/a.png?transparent=0").arguments.background, std::nullopt);
  EXPECT_EQ(understood("/seed/a.png?yaw=-20&gaze=0.05,-.01&viseme=oh&viseme=viseme_PP=.4")
                .arguments.posed.settings,
            (Texts{"yaw=-20", "gaze.x=0.05", "gaze.y=-.01", "viseme.O=1", "viseme.PP=.4"}));
  const FaceRequest sides = understood("/seed/a.png?width=30&height=40");
  EXPECT_EQ(sides.width, "30");
  EXPECT_EQ(sides.height, "40");
  EXPECT_EQ(sides.arguments.size, std::nullopt);
}

TEST(FaceRequest, MeansTheSameInAnyOrder) {
  const auto meaning = [](const std::string& target) { return understood(target).meaning; };
  EXPECT_EQ(meaning("/A66CB-AA5S0-14.png?blink=1&style=ink"),
            meaning("/a66cbaa5s014.png?style=in%6b&&blink=1&#x"));
  EXPECT_EQ(meaning("/seed/ada.png"),
            meaning("/" + understood("/seed/ada.png").arguments.posed.face + ".png"));
  const Texts others{"/seed/a.png",
                     "/seed/a.svg",
                     "/seed/b.png",
                     "/seed/a.png?blink=1",
                     "/seed/a.png?bias=1",
                     "/seed/a.png?emotion=joy&emotion=anger",
                     "/seed/a.png?emotion=anger&emotion=joy",
                     "/seed/a.png?emotion=joy%26emotion%3D5:anger",
                     "/seed/a.png?emotion=joy%26emotion%3Danger",
                     "/seed/a.png?neutral",
                     "/seed/a.png?width=256&height=256"};
  std::set<std::string> meanings;
  for (const std::string& one : others) meanings.insert(meaning(one));
  EXPECT_EQ(meanings.size(), others.size());
}

TEST(FaceRequest, IsRefusedByName) {
  EXPECT_EQ(refused("/seed/a.png?emotoin=joy"),
            "400 no key named \"emotoin\"; did you mean \"emotion\"?");
  EXPECT_EQ(refused("/seed/a.png?xyzzy"), "400 no key named \"xyzzy\"");
  EXPECT_EQ(refused("/seed/a.png?style=inkk"),
            "400 style=inkk: no style named \"inkk\"; did you mean \"ink\"?");
  EXPECT_EQ(refused("/seed/a.png?size=0x5"),
            "400 size=0x5: expected WxH, or the longer side; whole pixels from 1 to 1048576");
  EXPECT_EQ(refused("/seed/a.png?size=1025"),
            "400 size=1025: this server draws 1024 pixels a side at most");
  EXPECT_EQ(refused("/seed/a.png?size=9x65", {.most_side = 64}),
            "400 size=9x65: this server draws 64 pixels a side at most");
  EXPECT_EQ(refused("/seed/a.png?width=0"), "400 width=0: expected a whole number from 1 to 1024");
  EXPECT_EQ(refused("/seed/a.png?size=5&height=5"), "400 size=5: width and height are said, too");
  EXPECT_EQ(refused("/seed/a.png?blink=1&blink=0"), "400 blink: may be given only once");
  EXPECT_EQ(refused("/seed/a.png?neutral=maybe"),
            "400 neutral=maybe: expected 1 or 0, true or false");
  EXPECT_EQ(refused("/seed/a.png?background=ffffff&transparent"),
            "400 transparent: the background is said already");
  EXPECT_EQ(refused("/seed/a.png?gaze=1"),
            "400 gaze=1: expected X,Y, as gaze.x and gaze.y take them");
  EXPECT_EQ(refused("/seed/a.png?size=%g1"),
            "400 size=%g1: a % has no two hexadecimal digits behind it");
  EXPECT_EQ(refused("/seed/a.png?seed=%ff"), "400 seed=%ff: this is no text in UTF-8");
  EXPECT_EQ(refused("/seed/a.png?" + std::string(kLongestTarget, 'a')),
            "414 this address has 2060 bytes, 2048 are read at most");
}

TEST(FaceRequest, KnowsNoFiles) {
  for (const char* key : {"output", "motion", "speech", "morphs", "basis", "weights", "error-map",
                          "debug", "stats", "threads", "memory", "most-steps"})
    EXPECT_TRUE(
        refused(std::string("/seed/a.png?") + key + "=/etc/passwd").starts_with("400 no key named"))
        << key;
  const std::string nothing = ": there is nothing here; /CODE.png and /seed/WORD.png are faces";
  EXPECT_EQ(refused("/"), "404 /" + nothing);
  EXPECT_EQ(refused(""), "404 " + nothing.substr(2));
  EXPECT_EQ(refused("/faces/toon"), "404 /faces/toon" + nothing);
  EXPECT_EQ(refused("/../../a.b/c"), "404 /../../a.b/c" + nothing);
  EXPECT_EQ(refused("/x/a66cbaa5s014.png"), "404 /x/a66cbaa5s014" + nothing);
  EXPECT_EQ(refused("/.png"), "404 /" + nothing);
  EXPECT_EQ(refused("/a66cbaa5s014.gif"), "404 .gif: pictures are .png, .svg or .webp here");
  EXPECT_EQ(refused("/A66CB-AA5S0-15.png"),
            "404 code A66CB-AA5S0-15: a sign is wrong, or two are swapped: its check sign does not "
            "fit");
  EXPECT_EQ(refused("/toon.png"),
            "404 code toon: this is no code; /seed/toon.png is somebody for any word");
  EXPECT_EQ(refused("/seed/.png"), "400 /seed/: a word is needed: /seed/WORD.png");
  EXPECT_EQ(refused("/seed/%00.png"), "400 /seed/%00: this is no text in UTF-8");
}

// What the command can do to a picture without a file, an address can, too.
TEST(FaceRequest, HasEveryOptionOfRender) {
  const std::string help = test::run_mien({"render", "-h"}).out;
  const std::regex option("\n  (?:-\\w,)?--([a-z-]+)");
  const std::vector<std::string_view> keys = request_keys();
  const std::set<std::string> elsewhere{"help",   "output", "threads",   "memory",   "most-steps",
                                        "stats",  "debug",  "error-map", "progress", "motion",
                                        "speech", "morphs", "basis",     "weights"};
  int found = 0;
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at, ++found)
    EXPECT_NE(elsewhere.contains((*at)[1]), std::ranges::count(keys, (*at)[1].str()) == 1)
        << (*at)[1];
  EXPECT_GE(found, 30);
}

TEST(FaceRequest, SaysErrorsInItsOwnWords) {
  const Error error = in_request_words(
      {"--blend linear", "SVG viewers mix colours as encoded: --blend srgb; a -- b, -5"});
  EXPECT_EQ(error.where, "blend=linear");
  EXPECT_EQ(error.what, "SVG viewers mix colours as encoded: blend srgb; a -- b, -5");
  EXPECT_EQ(in_request_words({"yaw=99", "no"}).where, "yaw=99");
}

}  // namespace
}  // namespace mien::command
