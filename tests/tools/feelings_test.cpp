// Emotions, muscles and standard names on the command line; import, fit and sheet.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

std::string written(const ScratchFolder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

TEST(Feelings, PoseTheFace) {  // M6, M7, M10
  const std::string male = face_path("male");
  const auto scene = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"scene", male});
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  EXPECT_NE(scene({"--emotion", "joy=0.8"}), scene({}));
  EXPECT_EQ(scene({"--emotion", "joy=0.8"}), scene({"--set", "emotion.joy=0.8"}));
  EXPECT_EQ(scene({"--emotion", "left.joy=0.4", "--emotion", "right.joy=0.4"}),
            scene({"--emotion", "joy=0.4"}));
  EXPECT_EQ(scene({"--emotion", "joy=7", "--clamp"}), scene({"--emotion", "joy"}));
  const ScratchFolder folder;
  const std::string frame = written(folder, "f.json", R"({"mouthSmileLeft": 0.5})");
  EXPECT_EQ(scene({"--arkit", frame}), scene({"--muscle", "left.zygomaticus=0.5"}));
}

TEST(Feelings, NameTheNearestOfWhatTheyDoNotKnow) {
  const ScratchFolder folder;
  const std::string male = face_path("male");
  EXPECT_EQ(run_mien({"scene", male, "--emotion", "joi=1"}).err,
            "mien: --emotion joi=1: no emotion named \"joi\"; did you mean \"joy\"?\n");
  EXPECT_EQ(run_mien({"scene", male, "--muscle", "jaw=2"}).err,
            "mien: --muscle jaw=2: \"jaw\" goes from 0 to 1, got 2\n");
  const std::string frame = written(folder, "f.json", R"({"jawOpn": 0.5})");
  EXPECT_EQ(run_mien({"scene", male, "--arkit", frame}).err,
            "mien: " + frame +
                ":1:12: /jawOpn: no arkit name named \"jawOpn\"; did you mean \"jawOpen\"?\n");
}

TEST(Feelings, AreImportedFittedAndShown) {  // M1, M8, M11
  const ScratchFolder folder;
  const std::string source = written(folder, "m.js", R"js(var tiny = {
    'version': 1.0, 'stiffness': 20, 'damping': 8,
    'features': {'mouth': {'points': [{x: 0, y: 170}, {x: 60, y: 170}], 'weight': 1}},
    'muscleGroups': {'jaw': {'strength': 30, 'stroke': 80, 'origin': {x: 0, y: 1000},
                             'muscles': {'mouth:0': 1, 'mouth:1': 0.5,}}},
    'recipes': {'surprise': {'jaw': 1}}};
)js");
  const std::string face = (folder / "tiny.face.json").string();
  Ran ran = run_mien({"import", "facemotion", source, "-o", face});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(run_mien({"check", face}).code, 0);
  const std::string targets = written(folder, "t.json", R"({"jawOpen": 0.5})");
  ran = run_mien({"fit", face, targets});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("muscle.left.jaw 0.5"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("residual: rms "), std::string::npos);
  const std::string sheet = (folder / "sheet.png").string();
  ran = run_mien({"sheet", face, "--emotions", "--cell", "64", "-o", sheet});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_GT(std::filesystem::file_size(sheet), 200u);
  const std::string legend =
      run_mien({"scene", face, "--debug", "muscles", "--emotion", "surprise=0.5"}).out;
  const std::size_t jaw = legend.find("layer jaw "), pull = legend.find("layer 0.50 ", jaw);
  ASSERT_NE(jaw, std::string::npos);
  ASSERT_NE(pull, std::string::npos);
  EXPECT_EQ(legend.find("layer value ", jaw), legend.find("layer value ", pull)) << "on its line";
  EXPECT_EQ(run_mien({"import", "facemotion", targets + "x", "-o", face}).code, 1);
}

}  // namespace
}  // namespace mien
