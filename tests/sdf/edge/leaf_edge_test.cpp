#include <mien/sdf/edge/leaf_edge.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(LeafEdge, HasNoEndUnlessOneIsGiven) {
  EXPECT_FALSE(LeafEdge{}.has_end());
  LeafEdge edge{};
  edge.end_bend = 0.5f;
  EXPECT_TRUE(edge.has_end());
}

TEST(LeafOutline, PromisesNothingUnlessTold) {
  EXPECT_EQ(LeafOutline{}.error, kUnproven);
}

TEST(EndHalo, IsMoreThanHalfAPixelsDiagonal) {
  EXPECT_GT(kEndHalo * kEndHalo, 0.5f);
}

}  // namespace
}  // namespace mien
