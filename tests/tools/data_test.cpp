// mien stimuli: experiments as faces.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/pictures/read_back.h"
#include "tests/tools/data_fixture.h"

namespace mien {
namespace {

TEST_F(DataTest, AManifestDrawsTheSameBytesAgain) {
  const Ran ran = stimuli(plan(R"("factors": [
      {"name": "person", "people": 2, "mean": true}, {"emotion": "joy", "values": [0, 0.5]},
      {"caricature": [1, 1.5]}, {"picture": ["whole", "mirror", "left", "right"]}])"));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(count("shown"), 3u * 2 * 2 * 4 + 1);
  const std::string manifest = (folder_ / "shown" / "manifest.json").string();
  const Ran again = run_mien({"stimuli", manifest, "-o", path("again")});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(text("shown/0048.png"), text("again/0048.png"));
  EXPECT_EQ(text("shown/manifest.json"), text("again/manifest.json"));
  std::string changed = text("shown/manifest.json");
  const std::size_t at = changed.find("\"eye.size\": ");
  changed.replace(at, changed.find(',', at) - at, "\"eye.size\": 1.19");
  const Ran other = run_mien({"stimuli", file("changed.json", changed), "-o", path("other")});
  EXPECT_NE(other.code, 0);
  EXPECT_NE(
      other.err.find("1 of 48 pictures are not the ones it tells of; the first is \"0001.png\""),
      std::string::npos)
      << other.err;
  EXPECT_FALSE(std::filesystem::exists(path("other/manifest.json")));
}

TEST_F(DataTest, HalvesAndMirrorsAreOfTheWholePicture) {
  ASSERT_EQ(
      stimuli(
          plan(R"("factors": [{"people": 1}, {"picture": ["whole", "mirror", "left", "right"]}])"))
          .code,
      0);
  const auto whole = test::read(path("shown/0001.png")),
             mirror = test::read(path("shown/0002.png")), left = test::read(path("shown/0003.png")),
             right = test::read(path("shown/0004.png"));
  const int width = whole.spec.width, channels = whole.spec.nchannels;
  const auto pixel = [&](const auto& of, int x, int y) {
    return of.channels[std::size_t((y * width + x) * channels)];
  };
  for (int y = 0; y < whole.spec.height; ++y)
    for (int x = 0; x < width; ++x) {
      const int other = width - 1 - x;
      EXPECT_EQ(pixel(mirror, x, y), pixel(whole, other, y));
      EXPECT_EQ(pixel(left, x, y), pixel(whole, std::min(x, other), y));
      EXPECT_EQ(pixel(right, x, y), pixel(whole, std::max(x, other), y));
    }
}

TEST_F(DataTest, NamesOfPicturesAreText) {
  const Ran ran = run_mien({"sheet", "--people", "2", "-o", path("s.png"), "--cell", "16"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const Ran bad = run_mien(
      {"sheet", "A66CB-AA5S0-14", "--picture", "a\xE9: --emotion joy", "-o", path("t.png")});
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.err.find("is not UTF-8"), std::string::npos) << bad.err;
}

/// What changes nothing in the pictures, or stops on the way, is told at its place.
TEST_F(DataTest, FactorsWithoutAnEffectAreTold) {
  const Ran hidden = stimuli(plan(R"("face": {"parts": {"headwear": "hijab"}}, "factors": [
      {"part": "hair", "values": ["bob", "crop"]}, {"emotion": "joy", "values": [0, 1]}])"));
  EXPECT_EQ(hidden.code, 0) << hidden.err;
  EXPECT_NE(hidden.err.find("/factors/0/part: 0001.png and 0003.png are the same picture, though "
                            "\"hair\" is bob and crop"),
            std::string::npos)
      << hidden.err;
  EXPECT_EQ(hidden.err.find("factors/1"), std::string::npos) << hidden.err;
  const Ran far = stimuli(plan(R"("factors": [{"people": 3}, {"caricature": [1, 10]}])"));
  EXPECT_EQ(far.code, 0) << far.err;
  EXPECT_NE(far.err.find("/factors/1/caricature: at 10 "), std::string::npos) << far.err;
  EXPECT_NE(far.err.find(" stop at the end of their range"), std::string::npos) << far.err;
  const Ran near = stimuli(plan(R"("factors": [{"people": 3}, {"caricature": [0.9, 1]}])"));
  EXPECT_EQ(near.err, "");
}

TEST_F(DataTest, EmotionsTakeTurnsInOneFactor) {
  ASSERT_EQ(stimuli(plan(R"("factors": [{"name": "feeling", "emotions": ["joy", "fear"],
                                         "values": [0.5, 1]}])"))
                .code,
            0);
  EXPECT_EQ(count("shown"), 2u * 2 + 1);
  const std::string manifest = text("shown/manifest.json");
  for (const char* levels : {R"({"feeling": "joy", "feeling_strength": "0.5"})",
                             R"({"feeling": "joy", "feeling_strength": "1"})",
                             R"({"feeling": "fear", "feeling_strength": "0.5"})",
                             R"({"feeling": "fear", "feeling_strength": "1"})"})
    EXPECT_NE(manifest.find(levels), std::string::npos) << levels << manifest;
  EXPECT_EQ(stimuli(plan(R"("factors": [{"emotion": "fear", "values": [1]}])"), "alone").code, 0);
  EXPECT_EQ(text("alone/0001.png"), text("shown/0004.png"));
}

/// A picture's column of a strength is the factor's own.
TEST_F(DataTest, FactorsWithTheSameColumnAreRefused) {
  const Ran same = stimuli(plan(R"("factors": [{"name": "a", "emotions": ["joy"], "values": [1]},
                                              {"name": "a_strength", "control": "blink", "values": [0]}])"));
  EXPECT_EQ(same.code, 1);
  EXPECT_NE(same.err.find("two factors are called \"a_strength\""), std::string::npos) << same.err;
  const Ran none = stimuli(plan(R"("factors": [{"codes": "A66CB-AA5S0-14"}])"));
  EXPECT_NE(none.err.find("/factors/0/codes: expected an array"), std::string::npos) << none.err;
  // The second column's factor is found by its name.
  const Ran hidden =
      stimuli(plan(R"("face": {"code": "A66CB-AA5S0-14", "parts": {"headwear": "hijab"}},
      "factors": [{"name": "f", "emotions": ["joy"], "values": [0.5, 1]}, {"part": "hair", "values": ["bob", "crop"]}])"));
  EXPECT_NE(hidden.err.find("/factors/1/part: "), std::string::npos) << hidden.err;
}

TEST_F(DataTest, PeopleWithoutAnExpressionDoNotGrin) {
  const std::string factors = R"("factors": [{"people": 60, "seed": "grins"}])";
  ASSERT_EQ(stimuli(plan(factors)).code, 0);
  ASSERT_EQ(stimuli(plan(R"("neutral": false, )" + factors), "moody").code, 0);
  const std::string neutral = text("shown/manifest.json"), moody = text("moody/manifest.json");
  int grins = 0;
  for (const char* mouth : {"grin", "toothy", "wide_braces", "soft_gap", "downturned", "crooked"}) {
    const std::string chosen = std::string("\"mouth\": \"") + mouth + '"';
    EXPECT_EQ(neutral.find(chosen), std::string::npos) << chosen;
    grins += moody.find(chosen) != std::string::npos;
  }
  EXPECT_GE(grins, 3);
}

TEST_F(DataTest, PicturesOfAnEarlierPlanAreRemoved) {
  ASSERT_EQ(stimuli(plan(R"("factors": [{"people": 4}])")).code, 0);
  file("shown/0009.png", "of somebody else");
  file("shown/0004.png", "painted over");
  const Ran fewer = stimuli(plan(R"("factors": [{"people": 2}])"));
  EXPECT_EQ(fewer.code, 0) << fewer.err;
  EXPECT_EQ(fewer.out, "2 pictures; 1 of an earlier plan are removed\n");
  EXPECT_EQ(count("shown"), 2u + 1 + 2) << "what no manifest tells stays";
  ASSERT_EQ(stimuli(plan(R"("factors": [{"people": 1}])"), "one").code, 0);
  const Ran again = run_mien({"stimuli", path("one/manifest.json"), "-o", path("shown")});
  EXPECT_EQ(again.out, "1 pictures, all as the manifest says; 1 of an earlier plan are removed\n");
}

TEST_F(DataTest, PairsDifferInOneFactorAlone) {
  ASSERT_EQ(
      stimuli(plan(R"("factors": [{"name": "person", "people": 3}, {"number": "smile", "steps": 5}],
                            "pairs": "smile")"))
          .code,
      0);
  EXPECT_EQ(count("shown"), 3u * 2 + 1);
  EXPECT_TRUE(std::filesystem::exists(path("shown/0003b.png")));
  EXPECT_NE(text("shown/0001a.png"), text("shown/0001b.png"));
  const std::string manifest = text("shown/manifest.json");
  EXPECT_NE(manifest.find("\"smile\": \"-0.3\""), std::string::npos);
  EXPECT_EQ(manifest.find("\"smile\": \"0.35\""), std::string::npos);
}

TEST_F(DataTest, ASampleIsTheSameForItsSeed) {
  const std::string factors =
      R"("factors": [{"number": "smile", "steps": 10}, {"number": "lips", "steps": 10}],)";
  ASSERT_EQ(stimuli(plan(factors + R"("sample": 7, "seed": "a")")).code, 0);
  const std::string first = text("shown/manifest.json");
  ASSERT_EQ(stimuli(plan(factors + R"("sample": 7, "seed": "a")")).code, 0);
  EXPECT_EQ(first, text("shown/manifest.json"));
  ASSERT_EQ(stimuli(plan(factors + R"("sample": 7, "seed": "b")")).code, 0);
  EXPECT_NE(first, text("shown/manifest.json"));
  EXPECT_EQ(count("shown"), 8u);
}

/// Each of 10^12 combinations is as likely; twice as many are those and others.
TEST_F(DataTest, ASampleNeedsNotTheWholeProduct) {
  const std::string factors =
      R"("factors": [{"number": "smile", "steps": 1000}, {"number": "lips", "steps": 1000},
      {"number": "jaw", "steps": 1000}, {"number": "cheek", "steps": 1000}],)";
  ASSERT_EQ(stimuli(plan(factors + R"("sample": 4)")).code, 0);
  const auto shas = [&] {
    std::set<std::string> all;
    const std::string manifest = text("shown/manifest.json");
    for (std::size_t at = 0; (at = manifest.find("\"sha256\": ", at)) != std::string::npos; ++at)
      all.insert(manifest.substr(at, 75));
    return all;
  };
  const std::set<std::string> four = shas();
  EXPECT_EQ(four.size(), 4u);
  ASSERT_EQ(stimuli(plan(factors + R"("sample": 8)")).code, 0);
  const std::set<std::string> eight = shas();
  EXPECT_EQ(eight.size(), 8u);
  EXPECT_TRUE(std::ranges::includes(eight, four));
  // As many as there are: each of them once, in the order of all.
  const std::string few =
      R"("factors": [{"number": "smile", "steps": 3}, {"number": "lips", "steps": 2}])";
  ASSERT_EQ(stimuli(plan(few)).code, 0);
  const std::string all = text("shown/manifest.json");
  ASSERT_EQ(stimuli(plan(few + R"(, "sample": 6)")).code, 0);
  EXPECT_EQ(all, text("shown/manifest.json"));
}

TEST_F(DataTest, WhatThePlansFaceIsWithoutNobodyHas) {
  const auto people = [&](const std::string& face) {
    const std::string factor = R"("factors": [{"people": 60, "seed": "bare"}])";
    EXPECT_EQ(stimuli(plan(R"("face": )" + face + ", " + factor)).code, 0);
    return text("shown/manifest.json");
  };
  const auto has = [](const std::string& manifest, const std::string& family) {
    return manifest.find("\"" + family + "\": \"") != std::string::npos;
  };
  const std::string all = people("{}");
  for (const char* family : {"glasses", "beard", "moustache"}) EXPECT_TRUE(has(all, family));
  const std::string bare =
      people(R"({"parts": {"glasses": null, "beard": null, "moustache": "none"}})");
  for (const char* family : {"glasses", "beard", "moustache"}) EXPECT_FALSE(has(bare, family));
  EXPECT_TRUE(has(bare, "hair"));
}

TEST_F(DataTest, ASeedIsAWordOrTheNumberOfThatName) {
  const auto people = [&](const std::string& seed) {
    const std::string factor = R"("factors": [{"people": 3, "seed": )" + seed + "}]";
    EXPECT_EQ(stimuli(plan(factor)).code, 0);
    return text("shown/manifest.json");
  };
  const std::string by_word = people(R"("42")");
  EXPECT_EQ(by_word, people("42"));
  EXPECT_NE(by_word, people("43"));
}

TEST_F(DataTest, WrongPlansAreToldBeforeAnythingIsDrawn) {
  for (
      const auto& [rest, sentence] : {
          WrongData{
              R"("factors": [{"number": "smile", "steps": 1000}, {"number": "lips", "steps": 1000},
                                {"number": "jaw", "steps": 1000}])",
              "1000 × 1000 × 1000 = 1000000000 pictures; a plan has 100000 at most"},
          WrongData{R"("factors": [])", "expected 1 to 32 factors"},
          WrongData{R"("factors": [{"name": "x"}])", "a factor varies one of"},
          WrongData{R"("factor": [])",
                    "no key of a plan named \"factor\"; did you mean \"factors\"?"},
          WrongData{R"("factors": [{"people": 2, "sede": "a"}])",
                    "no key of a factor named \"sede\"; did you mean \"seed\"?"},
          WrongData{R"("factors": [{"emotion": "joy"}])", "/factors/0: \"values\" are missing"},
          WrongData{R"("factors": [{"people": 2, "seed": 1.5}])",
                    "/factors/0/seed: expected a word or a whole number, got 1.5"},
          WrongData{R"("factors": [{"people": 2, "seed": -1}])", "a whole number, got -1"},
          WrongData{R"("factors": [{"emotions": [], "values": [1]}])", "no emotion is named"},
          WrongData{R"("factors": [{"emotions": ["joy", "joy"], "values": [1]}])",
                    "/factors/0/emotions/1: joy is a level already"},
          WrongData{R"("factors": [{"emotions": ["joi"], "values": [1]}])",
                    "/factors/0/emotions/0: no emotion named \"joi\"; did you mean \"joy\"?"},
          WrongData{R"("factors": [{"emotions": ["joy"], "steps": 3, "equal": "picture"}])",
                    "/factors/0/equal: steps are equal along one emotion"},
          WrongData{
              R"("factors": [{"emotion": "joy", "steps": 2}, {"emotions": ["fear", "joy"], "steps": 2}])",
              "/factors/1/emotions: emotions is varied by \"joy\" already"},
          WrongData{R"("factors": [{"number": "smlie", "steps": 2}])", "did you mean \"smile\"?"},
          WrongData{R"("factors": [{"number": "smile", "steps": 2, "to": 7}])",
                    "smile goes from -0.3 to 1, got 7"},
          WrongData{
              R"("factors": [{"number": "smile", "steps": 2}, {"number": "smile", "steps": 2}])",
              "two factors are called \"smile\""},
          WrongData{R"("factors": [{"codes": ["ZAAAA"]}])", "plan.json:1:"},
          WrongData{R"("factors": [{"name": "a", "number": "smile", "steps": 2},
                                   {"name": "b", "number": "smile", "steps": 3}])",
                    "/factors/1/number: smile is varied by \"a\" already"},
          WrongData{R"("factors": [{"name": "a", "emotion": "joy", "steps": 2},
                                   {"name": "b", "control": "emotion.joy", "steps": 3}])",
                    "emotion.joy is varied by \"a\" already"},
          WrongData{R"("factors": [{"name": "a", "people": 2}, {"name": "b", "people": 3}])",
                    "people is varied by \"a\" already"},
          WrongData{R"("factors": [{"emotion": "joy", "values": [0.5, 1, 0.5]}])",
                    "/factors/0/values/2: 0.5 is a level already"},
          WrongData{R"("factors": [{"emotion": "joy", "steps": 3, "from": 0.5, "to": 0.5}])",
                    "3 steps from 0.5 to 0.5 are equal"},
          WrongData{R"("factors": [{"part": "hair", "values": ["bob", "bob"]}])",
                    "/factors/0/values/1: bob is a level already"},
          WrongData{R"("factors": [{"picture": ["whole", "whole"]}])", "whole is a level already"},
          WrongData{R"("factors": [{"people": 2}, {"caricature": [1, 1e6]}])",
                    "a caricature goes from -10 to 10, got 1000000"},
          WrongData{R"("factors": [{"emotion": "joy", "values": [0, 50]}])",
                    "/factors/0/emotion: \"emotion.joy\" goes from 0 to 1, got 50"},
          WrongData{R"("factors": [{"emotion": "happiness", "steps": 2}])",
                    "no emotion named \"happiness\"; did you mean \"joy\"?"},
          WrongData{R"("factors": [{"emotion": "xyzzy", "steps": 2}])",
                    "; there are \"joy\", \"sadness\", "},
          WrongData{R"("factors": [{"caricature": [2]}])", "mean of people"},
          WrongData{R"("factors": [{"control": "blnk", "values": [1]}])",
                    "did you mean \"blink\"?"},
          WrongData{R"("factors": [{"number": "smile", "steps": 2}], "pairs": "smle")",
                    "did you mean \"smile\"?"},
          WrongData{R"("factors": [{"number": "smile", "steps": 2}], "sample": 3)",
                    "from 1 to 2, got 3"},
          WrongData{
              R"("factors": [{"number": "smile", "steps": 1000}, {"number": "lips", "steps": 1000}],
                                "sample": 100001)",
              "from 1 to 100000, got 100001"},
          WrongData{
              R"("factors": [{"number": "smile", "steps": 1000}, {"number": "lips", "steps": 1000},
                                {"name": "x", "number": "jaw", "steps": 2}], "pairs": "x", "sample": 50001)",
              "from 1 to 50000, got 50001"},
          WrongData{R"("factors": [{"number": "smile", "steps": 2}], "seed": "")", "plan.json:1:"},
          WrongData{R"("factors": [{"people": 2, "seed": ""}])", "an empty word is no seed"},
      }) {
    const Ran ran = stimuli(plan(rest));
    EXPECT_NE(ran.code, 0) << rest;
    EXPECT_NE(ran.err.find(sentence), std::string::npos) << rest << ran.err;
    if (std::filesystem::exists(path("shown"))) {
      EXPECT_EQ(count("shown"), 0u) << rest;
    }
  }
}

/// What steps are equal in is what the pictures show.
TEST_F(DataTest, StepsThatAreEqualInDisplacementAre) {
  ASSERT_EQ(
      stimuli(
          plan(
              R"("factors": [{"people": 1}, {"emotion": "surprise", "steps": 5, "equal": "displacement"}])"))
          .code,
      0);
  const std::string manifest = text("shown/manifest.json");
  std::vector<double> moved;
  for (std::size_t at = 0; (at = manifest.find("\"displacement\": ", at)) != std::string::npos;
       ++at)
    moved.push_back(std::stod(manifest.substr(at + 16)));
  ASSERT_EQ(moved.size(), 5u);
  EXPECT_EQ(moved[0], 0);
  EXPECT_GT(moved[4], 0.001);
  EXPECT_NEAR(moved[1], moved[4] / 4,
              0.12 * moved[4]);  // chords from rest are a little shorter than the way
}

}  // namespace
}  // namespace mien
