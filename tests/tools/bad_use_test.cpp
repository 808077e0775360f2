// Whatever is typed, the answer is one line, the exit code says whose fault it is, and nothing is
// written.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ostream>

#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;

struct Wrong {
  std::vector<std::string>
      words;  ///< FACE, OUT and DIR stand for a face, a picture to be and a folder
  int code;
  std::string line;  ///< after "mien: "
};

const char kSides[] = "expected WxH, or the longer side; whole pixels from 1 to 1048576";

std::string wrong_sign() {
  return "a sign is wrong, or two are swapped: its check sign does not fit";
}

const Wrong kWrongs[] = {
    {{},
     2,
     "a command is needed: render, check, scene, list, set, bench, animate, say, morph, mesh, pca, "
     "import, fit, sheet, new, code, parts, chernoff, stimuli, batch, join, studio, serve; "
     "mien -h helps"},
    {{"rendr"}, 2, "no command named \"rendr\"; did you mean \"render\"?"},
    {{"xyzzy"}, 2, "no command named \"xyzzy\"; mien -h helps"},
    {{"help"}, 2, "no command named \"help\"; mien -h helps"},
    {{"pca", "xyzzy"},
     2,
     "no command named \"xyzzy\"; there are \"fit\", \"info\", \"encode\", \"decode\", \"compare\" "
     "and "
     "\"sheet\"; mien pca -h helps"},
    {{"pca", "list", "FACE"},
     2,
     "no command named \"list\"; there are \"fit\", \"info\", \"encode\", \"decode\", \"compare\" "
     "and "
     "\"sheet\"; mien pca -h helps"},
    {{"new", "list", "FACE"}, 2, "new: one argument too many: \"list\""},
    {{"render", "FACE", "-o", "OUT", "list"}, 2, "render: one argument too many: \"list\""},
    {{"parts", "list"}, 2, "no family named \"list\"; mien parts lists them"},
    {{"parts", "chekc"}, 2, "no family named \"chekc\"; did you mean \"check\"?"},
    {{"parts", "list", "FACE"}, 2, "parts: one argument too many: \"FACE\""},
    {{"--versoin"}, 2, "no option named \"--versoin\"; did you mean \"--version\"?"},
    {{"render"}, 2, "render: FACE is required"},
    {{"render", "FACE"}, 2, "render: --output is required"},
    {{"render", "FACE", "-o"}, 2, "render: --output needs a value"},
    {{"render", "FACE", "-o", "OUT", "b"}, 2, "render: one argument too many: \"b\""},
    {{"render", "hello", "-o", "OUT"},
     1,
     "hello: there is no such file; `mien new --seed hello` prints the code of a person for any "
     "word"},
    {{"list", "Ada Lovelace"},
     1,
     "Ada Lovelace: there is no such file; `mien new --seed \"Ada Lovelace\"` prints the code of a "
     "person for any word"},
    {{"list", "-"}, 1, "-: faces are read from files; /dev/stdin is standard input's"},
    {{"code", "hello"},
     1,
     "hello: there is no such file; `mien new --seed hello` prints the code of a person for any "
     "word"},
    {{"render", "A66CB-AA5S0-15", "-o", "OUT"}, 1, "code A66CB-AA5S0-15: " + wrong_sign()},
    {{"code", "A66CB-AA5S0-15"}, 1, "code A66CB-AA5S0-15: " + wrong_sign()},
    {{"list", "A66CB-AA5S0-15"}, 1, "code A66CB-AA5S0-15: " + wrong_sign()},
    {{"new", "--code", "A66CB-AA5S0-15"}, 1, "--code A66CB-AA5S0-15: " + wrong_sign()},
    {{"new", "--near", "A66CB-AA5S0-15"}, 1, "--near A66CB-AA5S0-15: " + wrong_sign()},
    {{"new", "--child-of", "A66CB-AA5S0-14", "A66CB-AA5S0-15"},
     1,
     "--child-of A66CB-AA5S0-15: " + wrong_sign()},
    {{"render", "FACE", "-o", "OUT", "--dpi", "0"},
     2,
     "--dpi 0: expected a number from 1 to 100000"},
    {{"render", "FACE", "-o", "OUT", "--id-prefix", "a"},
     2,
     "--id-prefix: is for SVG files; pixels have no ids"},
    {{"render", "FACE", "-o", "OUT", "--yaw", "20"},
     2,
     "no option named \"--yaw\"; did you mean \"--set yaw=DEGREES\"?"},
    {{"render", "FACE", "-o", "OUT", "--viseme", "aa"},
     2,
     "no option named \"--viseme\"; did you mean \"--set viseme.NAME=WEIGHT\"?"},
    {{"render", "FACE", "-o", "OUT", "--happy"},
     2,
     "no option named \"--happy\"; did you mean \"--emotion joy\"?"},
    {{"new", "--hat", "cap"},
     2,
     "no option named \"--hat\"; did you mean \"--hold headwear=NAME\"?"},
    {{"render", "A66CB-AA5S0-14", "-o", "OUT", "--emotion", "happiness"},
     2,
     "--emotion happiness: no emotion named \"happiness\"; did you mean \"joy\"?"},
    {{"render", "A66CB-AA5S0-14", "-o", "OUT", "--set", "turn=20"},
     2,
     "turn=20: no control or number named \"turn\"; did you mean \"yaw\"?"},
    {{"render", "FACE", "-o", "OUT", "--sise", "3"},
     2,
     "no option named \"--sise\"; did you mean \"--size\"?"},
    {{"render", "FACE", "-o", "OUT", "--size=3", "--size=4"},
     2,
     "render: --size may be given only once"},
    {{"render", "FACE", "-o", "OUT", "--size", "0"}, 2, std::string("--size 0: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "-1"}, 2, std::string("--size -1: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "0x5"}, 2, std::string("--size 0x5: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "5x-1"}, 2, std::string("--size 5x-1: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "2147483648x5"},
     2,
     std::string("--size 2147483648x5: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "1048577x5"},
     2,
     std::string("--size 1048577x5: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "big"}, 2, std::string("--size big: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "5x5x5"}, 2, std::string("--size 5x5x5: ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", ""}, 2, std::string("--size : ") + kSides},
    {{"render", "FACE", "-o", "OUT", "--size", "100x100", "--memory", "39K"},
     1,
     "OUT: needs at least 1.61 MiB of memory, more than the 39 KiB allowed"},
    {{"render", "FACE", "-o", "OUT", "--size", "1048576", "--memory", "4M"},
     1,
     "OUT: needs at least 38 MiB of memory, more than the 4 MiB allowed"},
    {{"render", "FACE", "-o", "OUT", "--memory", "lots"},
     2,
     "--memory lots: expected a number of bytes, perhaps with K, M, G or T: 6G"},
    {{"render", "FACE", "-o", "OUT", "--fit", "stretch"},
     2,
     "--fit stretch: expected meet or slice"},
    {{"render", "FACE", "-o", "OUT", "--blend", "gamma"},
     2,
     "--blend gamma: expected linear or srgb"},
    {{"render", "FACE", "-o", "OUT", "--light", "1,2,-3"},
     2,
     "--light 1,2,-3: expected X,Y,Z, the last more than 0: the lamp is before us"},
    {{"render", "FACE", "-o", "OUT", "--debug", "everything"},
     2,
     "--debug everything: expected outlines, regions, fragments, looks, distance, normals, morph, "
     "muscles or points"},
    {{"render", "FACE", "-o", "OUT", "--dither", "maybe"}, 2, "--dither maybe: expected on or off"},
    {{"render", "FACE", "-o", "OUT", "--depth", "12"},
     2,
     "--depth 12: expected 8, 16, half or float"},
    {{"render", "FACE", "-o", "OUT", "--depth", "half"}, 2, "--depth half: PNG holds 8 or 16"},
    {{"render", "FACE", "-o", "DIR/a.exr", "--depth", "8"},
     2,
     "--depth 8: EXR holds half or float"},
    {{"render", "FACE", "-o", "DIR/a.jpg", "--depth", "16"}, 2, "--depth 16: JPEG holds 8"},
    {{"render", "FACE", "-o", "OUT", "--stats", "xml"}, 2, "--stats xml: expected json"},
    {{"render", "FACE", "-o", "OUT", "--progress", "yes"},
     2,
     "--progress yes: expected auto, json or none"},
    {{"render", "FACE", "-o", "OUT", "--threads", "-1"},
     2,
     "--threads -1: expected a whole number from 0 (as many as there are) to 1024"},
    {{"render", "FACE", "-o", "OUT", "--threads", "two"},
     2,
     "--threads two: expected a whole number from 0 (as many as there are) to 1024"},
    {{"render", "FACE", "-o", "OUT", "--time", "nan"},
     2,
     "--time nan: expected a finite number of seconds"},
    {{"render", "FACE", "-o", "OUT", "--time", "1e999"},
     2,
     "--time 1e999: expected a finite number of seconds"},
    {{"render", "FACE", "-o", "OUT", "--background", "red"},
     2,
     "--background red: expected #rrggbb, #rrggbbaa or transparent"},
    {{"render", "FACE", "-o", "OUT", "--region", "0,0,10"},
     2,
     "--region 0,0,10: expected X,Y,W,H in whole pixels"},
    {{"render", "FACE", "-o", "OUT", "--size", "20x10", "--region", "15,0,6,5"},
     2,
     "--region 15,0,6,5: is not inside the picture of 20 x 10 pixels"},
    {{"render", "FACE", "-o", "OUT", "--size", "20x10", "--region", "0,0,0,5"},
     2,
     "--region 0,0,0,5: is not inside the picture of 20 x 10 pixels"},
    {{"render", "FACE", "-o", "OUT", "--size", "20x10", "--region", "2147483647,0,2147483647,5"},
     2,
     "--region 2147483647,0,2147483647,5: is not inside the picture of 20 x 10 pixels"},
    {{"render", "FACE", "-o", "DIR/a.gif"},
     2,
     "DIR/a.gif: unknown extension .gif; known are .png .tif .tiff .exr .jpg .jpeg, and .svg "
     "to `mien render` and write_svg"},
    {{"render", "FACE", "-o", "DIR"},
     2,
     "DIR: its name has no extension, which would tell the format; known are .png .tif .tiff .exr "
     ".jpg .jpeg, and .svg to `mien render` and write_svg"},
    {{"render", "FACE", "-o", "DIR/none/a.png"},
     1,
     "DIR/none/a.png: its folder DIR/none: No such file or directory"},
    {{"render", "FACE", "-o", "DIR/folder.png"}, 1, "DIR/folder.png: is a directory, not a file"},
    {{"render", "FACE", "-o", "/dev/full.png/a.png"},
     1,
     "/dev/full.png/a.png: its folder /dev/full.png: No such file or directory"},
    {{"render", "DIR/none.json", "-o", "OUT"},
     1,
     "DIR/none.json: cannot be read: No such file or directory"},
    {{"render", "DIR", "-o", "OUT"}, 1, "DIR: is a directory"},
    {{"render", "FACE", "-o", ""}, 2, "--output: its name is empty"},
    {{"render", "FACE", "-o", "OUT", "--error-map", "OUT"},
     2,
     "--error-map OUT: would overwrite a file of this command: --output writes it"},
    {{"render", "FACE", "-o", "OUT", "--emotion", "joy"},
     2,
     "--emotion joy: this face has no emotions"},
    {{"render", "FACE", "-o", "OUT", "--muscle", "frown=0.5"},
     2,
     "--muscle frown=0.5: this face has no muscles"},
    {{"render", "FACE", "-o", "OUT", "--arkit", "DIR"}, 1, "DIR: is a directory"},
    {{"render", "FACE", "-o", "OUT", "--arkit", "/dev/zero"},
     1,
     "/dev/zero: longer than 67108864 bytes (limit: bytes)"},
    {{"render", "FACE", "-o", "OUT", "--morphs", "/dev/zero"},
     1,
     "/dev/zero: longer than 67108864 bytes (limit: bytes)"},
    {{"render", "FACE", "-o", "OUT", "--effect", "mosiac:3"},
     2,
     "--effect mosiac:3: no effect named \"mosiac\"; did you mean \"mosaic\"?"},
    {{"render", "FACE", "-o", "OUT", "--effect", "mosaic:2147483648"},
     2,
     "--effect mosaic:2147483648: expected 1 to 65536 tiles across"},
    {{"import", "facemotion", "DIR", "-o", "OUT"}, 1, "DIR: is a directory"},
    {{"import", "facemotion", "/dev/zero", "-o", "OUT"},
     1,
     "/dev/zero: longer than 67108864 bytes (limit: bytes)"},
    {{"import", "legomotion", "FACE", "-o", "OUT"},
     2,
     "import legomotion: expected facemotion or obj-targets"},
    {{"morph", "from-obj", "FACE", "DIR/none.json", "DIR/a.obj", "DIR/b.obj", "-o", "OUT"},
     1,
     "DIR/none.json: cannot be read: No such file or directory"},
    {{"check", ""}, 1, "face file: its name is empty"},
    {{"check"}, 2, "check: FACE is required"},
    {{"check", "--nonsense"}, 2, "--nonsense: needs N people, or a face"},
    {{"check", "--nonsense", "0"}, 2, "--nonsense 0: expected a whole number from 1 to 100000"},
    {{"check", "--nonsense", "1e9"}, 2, "--nonsense 1e9: expected a whole number from 1 to 100000"},
    {{"check", "FACE", "--nonsense", "3"}, 2, "--nonsense: takes N people or faces, not both"},
    {{"check", "FACE", "--seed", "a"}, 2, "--seed: only with --nonsense"},
    {{"check", "FACE", "--style", "ink"}, 2, "--style: only with --nonsense"},
    {{"check", "FACE", "--nonsense", "--style", "ink"}, 2, "--style: only with N people"},
    {{"check", "--nonsense", "1", "--style", "inc"},
     1,
     "recipe: no style named \"inc\"; did you mean \"ink\"?"},
    {{"check", "FACE", "--json"}, 2, "--json: only with --nonsense"},
    {{"check", "--nonsense", "DIR/none.json"},
     1,
     "DIR/none.json: cannot be read: No such file or directory"},
    {{"check", "DIR/none.json"}, 1, "DIR/none.json: cannot be read: No such file or directory"},
    {{"scene", "FACE", "--time", "1", "--seed", ""}, 2, "scene: --seed: an empty word is no seed"},
    {{"scene", "FACE", "--time", "1", "--liveliness", "3"},
     2,
     "--liveliness 3: expected a number from 0 to 2"},
    {{"scene", "FACE", "--time", "soon"}, 2, "--time soon: expected a finite number of seconds"},
    {{"list", "FACE", "FACE"}, 2, "list: one argument too many: \"FACE\""},
    {{"bench"}, 2, "bench: FACE is required"},
    {{"studio", "--port", "65536"}, 2, "--port 65536: expected a whole number from 0 to 65535"},
    {{"studio", "--prot", "1"}, 2, "no option named \"--prot\"; did you mean \"--port\"?"},
    {{"serve", "--listen", "nowhere"},
     2,
     "--listen nowhere: expected ADDRESS:PORT, 127.0.0.1:8080 or [::1]:8080"},
    {{"serve", "--listen", "::1:80"},
     2,
     "--listen ::1:80: expected ADDRESS:PORT, 127.0.0.1:8080 or [::1]:8080"},
    {{"serve", "--max-size", "0"}, 2, "--max-size 0: expected a whole number from 1 to 1048576"},
    {{"serve", "--cache", "-1"}, 2, "--cache -1: expected a whole number from 0 to 1048576"},
    {{"serve", "--queue", "0"}, 2, "--queue 0: expected a whole number from 1 to 1048576"},
    {{"serve", "--timeout", "0"}, 2, "--timeout 0: expected a number from 0.1 to 3600"},
    {{"serve", "--port", "1"},
     2,
     "no option named \"--port\"; there are \"-h\", \"--help\", \"--listen\", \"--max-size\", "
     "\"--cache\", \"--threads\", \"--queue\" and \"--timeout\""},
    {{"bench", "FACE", "--repeat", "0"},
     2,
     "--repeat 0: expected a whole number from 1 to 1000000"},
    {{"bench", "FACE", "--repeat", "1.5"},
     2,
     "--repeat 1.5: expected a whole number from 1 to 1000000"},
    {{"bench", "FACE", "--size", "none"}, 2, std::string("--size none: ") + kSides},
    {{"bench", "FACE", "--depth", "9"}, 2, "--depth 9: expected 8, 16, half or float"},
    {{"bench", "FACE", "-o", "OUT"}, 2, "no option named \"-o\""},
    {{"pca"}, 2, "pca: one of its commands is needed: fit, info, encode, decode, compare, sheet"},
    {{"pca", "fut"}, 2, "no command named \"fut\"; did you mean \"fit\"?"},
    {{"pca", "fit"}, 2, "pca fit: FRAMES is required"},
    {{"pca", "fit", "FACE", "-o", "DIR/b"},
     2,
     "pca fit: one of --components, --variance and --max-error is needed"},
    {{"pca", "fit", "FACE", "-o", "DIR/b", "--components", "0"},
     2,
     "--components 0: expected a whole number from 1 to 1000000000"},
    {{"pca", "fit", "FACE", "-o", "DIR/b", "--components", "2", "--frames", "9-3"},
     2,
     "--frames 9-3: expected FIRST-LAST, whole numbers from 0 to 9999999, the first not above "
     "the last"},
    {{"pca", "fit", "FACE", "-o", "DIR/b", "--components", "2", "--fps", "0"},
     2,
     "--fps 0: expected frames a second from 0.01 to 1000, perhaps as 30000/1001"},
    {{"pca", "fit", "FACE", "-o", "DIR/b", "--variance", "2"},
     2,
     "--variance 2: expected a number from 0 to 1"},
    {{"pca", "info", "FACE"}, 1, "FACE: is not a basis: `mien pca fit` makes one"},
    {{"completion", "tcsh"}, 2, "completion tcsh: expected bash, zsh or fish"}};

std::string filled(std::string text, const ScratchFolder& folder) {
  const std::pair<const char*, std::string> stand_ins[] = {{"FACE", face_path("seed0")},
                                                           {"OUT", (folder / "out.png").string()},
                                                           {"DIR", folder.path().string()}};
  for (const auto& [name, value] : stand_ins) {
    for (std::size_t at = text.find(name); at != std::string::npos;
         at = text.find(name, at + value.size())) {
      if (text.substr(at, 16) == "FACE is required") break;
      text.replace(at, 4 - (name[0] != 'F'), value);
    }
  }
  return text;
}

/// How the table's lines are named in reports.
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << "mien";
  for (const std::string& word : wrong.words) *out << ' ' << word;
}

