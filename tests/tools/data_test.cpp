// mien chernoff and mien stimuli: tables and experiments as faces.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/read_back.h"
#include "tests/support/run_command.h"

namespace mien {
namespace {

using test::Ran;
using test::run_mien;
using test::ScratchFolder;

/// A wrong file, and what is said of it.
struct WrongData {
  std::string what, sentence;
};

class DataTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  Ran chernoff(const std::string& table, const std::string& map) const {
    return run_mien({"chernoff", file("t.csv", table), "--map", file("m.json", map), "-o",
                     path("c.png"), "--manifest", path("c.csv"), "--legend", path("l.png"),
                     "--cell", "32"});
  }
  static std::string map(const std::string& features) {
    return R"({"format": "mien-chernoff", "format_version": 1, "label": "who", "map": [)" +
           features + "]}";
  }
  static std::string plan(const std::string& rest) {
    return R"({"format": "mien-stimuli", "format_version": 1, "size": 32, )" + rest + "}";
  }
  Ran stimuli(const std::string& what) const {
    return run_mien({"stimuli", file("plan.json", what), "-o", path("shown")});
  }
  std::size_t count(const std::string& folder) const {
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator(folder_ / folder))
      ++files;
    return files;
  }

  ScratchFolder folder_;
};

TEST_F(DataTest, TheManifestSaysWhatEachCellBecame) {
  const Ran ran =
      chernoff("who,size,kind,mood\n\"a, b\",10,x,0\n\"say \"\"c\"\"\",20,y,4\nd,40,x,1\n",
               map(R"({"column": "size", "number": "eye.size", "to": [1.2, 0.8]},
             {"column": "kind", "part": "hair", "values": {"x": "bob", "y": "crop"}},
             {"column": "mood", "emotion": "joy", "scale": "rank"})"));
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string written = text("c.csv");
  EXPECT_NE(written.find("\"a, b\",10,1.2,x,bob,0,0,"), std::string::npos) << written;
  EXPECT_NE(written.find("\"say \"\"c\"\"\",20,1.0666666666666667,y,crop,4,1,"), std::string::npos)
      << written;
  EXPECT_NE(written.find("d,40,0.8,x,bob,1,0.5,"), std::string::npos) << written;
  EXPECT_EQ(test::read(path("c.png")).spec.width, 3 * 32);
  EXPECT_EQ(test::read(path("l.png")).spec.width, 3 * 32);
}

TEST_F(DataTest, WrongCellsAreNamed) {
  const std::string features = map(R"({"column": "size", "number": "eye.size", "from": [0, 9]})");
  for (const auto& [table, sentence] : {
           WrongData{"who,size\na,1\nb,\n", "row 2, column \"size\": the number is missing"},
           WrongData{"who,size\na,1\nb,two\n", "expected a finite number, got \"two\""},
           WrongData{"who,size\na,inf\n", "row 1, column \"size\": expected a finite number"},
           WrongData{"who,size\na,nan\n", "expected a finite number"},
           WrongData{"who,size\na,1e999\n", "expected a finite number"},
           WrongData{"who,size\na,10\n", "10 is outside the map's 0 … 9"},
           WrongData{"who,sise\na,1\n", "no column named \"size\"; did you mean \"sise\"?"},
           WrongData{"who,size\na,1,2\n", "row 1: 3 cells, the heading has 2"},
           WrongData{"who,who\na,1\n", "two columns are called \"who\""},
           WrongData{"who,size\n", "rows below it"},
           WrongData{"who,size\n\"a,1\n", "quotes"},
           WrongData{"", "rows below it"},
       }) {
    const Ran ran = chernoff(table, features);
    EXPECT_NE(ran.code, 0) << table;
    EXPECT_NE(ran.err.find(sentence), std::string::npos) << table << ran.err;
    EXPECT_NE(ran.err.find("t.csv"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(path("c.png"))) << table;
  }
}

TEST_F(DataTest, WrongMapsAreToldAtTheirPlace) {
  for (const auto& [features, sentence] : {
           WrongData{R"({"column": "size", "number": "eye.sise"})", "did you mean \"eye.size\"?"},
           WrongData{R"({"column": "size", "number": "eye.size", "to": [0, 1]})",
                     "eye.size goes from 0.8 to 1.2, got 0 and 1"},
           WrongData{R"({"column": "size"})", "one of them"},
           WrongData{R"({"column": "size", "part": "hair", "values": {"1": "bop"}})",
                     "did you mean \"bob\"?"},
           WrongData{
               R"({"column": "size", "number": "smile"}, {"column": "who", "number": "smile"})",
               "smile is moved by \"size\" already"},
       }) {
    const Ran ran = chernoff("who,size\na,1\n", map(features));
    EXPECT_NE(ran.code, 0) << features;
    EXPECT_NE(ran.err.find("m.json:1:"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find(sentence), std::string::npos) << features << ran.err;
  }
  const Ran twice = chernoff("who,size\na,1\n", map(R"({"column": "size", "number": "smile"},
                                                       {"column": "size", "number": "lips"})"));
  EXPECT_EQ(twice.code, 0);
  EXPECT_NE(twice.err.find("one value is seen twice"), std::string::npos) << twice.err;
}

TEST_F(DataTest, ATableWithoutAMapIsShown) {
  const Ran ran = run_mien({"chernoff", MIEN_SOURCE_DIR "/examples/chernoff/planets.csv", "-o",
                            path("c.png"), "--cell", "32", "--columns", "4"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find(
                "planets.csv: row 1, column \"Kind\": expected a finite number, got \"rock\": the "
                "column is not shown"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(test::read(path("c.png")).spec.width, 4 * 32);
}

TEST_F(DataTest, TheFirstCellThatIsNoNumberIsNamed) {
  const Ran ran = run_mien({"chernoff", file("t.csv", "who,size,mood\na,1,2\nb,2,\nc,3,high\n"),
                            "-o", path("c.png"), "--cell", "32"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(
      ran.err.find("t.csv: row 2, column \"mood\": the number is missing: the column is not shown"),
      std::string::npos)
      << ran.err;
}

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

TEST_F(DataTest, WrongPlansAreToldBeforeAnythingIsDrawn) {
  for (
      const auto& [rest, sentence] : {
          WrongData{
              R"("factors": [{"number": "smile", "steps": 1000}, {"number": "lips", "steps": 1000},
                                {"number": "jaw", "steps": 1000}])",
              "1000 × 1000 × 1000 = 1000000000 pictures; a plan has 100000 at most"},
          WrongData{R"("factors": [])", "expected 1 to 32 factors"},
          WrongData{R"("factors": [{"name": "x"}])", "a factor varies one of"},
          WrongData{R"("factors": [{"number": "smlie", "steps": 2}])", "did you mean \"smile\"?"},
          WrongData{R"("factors": [{"number": "smile", "steps": 2, "to": 7}])",
                    "smile goes from -0.3 to 1, got 7"},
          WrongData{
              R"("factors": [{"number": "smile", "steps": 2}, {"number": "smile", "steps": 2}])",
              "two factors are called \"smile\""},
          WrongData{R"("factors": [{"codes": ["ZAAAA"]}])", "plan.json:1:"},
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
