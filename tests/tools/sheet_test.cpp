// mien sheet: emotions, and pictures drawn as mien render draws them, beside each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

using Words = std::vector<std::string>;

class SheetTest : public testing::Test {
 protected:
  auto drawn(const std::string& command, Words more) const {
    const std::string out = (folder_ / "out.png").string();
    more.insert(more.begin(), {command, face_path("toon"), "-o", out});
    const Ran ran = run_mien(more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return test::read(out);
  }
  ScratchFolder folder_;
};

/// Whether `part` is what `whole` shows at x, y.
template <class Picture>
bool holds(const Picture& whole, const Picture& part, int x, int y) {
  for (int r = 0; r < part.spec.height; ++r) {
    const auto row = part.channels.begin() + r * part.spec.width * part.spec.nchannels;
    const auto at =
        whole.channels.begin() + ((y + r) * whole.spec.width + x) * whole.spec.nchannels;
    if (!std::equal(row, row + part.spec.width * part.spec.nchannels, at)) return false;
  }
  return true;
}

TEST_F(SheetTest, HoldsThePicturesThatRenderDraws) {
  const std::vector<Words> pictures{
      {"--blink", "1", "--region", "10,5,40,30"},
      {"--pose", "lid.sad=0.5", "--region", "0,5,40,30", "--effect", "mosaic:24"},
      {"--set", "yaw=20", "--region", "20,10,40,30", "--background", "#102030"},
      {"--time", "1.5", "--region", "10,5,40,30"}};
  Words sheet{"--cell", "96", "--columns", "2", "--gap", "5"};
  for (const Words& picture : pictures) {
    std::string text;
    for (const std::string& word : picture) text += " " + word;
    sheet.insert(sheet.end(), {"--picture", text});
  }
  const auto whole = drawn("sheet", sheet);
  EXPECT_EQ(whole.spec.width, 2 * 40 + 5);
  EXPECT_EQ(whole.spec.height, 2 * 30 + 5);
  for (int i = 0; i < 4; ++i) {
    Words words = pictures[std::size_t(i)];
    words.insert(words.end(), {"--size", "96"});
    EXPECT_TRUE(holds(whole, drawn("render", words), i % 2 * 45, i / 2 * 35)) << i;
  }
  EXPECT_EQ(whole.channels[std::size_t(42 * whole.spec.nchannels)], 1) << "the gap is white";
}

TEST_F(SheetTest, NamesStandBelow) {
  const auto named = drawn("sheet", {"--cell", "96x54", "--picture", "near: --look-at 0,0,0.6",
                                     "--picture", "--look-at '0,0,9'"});
  EXPECT_EQ(named.spec.width, 192);
  EXPECT_EQ(named.spec.height, 54 + 12);
  const auto below = named.channels.begin() + 54 * 192 * named.spec.nchannels;
  EXPECT_NE(*std::min_element(below, named.channels.end()), 1);
  EXPECT_EQ(drawn("sheet", {"--cell", "96x54", "--picture", ""}).spec.height, 54);
}

TEST_F(SheetTest, EmotionsAreInColumns) {
  EXPECT_EQ(drawn("sheet", {"--cell", "64x36", "--columns", "6"}).spec.width, 6 * 64);
  EXPECT_EQ(drawn("sheet", {"--cell", "64x36", "--half"}).spec.height, 4 * (36 + 12));
}

TEST(Sheet, WarnsOnce) {
  const ScratchFolder folder;
  std::string text = test::read_text(face_path("seed0"));
  text.insert(text.find('{') + 1, "\"strange\": 1,");
  test::write_text(folder / "a.json", text);
  const Ran ran = run_mien({"sheet", (folder / "a.json").string(), "--cell", "32", "-o",
                            (folder / "a.png").string(), "--picture", "", "--picture", ""});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
}

// One line that names the word, and nothing is written.
TEST(BadSheet, IsOneLineAndLeavesNothing) {
  const std::pair<Words, std::string> wrongs[] = {
      {{"--picture", "a: --blnk 1"},
       "--picture a: --blnk 1: no option named \"--blnk\"; did you mean \"--blink\"?"},
      {{"--picture", "a: --blink"}, "--picture a: --blink: --blink needs a value"},
      {{"--picture", "--blink 1", "--picture", "a: --blink 7"},
       "--blink 7: \"blink\" goes from 0 to 1, got 7"},
      {{"--picture", "--emotion joi"},
       "--emotion joi: no emotion named \"joi\"; did you mean \"joy\"?"},
      {{"--picture", "--effect mosiac:3"},
       "--effect mosiac:3: no effect named \"mosiac\"; did you mean \"mosaic\"?"},
      {{"--picture", "blink 1"},
       "--picture blink 1: expected options of mien render, perhaps after a name and a colon"},
      {{"--picture", "a: --set 'yaw=1"}, "--picture a: --set 'yaw=1: a quote is never closed"},
      {{"--picture", "a: b"}, "--picture a: b: picture: one argument too many: \"b\""},
      {{"--picture", "-o b.png"}, "--picture -o b.png: no option named \"-o\""},
      {{"--picture", "", "--picture", "--region 0,0,5,4"},
       "--picture --region 0,0,5,4: has 5 x 4 pixels, the first one 320 x 180"},
      {{"--picture", "", "--half"}, "--picture: a sheet has pictures or emotions, not both"},
      {{"--columns", "0"}, "--columns 0: expected a whole number from 1 to 1000"},
      {{"--gap", "-1"}, "--gap -1: expected a whole number from 0 to 1000"},
      {{"--colums", "2"}, "no option named \"--colums\"; did you mean \"--columns\"?"}};
  for (const auto& [more, line] : wrongs) {
    const ScratchFolder folder;
    Words words{"sheet", face_path("toon"), "-o", (folder / "out.png").string()};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 2) << line;
    EXPECT_EQ(ran.err, "mien: " + line + "\n");
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(folder.names().empty()) << line;
  }
}

}  // namespace
}  // namespace mien
