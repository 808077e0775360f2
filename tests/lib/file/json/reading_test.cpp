// Typed access to JSON: what is not as it should be is refused, with its place.
#include "lib/file/json/reading.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace mien {
namespace {

/// What `ask` refuses of the member "a" of `text`; "" if nothing.
std::string refused(std::string_view text,
                    const std::function<void(const Reading&, const JsonNode&)>& ask) {
  const FaceLimits limits;
  const auto tree = JsonTree::read(text, "t", limits);
  const Reading reading(*tree, limits, nullptr);
  try {
    ask(reading, reading.need(tree->root(), "a"));
  } catch (const Refusal& refusal) {
    return refusal.error.where + " " + refusal.error.what;
  }
  return "";
}

TEST(Reading, RefusesWhatIsOfAnotherKindWithItsPlace) {
  const auto numbers = [](const Reading& r, const JsonNode& n) { r.numbers(n, 2, 2); };
  EXPECT_EQ(refused(R"({"a": [1, 2]})", numbers), "");
  EXPECT_EQ(refused(R"({"a": [1, 2, 3]})", numbers).substr(0, 11), "t:1:7: /a e");
  EXPECT_EQ(refused(R"({"a": [1, "2"]})", numbers).substr(0, 12), "t:1:11: /a/1");
  EXPECT_NE(refused(R"({"b": 1})", numbers), "");
  const auto range = [](const Reading& r, const JsonNode& n) { r.range(n); };
  EXPECT_EQ(refused(R"({"a": [1, 2]})", range), "");
  EXPECT_NE(refused(R"({"a": [2, 1]})", range), "");
}

TEST(Reading, RefusesKeysThatMeanNothing) {
  const auto only = [](const Reading& r, const JsonNode& n) { r.expect_only(n, {"to"}, "way"); };
  EXPECT_EQ(refused(R"({"a": {"to": 1, "comment": ""}})", only), "");
  EXPECT_EQ(refused(R"({"a": {"to": 1, "ot": 1}})", only),
            "t:1:17: /a/ot no key of a way named \"ot\"");
  EXPECT_EQ(refused(R"({"a": 1})", only).substr(0, 11), "t:1:7: /a e");
  const auto plain = [](const Reading& r, const JsonNode& n) { r.expect_only(n, {"seed"}); };
  EXPECT_EQ(refused(R"({"a": {"sede": 1}})", plain),
            "t:1:8: /a/sede no key named \"sede\"; did you mean \"seed\"?");
}

TEST(Reading, KnowsWordsByTheirPlace) {
  static constexpr std::string_view kWords[] = {"red", "green"};
  const auto word = [](const Reading& r, const JsonNode& n) {
    EXPECT_EQ(r.word(n, "a colour", kWords), 1u);
  };
  EXPECT_EQ(refused(R"({"a": "green"})", word), "");
  EXPECT_NE(refused(R"({"a": "gren"})", word).find("green"), std::string::npos);
}

}  // namespace
}  // namespace mien
