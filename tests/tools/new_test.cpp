// mien new, mien code, mien parts and codes in place of faces.

#include <mien/face_code.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::Ran;
using test::run_mien;
using test::ScratchFolder;

class NewTest : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// What the command prints, without its line's end.
  static std::string printed(const std::vector<std::string>& words) {
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out.substr(0, ran.out.find('\n'));
  }
  auto picture(std::vector<std::string> words) const {
    words.insert(words.end(), {"--size", "64", "-o", file("out.png")});
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return test::read(file("out.png")).channels;
  }
  ScratchFolder folder_;
};

TEST_F(NewTest, TheReadmesFirstCommands) {
  const std::string code = printed({"new", "--seed", "hello", "-o", file("mine.face.json")});
  EXPECT_EQ(code, face_code_text({.seed = seed_from_word("hello")}));
  EXPECT_EQ(run_mien({"check", file("mine.face.json")}).out, file("mine.face.json") + ": ok\n");
  EXPECT_FALSE(picture({"render", file("mine.face.json"), "--emotion", "joy"}).empty());
}

TEST_F(NewTest, RecipeFlatFaceAndCodeAreOnePicture) {
  const std::string code = printed({"new", "--seed", "a b", "-o", file("r.face.json")});
  printed({"new", "--code", code, "--flat", "-o", file("f.face.json")});
  const auto by_code = picture({"render", code});
  EXPECT_EQ(picture({"render", file("r.face.json")}), by_code);
  EXPECT_EQ(picture({"render", file("f.face.json")}), by_code);
  EXPECT_NE(picture({"render", code, "--style", "ink"}), by_code);
}

TEST_F(NewTest, AFileOfThatNameComesFirst) {
  const std::string code = printed({"new", "--seed", "x"});
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder_ / "");
  std::ofstream(code) << "{}";
  const Ran ran = run_mien({"check", code});
  std::filesystem::current_path(here);
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("\"format\" is missing"), std::string::npos) << ran.err;
}

TEST_F(NewTest, RelativesHaveCodes) {
  const std::string a = printed({"new", "--seed", "a"}), b = printed({"new", "--seed", "b"});
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"new", "--near", a, "--by", "0.5", "--seed", "1"},
        {"new", "--between", a, b, "--at", "0.25"},
        {"new", "--child-of", a, b, "--seed", "1"}}) {
    const std::string code = printed(words);
    EXPECT_EQ(code, printed(words)) << words[1];
    EXPECT_NE(code, a);
    EXPECT_EQ(run_mien({"check", code}).code, 0);
  }
}

TEST_F(NewTest, CodesAndRecipesSayTheirEdition) {
  EXPECT_EQ(printed({"new", "--seed", "hello", "-o", file("e.face.json")}), "A66CB-AA5S0-14");
  EXPECT_NE(test::read_text(file("e.face.json")).find("\"edition\": \"A\""), std::string::npos);
}

TEST_F(NewTest, PartsAreListed) {
  const Ran all = run_mien({"parts"});
  EXPECT_NE(all.out.find("hair "), std::string::npos);
  EXPECT_NE(all.out.find("eye.size"), std::string::npos);
  EXPECT_NE(all.out.find("styles: soft"), std::string::npos);
  EXPECT_NE(run_mien({"parts", "glasses"}).out.find("glasses=none\n"), std::string::npos);
}

TEST_F(NewTest, CodesOfRecipesAndBack) {
  const std::string plain = printed({"new", "--seed", "hello", "-o", file("r.face.json")});
  EXPECT_EQ(run_mien({"code", file("r.face.json")}).out, plain + "\n");
  EXPECT_EQ(run_mien({"code", "--seed", "hello"}).out, plain + "\n");
  const std::string held = printed({"new", "--seed", "hello", "--hold", "hair=bob", "--hold",
                                    "age=70", "-o", file("h.face.json")});
  EXPECT_EQ(run_mien({"code", file("h.face.json")}).out, held + "\n");
  // What a code says are values to hold; all held, they are the code's face.
  const std::string said = run_mien({"code", held}).out;
  EXPECT_EQ(said.find("code " + held + "\nedition A\nhead="), 0u) << said;
  EXPECT_NE(said.find("\nhair=bob  held; the seed says "), std::string::npos) << said;
  std::vector<std::string> words{"new", "--seed", "other"};
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);)
    if (line.find('=') != std::string::npos)
      words.insert(words.end(), {"--hold", line.substr(0, line.find(' '))});
  EXPECT_EQ(picture({"render", printed(words)}), picture({"render", held}));
  EXPECT_EQ(printed({"code", "a66cbaa5s014"}), "code A66CB-AA5S0-14");
}

