#include <mien/name_table.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mien {
namespace {

TEST(NameTable, FindsWhatWasEntered) {
  std::vector<std::string> names;
  NameTable table;
  const auto find = [&](std::string_view name) {
    return table.find(name, [&](int i) -> std::string_view { return names[std::size_t(i)]; });
  };
  EXPECT_EQ(find("0"), -1) << "empty";
  for (int i = 0; i < 3000; ++i) {
    names.push_back(std::to_string(i * 7919));
    table.enter(names.back(), i);
  }
  for (int i = 0; i < 3000; ++i) EXPECT_EQ(find(names[std::size_t(i)]), i);
  EXPECT_EQ(find("1"), -1);
  EXPECT_EQ(find(""), -1);
  table.enter("", 3000), names.emplace_back();
  EXPECT_EQ(find(""), 3000);
}

}  // namespace
}  // namespace mien
