#include <mien/index.h>

#include <gtest/gtest.h>

#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

namespace mien {
namespace {

TEST(Index, IsNoneOrAPlaceInItsList) {
  std::vector<double> list;
  EXPECT_FALSE(Index<double>());
  EXPECT_FALSE(last_of(list));
  list = {1, 4};
  const Index<double> last = last_of(list);
  ASSERT_TRUE(last);
  last.in(list) = 9;
  EXPECT_EQ(last.in(std::as_const(list)), 9);
  EXPECT_EQ(last, Index<double>{1});
}

TEST(Index, OfOneKindIsNoneOfAnother) {
  static_assert(!std::is_convertible_v<Index<double>, Index<float>>);
  static_assert(!std::is_convertible_v<Index<double>, int>);
  static_assert(!std::is_convertible_v<Index<double>, bool>);
  static_assert(!std::equality_comparable_with<Index<double>, Index<float>>);
}

}  // namespace
}  // namespace mien
