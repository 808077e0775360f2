#include "lib/file/json/text_edits.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(TextEdits, KnowsWhereAValueEnds) {
  const std::string text = R"({"a": [1, {"b": "]}\"\\"}] , "c": -1.5e3,"d":true})";
  const auto value = [&](std::string_view from) {
    const std::size_t begin = text.find(from);
    return text.substr(begin, json_end(text, begin) - begin);
  };
  EXPECT_EQ(value("{\"a"), text);
  EXPECT_EQ(value("[1"), R"([1, {"b": "]}\"\\"}])");
  EXPECT_EQ(value("{\"b"), R"({"b": "]}\"\\"})");
  EXPECT_EQ(value("\"]}"), R"("]}\"\\")");
  EXPECT_EQ(value("-1"), "-1.5e3");
  EXPECT_EQ(value("true"), "true");
  EXPECT_EQ(json_end("[1, [", 0), 5u);  // never beyond the text
  EXPECT_EQ(json_end("\"a\\", 0), 3u);
}

TEST(TextEdits, ChangesPlacesAndNothingElse) {
  const std::string text = "[1,  2, 3]";
  TextEdits edits(text);
  EXPECT_EQ(edits.text(), text);
  edits.replace(5, "20");
  edits.insert(9, ", 4");
  edits.insert(9, ", 5");
  edits.replace(1, "10");
  EXPECT_EQ(edits.text(), "[10,  20, 3, 4, 5]");
  EXPECT_EQ(edits.text(4, 7), " 20,");
}

}  // namespace
}  // namespace mien