TEST_F(NewTest, CodesOfWrittenRecipes) {
  const auto recipe = [&](const std::string& says) {
    std::ofstream(file("w.face.json"))
        << R"({"format": "mien-face", "format_version": 2, )" << says << "}";
    return run_mien({"code", file("w.face.json")});
  };
  const Ran between =
      recipe(R"("parts": {"hair": "bob"}, "numbers": {"age": 33.33}, "style": "ink")");
  EXPECT_EQ(between.code, 0) << between.err;
  EXPECT_NE(between.err.find("say --style ink"), std::string::npos) << between.err;
  EXPECT_NE(between.err.find("age is 33.3"), std::string::npos) << between.err;
  const std::string code = between.out.substr(0, between.out.find('\n'));
  EXPECT_NE(run_mien({"code", code}).out.find("\nhair=bob"), std::string::npos);
  EXPECT_NE(recipe(R"("parts": {"hiar": "bob"})").err.find("did you mean \"hair\""),
            std::string::npos);
  EXPECT_NE(recipe(R"("parts": {"hair": "bbo"})").err.find("did you mean \"bob\""),
            std::string::npos);
  EXPECT_NE(recipe(R"("numbers": {"age": 900})").err.find("age goes from"), std::string::npos);
  EXPECT_NE(recipe(R"("numbers": {"aeg": 9})").err.find("did you mean \"age\""), std::string::npos);
  EXPECT_EQ(recipe(R"("numbers": {"aeg": 9})").code, 1);
  EXPECT_NE(
      run_mien({"code", test::face_path("toon")}).err.find("a face in full has its own paints"),
      std::string::npos);
}

TEST_F(NewTest, PartsOfASheet) {
  const auto drawn = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", file("p.png")});
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return test::read(file("p.png"));
  };
  const auto glasses = drawn({"sheet", "--parts", "glasses", "--columns", "4", "--cell", "48x48"});
  const std::string listed = run_mien({"parts", "glasses"}).out;
  const int count = int(std::count(listed.begin(), listed.end(), '\n'));
  EXPECT_EQ(glasses.spec.width, 4 * 48);
  EXPECT_EQ(glasses.spec.height, (count + 3) / 4 * (48 + 12));  // a name of 12 pixels below each
  // Another head, and another style.
  const std::string code = printed({"new", "--seed", "x"});
  const auto worn =
      drawn({"sheet", code, "--parts", "glasses", "--columns", "4", "--cell", "48x48"});
  EXPECT_EQ(worn.spec.height, glasses.spec.height);
  EXPECT_NE(worn.channels, glasses.channels);
  EXPECT_NE(
      drawn({"sheet", "--parts", "glasses", "--columns", "4", "--cell", "48x48", "--style", "ink"})
          .channels,
      glasses.channels);
  EXPECT_EQ(drawn({"parts", "glasses"}).spec.width, 3 * 320);
}

