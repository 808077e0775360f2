// The names in part files are explained.

#include "lib/parts/recipe/part_guide.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "lib/parts/library/part_library.h"

namespace mien {
namespace {

/// The keys of every object called `key`, wherever it is.
void names_under(const Reading& in, const JsonNode& node, std::string_view key,
                 std::set<std::string>& names) {
  in.for_each(node, [&](const JsonNode& member, int) {
    const bool wanted = node.kind == JsonKind::object && in.tree.key(member) == key;
    if (wanted && member.kind == JsonKind::object)
      in.for_each(member,
                  [&](const JsonNode& one, int) { names.insert(std::string(in.tree.key(one))); });
    if (member.kind == JsonKind::object || member.kind == JsonKind::array)
      names_under(in, member, key, names);
  });
}

bool explains(std::string_view text, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return text.find(name) != text.npos ||
         (dot != name.npos && text.find(name.substr(0, dot)) != text.npos &&
          text.find(" " + name.substr(dot)) != text.npos);
}

TEST(PartGuide, ExplainsEveryNameOfEveryPart) {
  int names = 0;
  for (const Family& family : PartLibrary::shipped().families())
    for (const Part& part : family.parts) {
      const Reading& in = part.at.in();
      std::set<std::string> used, own;
      for (const char* key : {"points", "values", "adds"})
        names_under(in, *part.at.node, key, used);
      names_under(in, *part.at.node, "numbers", own);
      for (const std::string& name : used) {
        if (own.contains(name)) continue;
        EXPECT_TRUE(explains(part_guide(family.name), name)) << family.name << ": " << name;
        ++names;
      }
    }
  EXPECT_GT(names, 300);
}

TEST(PartGuide, IsInShortLines) {
  for (const Family& family : PartLibrary::shipped().families()) {
    std::istringstream lines{std::string(part_guide(family.name))};
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 112u) << line;
  }
  for (const char* family : {"head", "eyes", "mouth"}) EXPECT_FALSE(part_guide(family).empty());
  EXPECT_TRUE(part_guide("hiar").empty());
}

}  // namespace
}  // namespace mien