class BadUse : public testing::TestWithParam<Wrong> {};

TEST_P(BadUse, IsOneLineAndLeavesNothing) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "folder.png");
  std::vector<std::string> words;
  for (const std::string& word : GetParam().words) words.push_back(filled(word, folder));
  const Ran ran = run_mien(words);
  EXPECT_EQ(ran.code, GetParam().code);
  EXPECT_EQ(ran.err, "mien: " + filled(GetParam().line, folder) + "\n");
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"folder.png"});
}

INSTANTIATE_TEST_SUITE_P(Table, BadUse, testing::ValuesIn(kWrongs));

TEST(BadSetting, NamesTheNearest) {
  const ScratchFolder folder;
  const Ran ran = run_mien(
      {"render", face_path("toon"), "-o", (folder / "a.png").string(), "--set", "blnk=0.5"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err.substr(0, 6), "mien: ");
  EXPECT_NE(ran.err.find("did you mean \"blink\"?"), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(BadFace, SaysWhereAndKeepsTheOldPicture) {
  const ScratchFolder folder;
  test::write_text(folder / "bad.json", "{\n  \"format\": 7\n}\n");
  test::write_text(folder / "a.png", "old");
  const Ran ran =
      run_mien({"render", (folder / "bad.json").string(), "-o", (folder / "a.png").string()});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err.find("mien: " + (folder / "bad.json").string() + ":2:"), 0u) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_EQ(test::read_text(folder / "a.png"), "old");
}

TEST(BadFace, ANameWithControlCharactersStaysOneLine) {
  const Ran ran = run_mien({"check", "no\nsuch\x1b[31m\xff"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
  EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);
}

/// Plain words, which could be a person's, but something is called so.
TEST(BadFace, ThatIsSomethingElseIsNotCalledMissing) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("circle", folder / "circle");
  std::filesystem::create_symlink("nobody", folder / "nowhere");
  std::filesystem::create_directory(folder / "folder");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::string there = "cd '" + folder.path().string() + "' && " MIEN_COMMAND " list ";
  for (const auto& [name, what] :
       {std::pair<std::string, std::string>{"circle",
                                            "cannot be read: Too many levels of symbolic links"},
        {"nowhere", "cannot be read: No such file or directory"},
        {"folder", "is a directory"},
        {"pipe", "is a pipe that nothing is written to"}}) {
    const Ran ran = test::Process({"/bin/sh", "-c", there + name}).wait();
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.err, "mien: " + name + ": " + what + "\n");
  }
}

TEST(Check, SaysOkForTheGoodAndFailsForTheBad) {
  const Ran ran = run_mien({"check", face_path("seed0"), "/none.json", face_path("toon")});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.out, face_path("seed0") + ": ok\n" + face_path("toon") + ": ok\n");
  EXPECT_EQ(ran.err, "mien: /none.json: cannot be read: No such file or directory\n");
}

