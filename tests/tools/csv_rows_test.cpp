// CSV files as programs and people write them.

#include "tools/mien/data/csv_rows.h"

#include <gtest/gtest.h>

namespace mien::command {
namespace {

using Rows = std::vector<std::vector<std::string>>;

const Rows kRows{{"Name", "Size", "Speed"}, {"Ann", "1.5", "10"}, {"Bob", "2.25", "20"}};

CsvRows read(std::string_view text) {
  auto csv = read_csv(text, "t.csv");
  EXPECT_TRUE(csv) << text;
  return csv ? *std::move(csv) : CsvRows{};
}

std::string said(std::string_view text) {
  const auto csv = read_csv(text, "t.csv");
  return csv ? "is read" : csv.error().where + ": " + csv.error().what;
}

TEST(CsvRows, AreTheSameInEveryDress) {
  for (const std::string_view text :
       {"Name,Size,Speed\nAnn,1.5,10\nBob,2.25,20\n",
        "\xEF\xBB\xBFName,Size,Speed\r\nAnn,1.5,10\r\nBob,2.25,20",
        "Name,Size,Speed\rAnn,1.5,10\rBob,2.25,20\r",
        "\"Name\",\"Size\",\"Speed\"\n\"Ann\",\"1.5\",\"10\"\n\"Bob\",\"2.25\",\"20\"\n",
        "Name, Size, Speed\n\nAnn, 1.5, 10\nBob, 2.25, 20\n\n",
        "Name;Size;Speed\nAnn;1.5;10\nBob;2.25;20\n",
        "Name\tSize\tSpeed\nAnn\t1.5\t10\nBob\t2.25\t20\n",
        "sep=;\r\nName;Size;Speed\r\nAnn;1.5;10\r\nBob;2.25;20\r\n",
        "Name|Size|Speed\nAnn|1.5|10\nBob|2.25|20\n",
        "sep=,\nName,Size,Speed\nAnn,1.5,10\nBob,2.25,20\n",
        "\"sep=\t\"\nName\tSize\tSpeed\nAnn\t1.5\t10\nBob\t2.25\t20\n"}) {
    const CsvRows csv = read(text);
    EXPECT_EQ(csv.rows, kRows) << text;
    EXPECT_FALSE(csv.decimal_commas) << text;
  }
}

TEST(CsvRows, KnowTheirLines) {
  EXPECT_EQ(read("a,b\n\n1,\"x\ny\"\r\n\n2,3\n").lines, (std::vector<std::size_t>{1, 3, 6}));
  EXPECT_EQ(read("sep=;\na;b\n1;2\n").lines, (std::vector<std::size_t>{2, 3}));
}

/// A decimal comma beside a comma in the heading: the cells tell what separates them.
TEST(CsvRows, HaveDecimalCommasWhereOtherSignsSeparate) {
  for (const std::string_view text :
       {"Name;Size;Speed\nAnn;1,5;10\n", "Name;Size, cm;Speed, km/h\nAnn;1,5;10\n",
        "x, cm;y\n1,5;10\n2,5;3\n", "a\tb\nx\t1,5\n"}) {
    const CsvRows csv = read(text);
    EXPECT_TRUE(csv.decimal_commas) << text;
    EXPECT_NE(csv.separator, ',') << text;
  }
  EXPECT_EQ(csv_number("1,5", true), 1.5);
  EXPECT_EQ(csv_number(" +1,5e3 ", true), 1500);
  for (const std::string_view wrong : {"1.234,5", "1,2,3", "1,5x", "", ",", "inf", "1e999"})
    EXPECT_FALSE(csv_number(wrong, true)) << wrong;
  EXPECT_FALSE(csv_number("1,5", false));
  // Points beside commas: the commas may be of thousands.
  EXPECT_FALSE(read("a;b\n1,234;5.5\n").decimal_commas);
  EXPECT_FALSE(read("a,b\n\"1,5\",x\n").decimal_commas);
}

TEST(CsvRows, AreNotGuessedWhereTwoReadingsAreAsGood) {
  EXPECT_EQ(said("a;b,c\nx;2,y;3\n"), "is read");  // commas: no cell is a number either way
  EXPECT_EQ(said("a;x, cm\nAnn;1,5\n"),
            "t.csv: cells may be separated by commas or by semicolons; a first line \"sep=,\" or "
            "\"sep=;\" tells which");
  EXPECT_EQ(read("sep=;\na;x, cm\nAnn;1,5\n").rows[1], (std::vector<std::string>{"Ann", "1,5"}));
}

TEST(CsvRows, AreUtf8) {
  const std::string how = "; tables are UTF-8: save it as \"CSV UTF-8\"";
  EXPECT_EQ(said(std::string_view("\xFF\xFE"
                                  "a\0,\0b\0\n\0",
                                  10)),
            "t.csv: is UTF-16" + how);
  EXPECT_EQ(said(std::string_view("\xFE\xFF\0a\0,\0b\0\n", 10)), "t.csv: is UTF-16" + how);
  EXPECT_EQ(said(std::string_view("a\0,\0b\0\n\0", 8)), "t.csv: is UTF-16" + how);
  EXPECT_EQ(said("a,b\nAnn\xE9,1\n"), "t.csv:2: byte E9 is not UTF-8, perhaps Latin-1" + how);
  EXPECT_EQ(said(std::string_view("a,b\nA\0n,1\n", 10)), "t.csv:2: a NUL byte, which no text has");
}

TEST(CsvRows, SayWhereTheyAreBroken) {
  EXPECT_EQ(said("a,b\n\n1,2\n1,2,3\n"), "t.csv:4: 3 cells separated by commas, the heading has 2");
  EXPECT_EQ(said("a;b;c\n1;2\n"), "t.csv:2: 2 cells separated by semicolons, the heading has 3");
  EXPECT_EQ(said("a,b\n1,2\n\"1,2\n"),
            "t.csv:3: quotes that do not end, or that stand inside a cell without quotes");
  EXPECT_EQ(said("sep=:\na:b\n1:2\n"),
            "t.csv:1: cells are separated by commas, semicolons, tabs or bars, not by \":\"");
  EXPECT_EQ(said(""), "is read");
  EXPECT_EQ(said("sep=;"), "is read");
  EXPECT_EQ(said("a,b"), "is read");
}

}  // namespace
}  // namespace mien::command
