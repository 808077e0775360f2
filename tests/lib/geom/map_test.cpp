#include <gtest/gtest.h>
#include <mien/map.h>

namespace mien {
namespace {

struct EyeSpace;
using FaceFromEye = Map<FaceSpace, EyeSpace>;
using PixelFromFace = Map<PixelSpace, FaceSpace>;

/// Turned by a quarter, twice as large, mirrored if asked.
template <class To, class From>
Map<To, From> quarter_turn(bool mirrored) {
  return {{{0, 2}, {mirrored ? 2 : -2, 0}}, {5, 7}};
}

void expect_near(glm::dvec2 a, glm::dvec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

TEST(Map, TurnsAndShiftsPointsButOnlyTurnsDirections) {
  const auto map = quarter_turn<PixelSpace, FaceSpace>(false);
  expect_near(map({1, 0}), {5, 9});
  expect_near(map.direction({1, 0}), {0, 2});
  expect_near(map({0, 1}), {3, 7});
  EXPECT_DOUBLE_EQ(map.scale(), 2.0);
  EXPECT_FALSE(map.mirrors());
  EXPECT_TRUE((quarter_turn<PixelSpace, FaceSpace>(true).mirrors()));
}

TEST(Map, ComposesRightToLeft) {
  const FaceFromEye face_from_eye{glm::dmat2{3.0}, {1, -1}};
  const PixelFromFace pixel_from_face = quarter_turn<PixelSpace, FaceSpace>(true);
  const Map<PixelSpace, EyeSpace> pixel_from_eye = pixel_from_face * face_from_eye;
  for (const glm::dvec2 p : {glm::dvec2{0, 0}, {1, 2}, {-3.5, 0.25}})
    expect_near(pixel_from_eye(p), pixel_from_face(face_from_eye(p)));
  EXPECT_DOUBLE_EQ(pixel_from_eye.scale(), 6.0);
}

template <class A, class B>
concept Composes = requires(A a, B b) {
  a* b;
};
static_assert(Composes<PixelFromFace, FaceFromEye>);
static_assert(!Composes<FaceFromEye, PixelFromFace>, "the spaces in the middle must meet");

TEST(Map, ComesBack) {
  for (const bool mirrored : {false, true}) {
    const auto map = quarter_turn<PixelSpace, FaceSpace>(mirrored);
    const Map<FaceSpace, PixelSpace> back = inverse(map);
    for (const glm::dvec2 p : {glm::dvec2{0, 0}, {1, 2}, {-3.5, 0.25}})
      expect_near(back(map(p)), p);
    EXPECT_DOUBLE_EQ(back.scale(), 0.5);
    EXPECT_EQ(back.mirrors(), mirrored);
  }
}

}  // namespace
}  // namespace mien
