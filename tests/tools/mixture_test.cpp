// Everything that moves a face at once: morph targets, muscles, an emotion, gaze, blink, bulge, a
// basis, head turn, unwrap and effects; and each alone, at weight 0, is as if it were not there, byte
// for byte (items G1, G4, G8, G11, C1, P7).

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::read_text;
using test::run_mien;
using test::ScratchFolder;

using Words = std::vector<std::string>;

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), by);
}

const char kMuscles[] = R"("muscles": {"stiffness": 20, "damping": 8, "groups": [
    {"name": "inner-frontalis", "side": "left", "strength": 60, "stroke": 0.16, "origin": [0.10, 3],
     "attach": {"brow/spine/0": 1, "brow/spine/1": 0.4}},
    {"name": "corrugator", "side": "left", "strength": 60, "stroke": 0.07, "origin": [-1.2, 0.05],
     "attach": {"brow/spine/0": 1}}]},
  "clips": {)";
const char kWorry[] = R"("emotions": {"worry": {"inner-frontalis": 0.7, "corrugator": 1},)";

/// The native face with muscles in its brows, in a folder of its own.
class MixtureTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string text = read_text(face_path("toon"));
    replace(text, R"("clips": {)", kMuscles);
    replace(text, R"("emotions": {)", kWorry);
    test::write_text(face(), text);
    replace(text, ",\n       \"raise\": [\"lid\"]", "");
    replace(text, R"("bulge": 0.025)", R"("bulge": 0)");
    test::write_text(folder_ / "no_bulge", text);
    replace(text, R"("cornea": 0.05, "bulge": 0,)", "");
    test::write_text(folder_ / "no_cornea", text);
  }

  std::string face() const { return (folder_ / "a.face.json").string(); }
  std::string file(const char* name) const { return (folder_ / name).string(); }

  /// The pixels of the face, as the file holds them: their hash, which is short where tests fail.
  std::size_t drawn(const std::string& which, Words more) const {
    const std::string out = file("out.png");
    more.insert(more.begin(), {"render", which, "--size", "160x90", "--dither", "off", "-o", out});
    const Ran ran = run_mien(more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::string bytes = read_text(out);
    return std::hash<std::string>{}(bytes.substr(bytes.find("IDAT")));
  }

  /// A basis of frames first to last; `more` may hold the face still.
  void fit(const char* name, const std::string& frames, Words more) const {
    more.insert(more.begin(),
                {"pca", "fit", face(), "--frames", frames, "--fps", "30", "-o", file(name)});
    const Ran ran = run_mien(more);
    ASSERT_EQ(ran.code, 0) << ran.err;
  }

  ScratchFolder folder_;
};

TEST_F(MixtureTest, EachAtWeightZeroIsAsIfItWereNotThere) {
  const std::size_t rest = drawn(face(), {});
  const std::vector<Words> nothing{{"--morph", "smile=0"},
                                   {"--morph", "gender=0", "--morph", "fear=0"},
                                   {"--muscle", "inner-frontalis=0"},
                                   {"--emotion", "worry=0"},
                                   {"--set", "gaze.x=0", "--set", "gaze.y=0"},
                                   {"--blink", "0"},
                                   {"--set", "yaw=0", "--set", "pitch=0", "--set", "roll=0"},
                                   {"--unwrap", "0"},
                                   {"--unwrap", "0", "--unwrap-mode", "delayed"},
                                   {"--unwrap", "0", "--unwrap-mode", "sine"},
                                   {"--effect", "none"},
                                   {"--effect", "mosaic:160"},
                                   {"--effect", "grid:10,0"}};
  for (const Words& words : nothing)
    EXPECT_EQ(drawn(face(), words), rest) << words[1] << " " << words.back();
  // C1: the bulge, where it would show.
  const Words look{"--set", "gaze.x=0.06", "--blink", "0.8"};
  EXPECT_EQ(drawn(file("no_bulge"), look), drawn(file("no_cornea"), look));
  EXPECT_NE(drawn(face(), look), drawn(file("no_bulge"), look));
  // P7: a basis of a face that holds still; at weight 0 it is its mean, that face.
  fit("still", "0-3",
      {"--components", "1", "--set", "gaze.x=0", "--set", "gaze.y=0", "--set", "blink=0", "--set",
       "dilation=1"});
  EXPECT_EQ(drawn(face(), {"--basis", file("still"), "--weights", "0"}), rest);
}

TEST_F(MixtureTest, AllAtOnceEachIsSeen) {
  fit("idle", "0-120", {"--components", "4"});
  const std::vector<Words> parts{{"--morph", "smile=0.7"},
                                 {"--morph", "ah=0.4"},
                                 {"--muscle", "corrugator=0.5"},
                                 {"--emotion", "worry=0.6"},
                                 {"--set", "gaze.x=0.05"},
                                 {"--blink", "0.3"},
                                 {"--basis", file("idle"), "--weights", "0.02,-0.03"},
                                 {"--set", "yaw=18", "--set", "pitch=-8"},
                                 {"--unwrap", "0.35", "--unwrap-mode", "delayed"},
                                 {"--effect", "mosaic:80,0.3"},
                                 {"--effect", "grid:8,1"}};
  const auto without = [&](std::size_t left_out) {
    Words words;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (i != left_out) words.insert(words.end(), parts[i].begin(), parts[i].end());
    return drawn(face(), words);
  };
  std::set<std::size_t> pictures{without(parts.size())};
  for (std::size_t i = 0; i < parts.size(); ++i)
    EXPECT_TRUE(pictures.insert(without(i)).second) << parts[i][1] << " does nothing";
}

// G11: without options the face is at rest, whatever was drawn before.
TEST_F(MixtureTest, WithoutOptionsTheFaceIsAtRest) {
  const std::string sheet = file("sheet.png"), moved = "--morph ah --set yaw=20 --time 3";
  ASSERT_EQ(run_mien({"sheet", face(), "-o", sheet, "--columns", "1", "--cell", "80x45",
                      "--picture", "", "--picture", moved, "--picture", ""})
                .code,
            0);
  const std::vector<float> levels = test::read(sheet).channels;
  const auto third = std::ptrdiff_t(levels.size() / 3);
  const auto cell = [&](int i) {
    return std::vector<float>(levels.begin() + i * third, levels.begin() + (i + 1) * third);
  };
  EXPECT_EQ(cell(0), cell(2));
  EXPECT_NE(cell(0), cell(1));
}

}  // namespace
}  // namespace mien
