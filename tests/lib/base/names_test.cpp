#include <mien/names.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mien {
namespace {

TEST(Names, StayWhereTheyAre) {
  Names names;
  std::vector<std::string_view> kept;
  std::vector<std::string> said;
  for (int i = 0; i < 20'000; ++i) {
    said.push_back("name " + std::to_string(i));
    kept.push_back(names.keep({"name", " ", std::to_string(i)}));
  }
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i], said[i]);
  const char* const place = kept[0].data();
  const Names moved = std::move(names);
  EXPECT_EQ(kept[0].data(), place);
  EXPECT_EQ(kept[0], "name 0");
}

TEST(Names, TakeTextsOfAnyLength) {
  Names names;
  const std::string large(1'000'000, 'a');
  const std::string_view none = names.keep(""), kept = names.keep(large), one = names.keep("b");
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(kept, large);
  EXPECT_EQ(one, "b");
}

TEST(Names, ACopyOutlivesTheFirstAndHasItsOwn) {
  std::string_view shared, own;
  Names copy;
  {
    Names first;
    shared = first.keep("of both");
    copy = first;
    own = copy.keep("of the copy");
    EXPECT_EQ(first.keep("of the first"), "of the first");
  }
  EXPECT_EQ(shared, "of both");
  EXPECT_EQ(own, "of the copy");
}

}  // namespace
}  // namespace mien
