#include "lib/base/fingerprint.h"

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

template <class... Numbers>
std::uint64_t of(Numbers... numbers) {
  Fingerprint print;
  (print.add(numbers), ...);
  return print.value();
}

TEST(Fingerprint, IsOfNumbersInTheirOrder) {
  EXPECT_EQ(of(1.5, 2), of(1.5, 2));
  EXPECT_NE(of(1, 2), of(2, 1));
  EXPECT_NE(of(1), of(1, 0));
  EXPECT_NE(of(0.0), of(-0.0));
  EXPECT_NE(of(1), of(1.0));
  EXPECT_NE(Fingerprint(1).value(), Fingerprint(2).value());
}

TEST(Fingerprint, DiffersWhereAnyBitDoes) {
  std::set<std::uint64_t> seen;
  for (int bit = 0; bit < 64; ++bit)
    for (int place = 0; place < 3; ++place) {
      Fingerprint print;
      for (int i = 0; i < 3; ++i)
        print.add(i == place ? std::uint64_t{1} << bit : std::uint64_t{0});
      seen.insert(print.value());
    }
  EXPECT_EQ(seen.size(), 3u * 64u);
}

}  // namespace
}  // namespace mien
