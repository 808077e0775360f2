#include "sdf/distance/spans.h"

#include <mien/distance.h>

#include <gtest/gtest.h>

namespace mien::batch {
namespace {

std::span<const float> in(const float* p, std::size_t size) {
  return {p, size};
}

TEST(Spans, EqualOrApartIsNoOverlap) {
  float a[8]{}, b[8]{};
  EXPECT_FALSE(overlap_partly(in(a, 8), std::span<float>(b)));
  EXPECT_FALSE(overlap_partly(in(a, 8), std::span<float>(a)));
  EXPECT_FALSE(overlap_partly(in(a, 4), std::span(a).subspan(4)));
  EXPECT_FALSE(overlap_partly(in(nullptr, 0), std::span<float>{}));
}

TEST(Spans, SharedMemoryIsAnOverlap) {
  float a[8]{};
  EXPECT_TRUE(overlap_partly(in(a, 4), std::span(a).subspan(1, 4)));
  EXPECT_TRUE(overlap_partly(in(a + 1, 4), std::span(a).first(4)));
  EXPECT_TRUE(overlap_partly(in(a, 4), std::span(a).first(5)));
  EXPECT_TRUE(overlap_partly(in(a, 8), std::span(reinterpret_cast<double*>(a), 4)));
}

#ifdef NDEBUG
TEST(Spans, TheShortestCounts) {
  const float x[4]{0, 1, 2, 3}, y[4]{};
  float d[4]{-1, -1, -1, -1};
  const QuadBezier point{};
  distances(point, in(x, 4), in(y, 3), std::span(d));
  EXPECT_EQ(d[2], 2);
  EXPECT_EQ(d[3], -1);
  distances(point, in(x, 4), in(y, 4), std::span(d).first(1));
  EXPECT_EQ(d[3], -1);
}
#else
TEST(SpansDeathTest, MisuseIsAsserted) {
  float a[8]{}, b[8]{};
  EXPECT_DEATH(distances(QuadBezier{}, in(a, 4), in(b, 4), std::span(a).subspan(1, 4)),
               "clear of it");
  EXPECT_DEATH(distances(QuadBezier{}, in(a, 4), in(b, 3), std::span(a).first(4)), "equal length");
}
#endif

}  // namespace
}  // namespace mien::batch
