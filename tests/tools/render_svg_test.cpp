// Faces to SVG files by the command.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::read_text;
using test::run_mien;
using test::ScratchFolder;

Ran render_svg(const std::string& to, const std::vector<std::string>& options,
               const std::string& face = "seed0") {
  std::vector<std::string> words{"render", face_path(face), "-o", to};
  words.insert(words.end(), options.begin(), options.end());
  return run_mien(words);
}

TEST(RenderSvg, WritesTheSizePoseAndBackgroundAskedFor) {
  const ScratchFolder folder;
  const std::string out = (folder / "a.SVG").string();
  const Ran rest = render_svg(out, {"--size", "200x100", "--background", "#102030"});
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_EQ(rest.out + rest.err, "");
  const std::string text = read_text(out);
  EXPECT_EQ(text.find("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200\" height=\"100\""),
            0u);
  EXPECT_NE(text.find("fill=\"#102030\""), std::string::npos);
  EXPECT_NE(text.find("<metadata>{&quot;mien&quot;: "), std::string::npos);
  EXPECT_TRUE(text.ends_with("</svg>\n"));
  const Ran blink = render_svg(out, {"--size", "200x100", "--blink", "1", "--blend", "srgb"});
  EXPECT_EQ(blink.code, 0) << blink.err;
  EXPECT_NE(read_text(out), text);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.SVG"});
}

TEST(RenderSvg, WarnsOfWhatSvgCannotSay) {
  const ScratchFolder folder;
  const std::string out = (folder / "a.svg").string();
  const Ran ran = render_svg(out, {}, "faces/clay");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err.find("mien: warning: " + out + ": layer \""), 0u) << ran.err;
  EXPECT_NE(ran.err.find("its relief is left out"), std::string::npos);
}

TEST(RenderSvg, RefusesWhatIsForPixels) {
  const ScratchFolder folder;
  const std::string out = (folder / "a.svg").string();
  const std::vector<std::vector<std::string>> wrongs{{"--region", "0,0,9,9"},
                                                     {"--depth", "16"},
                                                     {"--dither", "off"},
                                                     {"--light", "0,0,1"},
                                                     {"--stats=json"},
                                                     {"--error-map", (folder / "e.png").string()},
                                                     {"--blend", "linear"},
                                                     {"--debug", "outlines"},
                                                     {"--effect", "mosaic:9,0.1,mean"},
                                                     {"--debug", "morph"},
                                                     {"--blend", "nonsense"},
                                                     {"--size", "nan"},
                                                     {"--size", "0"},
                                                     {"--background", "loud"},
                                                     {"--threads", "-1"}};
  for (const auto& options : wrongs) {
    const Ran ran = render_svg(out, options);
    EXPECT_EQ(ran.code, 2) << options[0];
    EXPECT_EQ(ran.err.find("mien: " + options[0].substr(0, options[0].find('='))), 0u) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(RenderSvg, AFileThatCannotBeWrittenIsASentence) {
  const ScratchFolder folder;
  const Ran none = render_svg((folder / "no" / "a.svg").string(), {});
  EXPECT_EQ(none.code, 1);
  EXPECT_EQ(none.err.find("mien: " + (folder / "no").string()), 0u) << none.err;
  std::filesystem::create_directory(folder / "b.svg");
  EXPECT_EQ(render_svg((folder / "b.svg").string(), {}).code, 1);
  const Ran other = run_mien(
      {"animate", face_path("seed0"), "--frames", "0-1", "-o", (folder / "%03d.svg").string()});
  EXPECT_NE(other.code, 0);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"b.svg"});
}

TEST(RenderSvg, ShowsPointsAndMuscles) {
  const ScratchFolder folder;
  const std::string out = (folder / "a.svg").string();
  for (const char* debug : {"points", "muscles"})
    EXPECT_EQ(render_svg(out, {"--debug", debug}, "male").code, 0) << debug;
}

}  // namespace
}  // namespace mien
