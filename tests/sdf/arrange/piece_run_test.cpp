#include "sdf/arrange/piece_run.h"

#include <gtest/gtest.h>

#include "tests/support/random/random_piece.h"

namespace mien::test {
namespace {

/// Down to (20, y) in two pieces each, past one vertical line.
TEST(PieceRun, IsFollowedOverItsPieces) {
  const OutlinePiece first[] = {piece_between({0, 0}, {4, 4}), piece_between({4, 4}, {20, 8})},
                     second[] = {piece_between({8, 0}, {8, 6}), piece_between({8, 6}, {6, 8})};
  const PieceRun left{&first[0], &first[1]}, right{&second[0], &second[1]};
  EXPECT_NEAR(meeting(left, right, 0, 8), 5, 1e-9);
  EXPECT_FALSE(disorder(left, right, 0, 5, kOrder));
  const std::optional<double> wrong = disorder(left, right, 0, 7, kOrder);
  ASSERT_TRUE(wrong);
  EXPECT_GT(*wrong, 5);
  EXPECT_FALSE(disorder(right, left, 5, 8, kOrder));
  EXPECT_TRUE(disorder(right, left, 4.5, 8, kOrder));
}

TEST(PieceRun, ALevelPieceTakesItOverOthersAtOnce) {
  const OutlinePiece step[] = {piece_between({2, 0}, {2, 4}), piece_between({2, 4}, {9, 4}),
                               piece_between({9, 4}, {9, 8})},
                     line = piece_between({5, 0}, {5, 8});
  EXPECT_EQ(meeting(PieceRun{&step[0], &step[2]}, PieceRun{&line, &line}, 0, 8), 4);
}

}  // namespace
}  // namespace mien::test
