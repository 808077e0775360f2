#include <gtest/gtest.h>

#include <mien/matrix_source.h>

#include <vector>

namespace mien {
namespace {

TEST(MatrixSource, GivesAnyBlockRowByRow) {
  const std::vector<double> numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const MatrixSource matrix = matrix_in_memory(numbers, 3, 4);
  std::vector<double> block(4);
  ASSERT_TRUE(matrix.read({1, 2, 2, 2}, block.data()));
  EXPECT_EQ(block, (std::vector<double>{7, 8, 11, 12}));
}

}  // namespace
}  // namespace mien
