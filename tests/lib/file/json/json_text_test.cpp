#include "lib/file/json/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

TEST(JsonString, ReadsBackAndIsAscii) {
  for (const std::string& text : {std::string("plain"), std::string("q\" b\\ n\n t\t \x01\x7f"),
                                  std::string("Žofie 😀 ﷽"), std::string("a\0b", 3)}) {
    const std::string json = json_string(text);
    EXPECT_EQ(nlohmann::json::parse(json).get<std::string>(), text);
    EXPECT_TRUE(std::all_of(json.begin(), json.end(), [](char c) { return c >= 0x20 && c < 0x7f; }))
        << json;
  }
}

TEST(JsonString, ReplacesBrokenUtf8) {
  EXPECT_EQ(json_string("a\xff"
                        "b\xc3"),
            "\"a\\ufffdb\\ufffd\"");
}

TEST(JsonNumber, ReadsBack) {
  for (double v : {0.1, -1e300, 5e-324, 3.0})
    EXPECT_EQ(nlohmann::json::parse(json_number(v)).get<double>(), v);
  EXPECT_EQ(json_number(NAN), "null");
  EXPECT_EQ(json_number(INFINITY), "null");
}

}  // namespace
}  // namespace mien
