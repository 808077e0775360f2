// mien chernoff: tables as faces.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/pictures/read_back.h"
#include "tests/tools/data_fixture.h"

namespace mien {
namespace {

using ChernoffTest = DataTest;

TEST_F(ChernoffTest, TheManifestSaysWhatEachCellBecame) {
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

TEST_F(ChernoffTest, WrongCellsAreNamed) {
  const std::string features = map(R"({"column": "size", "number": "eye.size", "from": [0, 9]})");
  for (const auto& [table, sentence] : {
           WrongData{"who,size\na,1\nb,\n", "t.csv:3: column \"size\": the number is missing"},
           WrongData{"who,size\na,1\nb,two\n", "expected a finite number, got \"two\""},
           WrongData{"who,size\na,inf\n", "t.csv:2: column \"size\": expected a finite number"},
           WrongData{"who,size\na,nan\n", "expected a finite number"},
           WrongData{"who,size\na,1e999\n", "expected a finite number"},
           WrongData{"who,size\na,10\n", "10 is outside the map's 0 … 9"},
           WrongData{"who,sise\na,1\n", "no column named \"size\"; did you mean \"sise\"?"},
           WrongData{"who,size\na,\"1,5\"\n", "got \"1,5\"; a comma is no decimal point here"},
           WrongData{"who,size\na\xE9,1\n", "t.csv:2: byte E9 is not UTF-8"},
           WrongData{"who,size\na,1,2\n",
                     "t.csv:2: 3 cells separated by commas, the heading has 2"},
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

/// What is wrong with a map is said of the map, not of the table.
TEST_F(ChernoffTest, AColumnThatTheTableDoesNotHaveIsTheMapsFault) {
  const Ran ran = chernoff("who,Size\na,1\n", map(R"({"column": "Sise", "number": "eye.size"})"));
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("m.json:1:"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("/map/0/column: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("t.csv has no column named \"Sise\"; did you mean \"Size\"?"),
            std::string::npos)
      << ran.err;
  const Ran label = chernoff("name,Size\na,1\n", map(R"({"column": "Size", "number": "smile"})"));
  EXPECT_NE(label.err.find("/label: "), std::string::npos) << label.err;
  const Ran blanks =
      chernoff("who , Size\u00a0\na,1\nb,2\n", map(R"({"column": " Size", "number": "smile"})"));
  EXPECT_EQ(blanks.code, 0) << blanks.err;
}

TEST_F(ChernoffTest, LargestNumbersSpanTheirRange) {
  const Ran ran = chernoff("who,size\na,-1e308\nb,0\nc,1e308\n",
                           map(R"({"column": "size", "number": "eye.size", "to": [0.8, 1.2]})"));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(text("c.csv").find("a,-1e308,0.8,"), std::string::npos) << text("c.csv");
  EXPECT_NE(text("c.csv").find("b,0,1,"), std::string::npos) << text("c.csv");
  EXPECT_NE(text("c.csv").find("c,1e308,1.2,"), std::string::npos) << text("c.csv");
}

TEST_F(ChernoffTest, ConstantColumnsAreTold) {
  for (const std::string scale : {"linear", "rank", "quartile"}) {
    const std::string features = R"({"column": "size", "number": "eye.size", "scale": ")" + scale +
                                 R"("}, {"column": "mood", "emotion": "joy"})";
    const Ran ran = chernoff("who,size,mood\na,5,1\nb,5.0,2\n", map(features));
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(
        ran.err.find("t.csv: the same value in every row: \"size\"; all faces have the middle"),
        std::string::npos)
        << ran.err;
  }
  const Ran one = chernoff("who,size\na,5\n", map(R"({"column": "size", "number": "smile"})"));
  EXPECT_NE(one.err.find("has one row"), std::string::npos) << one.err;
  // Ends that the map gives are a scale of their own.
  const Ran given = chernoff("who,size\na,5\nb,5\n",
                             map(R"({"column": "size", "number": "smile", "from": [0, 10]})"));
  EXPECT_EQ(given.err, "");
}

TEST_F(ChernoffTest, DecimalCommasAreReadAndTold) {
  const Ran ran = chernoff("who;size, cm\na;1,5\nb;2,5\nc;10\n",
                           map(R"({"column": "size, cm", "number": "eye.size"})"));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("t.csv:2: column \"size, cm\": numbers are read with decimal commas: "
                         "\"1,5\" is 1.5"),
            std::string::npos)
      << ran.err;
}

TEST_F(ChernoffTest, WrongMapsAreToldAtTheirPlace) {
  for (const auto& [features, sentence] : {
           WrongData{R"({"column": "size", "number": "eye.sise"})", "did you mean \"eye.size\"?"},
           WrongData{R"({"column": "size", "number": "eye.size", "to": [0, 1]})",
                     "eye.size goes from 0.7 to 1.3, got 0 and 1"},
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

/// Names are a column of texts: where a number is missing it is no name.
TEST_F(ChernoffTest, AColumnWithAMissingNumberIsNoLabel) {
  const Ran ran = run_mien({"chernoff", file("gap.csv", "size,mood\n1,5\n,6\n3,7\n"), "-o",
                            path("gap.png"), "--manifest", path("gaps.csv"), "--cell", "32"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(
      ran.err.find("gap.csv:3: column \"size\": the number is missing: the column is not shown"),
      std::string::npos)
      << ran.err;
  EXPECT_NE(text("gaps.csv").find("\n2,6,"), std::string::npos) << text("gaps.csv");
}

TEST_F(ChernoffTest, ATableWithoutAMapIsShown) {
  const Ran ran = run_mien({"chernoff", MIEN_SOURCE_DIR "/examples/chernoff/planets.csv", "-o",
                            path("c.png"), "--cell", "32", "--columns", "4"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(
      ran.err.find("planets.csv:2: column \"Kind\": expected a finite number, got \"rock\": the "
                   "column is not shown"),
      std::string::npos)
      << ran.err;
  EXPECT_EQ(test::read(path("c.png")).spec.width, 4 * 32);
}

TEST_F(ChernoffTest, TheFirstCellThatIsNoNumberIsNamed) {
  const Ran ran = run_mien({"chernoff", file("t.csv", "who,size,mood\na,1,2\nb,2,\nc,3,high\n"),
                            "-o", path("c.png"), "--cell", "32"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(
      ran.err.find("t.csv:3: column \"mood\": the number is missing: the column is not shown"),
      std::string::npos)
      << ran.err;
}

/// By the age parts are chosen, and nothing is drawn.
TEST_F(DataTest, ColumnsThatNobodySeesAreTold) {
  const Ran ran =
      chernoff("who,a,b\nx,1,2\ny,2,1\n",
               map(R"({"column": "a", "number": "age"}, {"column": "b", "number": "smile"})"));
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("/map/0/column: \"a\" moves \"age\", which changes nothing that is seen"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(ran.err.find("/map/1"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace mien