TEST_F(NewTest, PeopleOfASheet) {
  const Ran ran = run_mien({"sheet", "--people", "6", "--columns", "3", "--cell", "32", "--picture",
                            "--blink 1", "-o", file("s.png")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto sheet = test::read(file("s.png"));
  EXPECT_EQ(sheet.spec.width, 96);
  EXPECT_EQ(sheet.spec.height, 64);
}

/// As many rows as columns; cells shrink where the sheet would be wider than a screen of today.
TEST_F(NewTest, SheetsOfCrowdsAreAboutSquare) {
  const auto size = [&](std::vector<std::string> options) {
    options.insert(options.begin(), "sheet");
    options.insert(options.end(), {"--style", "pictogram", "-o", file("s.png")});
    EXPECT_EQ(run_mien(options).code, 0);
    const auto sheet = test::read(file("s.png"));
    return std::pair{sheet.spec.width, sheet.spec.height};
  };
  EXPECT_EQ(size({"--people", "4"}), std::pair(960, 640));
  EXPECT_EQ(size({"--people", "196"}), std::pair(14 * 292, 14 * 292));
  EXPECT_EQ(size({"--people", "15", "--cell", "20", "--picture", "a: --blink 1", "--picture",
                  "b: --blink 0"}),
            std::pair(6 * 20, 5 * (20 + 12)));
  EXPECT_EQ(size({"--people", "196", "--columns", "98"}), std::pair(98 * 64, 2 * 64));
}

TEST_F(NewTest, StatisticsOfPeople) {
  const Ran table = run_mien({"sheet", "--people", "20", "--statistics"});
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_NE(table.out.find("20 people of the sheet"), std::string::npos);
  EXPECT_NE(table.out.find("elders 65-88"), std::string::npos);
  const Ran json = run_mien(
      {"sheet", "--people", "20", "--cell", "16", "--statistics", "--json", "-o", file("s.png")});
  EXPECT_EQ(json.code, 0) << json.err;
  const auto read = nlohmann::json::parse(json.out);
  EXPECT_EQ(read.at("people"), 20);
  EXPECT_EQ(read.at("counts").at(0).at("group"), "age");
  EXPECT_EQ(test::read(file("s.png")).spec.width, 80);
}

TEST_F(NewTest, TheWorstOfWhatIsWrongIsDrawn) {
  const std::string face = test::face_path("toon"), picture = file("worst.png");
  const Ran ran = run_mien({"check", "--nonsense", face, "-o", picture});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_NE(ran.out.find("hairline_overlaps"), std::string::npos) << ran.out;
  EXPECT_GE(test::read(picture).spec.width, 2 * 300);
  const Ran none = run_mien({"check", "--nonsense", test::face_path("seed0"), "-o", file("n.png")});
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_NE(none.out.find("no picture is written"), std::string::npos) << none.out;
  EXPECT_FALSE(std::filesystem::exists(file("n.png")));
}

/// The command that the warning offers, run as a shell does, writes the very person whose code was printed.
TEST_F(NewTest, LongCodesAreOfferedAsFiles) {
  const std::string a = printed({"new", "--seed", "a"}), b = printed({"new", "--seed", "b"});
  const std::vector<std::string> many{"--hold", "hair=bob",    "--hold", "age=70",
                                      "--hold", "glasses=sun", "--hold", "eyes=round",
                                      "--hold", "mouth=full",  "--hold", "nose=snub"};
  std::vector<std::vector<std::string>> all{{"new", "--child-of", a, b},
                                            {"new", "--near", a, "--by", "0.5"},
                                            {"new", "--between", a, b, "--at", "0.25"},
                                            {"new", "--seed", "it's a b", "--style", "ink"}};
  all.back().insert(all.back().end(), many.begin(), many.end());
  for (const std::vector<std::string>& words : all) {
    const Ran said = run_mien(words);
    EXPECT_EQ(said.code, 0) << said.err;
    const std::string code = said.out.substr(0, said.out.find('\n'));
    ASSERT_GT(code.size(), 40u);
    const std::size_t from = said.err.find("`mien new "), to = said.err.rfind('`');
    ASSERT_LT(from, to) << said.err;
    const std::string offered = said.err.substr(from + 5, to - from - 5);
    const bool child = words[1] == "--child-of";
    EXPECT_TRUE(offered.ends_with(child ? " -o child.face.json" : " -o mine.face.json"));
    const std::string here = "cd '" + file("") + "' && " MIEN_COMMAND + offered + " >printed";
    ASSERT_EQ(std::system(here.c_str()), 0) << here;
    const std::string written = file(child ? "child.face.json" : "mine.face.json");
    EXPECT_EQ(test::read_text(file("printed")), code + "\n") << here;
    EXPECT_EQ(run_mien({"code", written}).out, code + "\n");
  }
  EXPECT_EQ(run_mien({"new", "--seed", "ada"}).err, "");
}

/// So nobody copies a long code: what is kept in a file has kin, too.
TEST_F(NewTest, FilesOfPeopleHaveRelatives) {
  const std::string a = printed({"new", "--seed", "a"}), b = printed({"new", "--seed", "b"});
  const std::string child =
      printed({"new", "--child-of", a, b, "--seed", "1", "-o", file("c.face.json")});
  const std::string c = file("c.face.json");
  EXPECT_EQ(printed({"new", "--child-of", c, a, "--seed", "2"}),
            printed({"new", "--child-of", child, a, "--seed", "2"}));
  EXPECT_EQ(printed({"new", "--between", b, c}), printed({"new", "--between", b, child}));
  EXPECT_EQ(printed({"new", "--near", c, "--seed", "2"}),
            printed({"new", "--near", child, "--seed", "2"}));
  EXPECT_EQ(printed({"new", "--code", c, "--hold", "hair=bob"}),
            printed({"new", "--code", child, "--hold", "hair=bob"}));
  std::ofstream(file("w.face.json"))
      << R"({"format": "mien-face", "format_version": 2, "style": "ink"})";
  EXPECT_NE(run_mien({"new", "--near", file("w.face.json")}).err.find("no code holds a style"),
            std::string::npos);
  std::ofstream(file("w.face.json")) << "{\n1}";
  const Ran bad = run_mien({"new", "--near", file("w.face.json")});
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.err.find("--near " + file("w.face.json") + ":2:"), std::string::npos) << bad.err;
  EXPECT_NE(run_mien({"new", "--child-of", a, "ada"}).err.find("`mien new --seed ada`"),
            std::string::npos);
}

TEST_F(NewTest, BadUseIsASentence) {
  const auto refused = [](const std::vector<std::string>& words, int code,
                          const std::string& what) {
    const Ran ran = run_mien(words);
    EXPECT_EQ(ran.code, code) << ran.err;
    EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  };
  refused({"new", "--code", "A66CB-AA5S0-13"}, 1, "a sign is wrong");
  refused({"new", "--seed", "x", "--hold", "hair=bobb"}, 2, "did you mean \"bob\"");
  refused({"new", "--seed", "x", "--hold", "eye.size=7"}, 2, "eye.size goes from 0.7 to 1.3");
  refused({"new", "--seed", "x", "--style", "inkk"}, 2, "did you mean \"ink\"");
  refused({"new", "--seed", "x", "--code", "A66CB-AA5S0-14"}, 2, "a seed of its own");
  for (const auto& seeded :
       std::vector<std::vector<std::string>>{{"new"},
                                             {"code"},
                                             {"sheet", "--people", "3", "-o", "x.png"},
                                             {"check", "--nonsense", "3"},
                                             {"parts", "check", "x.part.json"}}) {
    std::vector<std::string> words = seeded;
    words.insert(words.end(), {"--seed", ""});
    refused(words, 2, "--seed: an empty word is no seed");
  }
  refused({"new", "--code", "Z66CB-AA5S0-1B"}, 1,
          "edition Z is not known to this version, which has A");
  refused({"new", "--by", "0.5"}, 2, "--near");
  refused({"new", "--near", "A66CB-AA5S0-14", "--by", "2"}, 2, "--by");
  refused({"new", "--near", "A66CB-AA5S0-14", "--between", "a", "b"}, 2, "one of them");
  refused({"parts", "hiar"}, 2, "did you mean \"hair\"");
  refused({"parts", "-o", "x.png"}, 2, "FAMILY");
  refused({"code"}, 2, "--seed");
  refused({"code", "A66CB-AA5S0-14", "--seed", "x"}, 2, "one of them");
  refused({"code", "A66CB-AA5S0-13"}, 1, "a sign is wrong");
  refused({"code", "nobody.json"}, 1, "nobody.json");
  refused({"sheet", "--parts", "hiar", "-o", "x.png"}, 2, "did you mean \"hair\"");
  // A wrong part file is the file's fault, a wrong style the caller's.
  const std::string part = file("bad.part.json");
  std::ofstream(part)
      << R"({"format": "mien-part", "format_version": 1, "family": "hair", "featurs": []})";
  refused({"sheet", "--parts", part, "-o", "x.png"}, 1, "bad.part.json:1:");
  refused({"sheet", "--parts", part, "--style", "inkk", "-o", "x.png"}, 2, "did you mean \"ink\"");
  refused({"sheet", "--parts", "hair", "--people", "3", "-o", "x.png"}, 2, "not both");
  refused({"sheet", "--parts", "hair", "--emotions", "-o", "x.png"}, 2, "not both");
  refused({"sheet", test::face_path("toon"), "--parts", "hair", "-o", "x.png"}, 1, "and no recipe");
  refused({"sheet", "-o", "x.png"}, 2, "--people");
  refused({"sheet", "--people", "3"}, 2, "--output is required");
  refused({"sheet", "--parts", "hair", "--statistics"}, 2, "--statistics: needs --people");
  refused({"sheet", "--people", "3", "--json", "-o", "x.png"}, 2, "--json: needs --statistics");
  refused({"sheet", "--people", "3", "--statistics", "-o", "-"}, 2, "standard output");
  refused({"sheet", "--people", "1000000000", "-o", "x.png"}, 2, "--people");
  refused({"render", "A66CB-AA5S0-13", "-o", "x.png"}, 1, "a sign is wrong");
  refused({"render", test::face_path("toon"), "--style", "ink", "-o", "x.png"}, 1,
          "has its own paints");
  EXPECT_EQ(printed({"new", "--seed", "x", "--hold", "eye.size=7", "--clamp"}).substr(14, 1), "~");
}

}  // namespace
}  // namespace mien
