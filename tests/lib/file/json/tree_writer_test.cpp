#include "lib/file/json/tree_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "lib/file/json/json_copy.h"

namespace mien {
namespace {

std::string text_of(const JsonTree& tree) {
  std::string text;
  add_json(tree, tree.root(), text);
  return text;
}

TEST(TreeWriter, WritesWhatATextWouldSay) {
  JsonTree tree("t");
  TreeWriter to(tree);
  to.object();
  to.key("at"), to.pair({1, -2.5});
  to.kept_key(std::string("name of more than fifteen bytes")),
      to.kept_string("so is this: \xC3\xA4");
  to.key("none"), to.array(), to.close();
  to.key("nothing"), to.number(std::numeric_limits<double>::quiet_NaN());
  to.key("zero"), to.number(-0.0);
  to.key("yes"), to.boolean(true);
  to.close();
  const JsonTree moved = std::move(tree);  // its strings stay where they are
  const std::string text = text_of(moved);
  EXPECT_EQ(text, R"({"at": [1, -2.5], "name of more than fifteen bytes": "so is this: \u00e4", )"
                  R"("none": [], "nothing": null, "zero": 0, "yes": true})");
  EXPECT_EQ(text_of(*JsonTree::read(text, "t", {})), text);
  EXPECT_EQ(moved.where(*moved.member(moved.root(), "zero")), "t: /zero");
}

TEST(TreeWriter, CopiesAndReplaces) {
  const std::string text = R"({"a": [1, {"$twice": 2}, null], "b": {"c": "d"}, "e": false})";
  const auto from = JsonTree::read(text, "from", {});
  JsonTree tree("t");
  TreeWriter to(tree);
  to.array();
  to.copy(*from, from->root());
  to.copy(*from, from->root(), [&](const JsonNode& node) {
    const JsonNode* twice = from->member(node, "$twice");
    if (twice) to.number(2 * twice->number);
    return twice != nullptr;
  });
  to.object();
  to.copy_children(*from, from->root(), [](const JsonNode&) { return false; });
  to.key("f"), to.number(7);
  to.close(), to.close();
  EXPECT_EQ(text_of(tree), "[" + text + R"(, {"a": [1, 4, null], "b": {"c": "d"}, "e": false}, )" +
                               text.substr(0, text.size() - 1) + R"(, "f": 7}])");
}

TEST(TreeWriter, Arranges) {
  JsonTree tree("t");
  TreeWriter to(tree);
  const std::int32_t array = to.next();
  to.array();
  std::array<std::int32_t, 3> elements{};
  for (int i = 0; i < 3; ++i) elements[std::size_t(i)] = to.next(), to.number(i);
  to.close();
  std::ranges::swap(elements[0], elements[2]);
  to.arrange(array, elements);
  EXPECT_EQ(text_of(tree), "[2, 1, 0]");
}

TEST(TreeWriter, TreesHaveTheLimitsOfTexts) {
  const std::string text = R"({"a": [[1]], "b": 1000})";
  JsonTree tree("t");
  TreeWriter to(tree);
  const auto from = JsonTree::read(text, "t", {});
  to.copy(*from, from->root());
  const auto same = [&](const FaceLimits& limits) {
    const auto beyond = tree.beyond(limits);
    const auto read = JsonTree::read(text, "t", limits);
    EXPECT_EQ(beyond.has_value(), !read);
    if (beyond && !read) {
      EXPECT_EQ(beyond->what, read.error().what);
    }
    return !beyond;
  };
  EXPECT_TRUE(same({}));
  EXPECT_TRUE(same({.nesting = 3}));
  EXPECT_FALSE(same({.nesting = 2}));
  EXPECT_TRUE(same({.values = 5}));
  EXPECT_FALSE(same({.values = 4}));
  EXPECT_TRUE(same({.magnitude = 1000}));
  EXPECT_FALSE(same({.magnitude = 999}));
}

}  // namespace
}  // namespace mien
