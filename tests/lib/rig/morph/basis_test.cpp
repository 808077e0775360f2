// Item P7: weights in time, and a face vector out of them.

#include <gtest/gtest.h>

#include <mien/basis.h>
#include <mien/layout.h>

namespace mien {
namespace {

FaceBasis sample_basis() {
  FaceBasis basis;
  basis.basis.columns = 3;
  basis.basis.count = 2;
  basis.basis.mean = {1, 2, 3};
  basis.basis.components = {1, 0, 0, 0, 1, 0};
  basis.weights = {0, 0, 1, 10, 3, 30};
  basis.fps = 3;
  basis.begin = 1;
  return basis;
}

TEST(Basis, WeightsAreThoseOfFramesAndMixedBetween) {
  const FaceBasis basis = sample_basis();
  EXPECT_EQ(weights_at(basis, 1), (std::vector<double>{0, 0}));
  EXPECT_EQ(weights_at(basis, 1 + 1.0 / 3), (std::vector<double>{1, 10}));
  EXPECT_EQ(weights_at(basis, 1 + 2.0 / 3), (std::vector<double>{3, 30}));
  EXPECT_NEAR(weights_at(basis, 1.5)[0], 2, 1e-12);
  EXPECT_EQ(weights_at(basis, -5), (std::vector<double>{0, 0}));
  EXPECT_EQ(weights_at(basis, 99), (std::vector<double>{3, 30}));
}

TEST(Basis, TheVectorIsMeanPlusWeightedComponents) {
  const double weights[] = {2, -1};
  EXPECT_EQ(vector_from_basis(sample_basis(), weights), (FaceVector{3, 1, 3}));
  EXPECT_EQ(vector_from_basis(sample_basis(), {}), (FaceVector{1, 2, 3}));
}

TEST(Basis, AnErrorIsInPixelsLevelsOrAsItIs) {
  Layout layout;
  layout.add("a", SliceKind::point, 2);
  layout.add("b", SliceKind::color, 4);
  layout.add("c", SliceKind::angle, 1);
  const VertexGroups groups = face_vertices(layout, 40);
  EXPECT_EQ(groups.begin, (std::vector<std::size_t>{0, 2, 6, 7}));
  EXPECT_EQ(groups.scale, (std::vector<double>{40, 255, 1}));
}

}  // namespace
}  // namespace mien
