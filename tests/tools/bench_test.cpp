// mien bench: what it says of a frame.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;

nlohmann::json benched(std::vector<std::string> more) {
  std::vector<std::string> words{"bench", face_path("toon"), "--json", "--threads", "1"};
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = run_mien(words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return nlohmann::json::parse(ran.out);
}

TEST(Bench, TellsTheFrameAndItsParts) {
  const auto said = benched({"--size", "64x48", "--repeat", "5", "--time", "1"});
  EXPECT_EQ(said["width"], 64);
  EXPECT_EQ(said["height"], 48);
  EXPECT_EQ(said["threads"], 1);
  EXPECT_EQ(said["repeat"], 5);
  EXPECT_EQ(said["face"], "toon.face.json");
  const double least = said["min_ms"], median = said["median_ms"];
  EXPECT_GT(least, 0);
  EXPECT_GE(median, least);
  for (const char* part : {"pose", "scene", "draw"}) EXPECT_GT(said["parts"][part], 0) << part;
}

TEST(Bench, DrawsWhatTheOptionsSay) {
  EXPECT_EQ(benched({"--size", "64x48", "--region", "8,8,16,4", "--repeat", "1"})["height"], 4);
  EXPECT_EQ(benched({"--size", "32", "--depth", "float", "--repeat", "1"})["width"], 32);
}

TEST(Bench, TellsPeopleATable) {
  const Ran ran = run_mien({"bench", face_path("seed0"), "--size", "16", "--repeat", "2"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.find("2 cold frames of 16 x 9 pixels: "), 0u) << ran.out;
  for (const char* line : {"\npose ", "\nscene ", "\ndraw ", "\nframe "})
    EXPECT_NE(ran.out.find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace mien