TEST(Check, WarningsDoNotFail) {
  const ScratchFolder folder;
  std::string text = test::read_text(face_path("seed0"));
  text.insert(text.find('{') + 1, "\"strange\": 1,");
  test::write_text(folder / "a.json", text);
  const Ran ran = run_mien({"check", (folder / "a.json").string()});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err.find("mien: warning: " + (folder / "a.json").string() + ":"), 0u) << ran.err;
}

TEST(StandardOutput, ThatNobodyReadsAnyMoreEndsTextInSilence) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const std::string into = ">&" + std::to_string(ends[1]);
  const Ran list =
      test::Process({"/bin/sh", "-c", MIEN_COMMAND " list " + face_path("seed0") + into}).wait();
  ::close(ends[1]);
  EXPECT_EQ(list.code, 1);
  EXPECT_EQ(list.err, "");
}

TEST(StandardOutput, ThatIsFullIsAnError) {
  const Ran list = run_mien({"list", face_path("seed0")}, "/dev/full");
  EXPECT_EQ(list.code, 1);
  EXPECT_EQ(list.err, "mien: standard output: cannot be written: No space left on device\n");
  const Ran picture =
      run_mien({"render", face_path("seed0"), "-o", "-", "--size", "40"}, "/dev/full");
  EXPECT_EQ(picture.code, 1);
  EXPECT_EQ(picture.err, "mien: standard output: cannot be written: No space left on device\n");
}

}  // namespace
}  // namespace mien
