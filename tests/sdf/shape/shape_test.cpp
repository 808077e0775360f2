#include <mien/shape.h>

#include <gtest/gtest.h>

#include <set>

namespace mien::test {

TEST(Shape, EachHasANameOfItsOwn) {
  const Shape all[] = {HalfPlane{}, ParabolaSide{}, Band{},          Disc{},
                       CutDisc{},   Ellipse{},      Triangle{},      Line{},
                       Polyline{},  QuadStroke{},   TaperedStroke{}, Path{}};
  static_assert(std::variant_size_v<Shape> == std::size(all));
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < std::size(all); ++i) {
    EXPECT_EQ(all[i].index(), i);
    names.insert(shape_name(all[i]));
  }
  EXPECT_EQ(names.size(), std::size(all));
  EXPECT_EQ(shape_name(all[0]), "half_plane");
  EXPECT_EQ(shape_name(all[10]), "tapered_stroke");
}

TEST(Shape, AsksTheShapeItHolds) {
  const Shape disc = Disc{{1, 0}, 2};
  EXPECT_EQ(distance(disc, {4, 0}), 1);
  EXPECT_EQ(exactness(disc), (Exactness{true, true}));
  EXPECT_EQ(exactness(Shape(TaperedStroke{})), (Exactness{true, false}));
}

TEST(Shape, IsCarriedFromSpaceToSpace) {
  Map<PixelSpace, FaceSpace> pixel_from_face;
  pixel_from_face.linear = glm::dmat2{100, 0, 0, -100};
  pixel_from_face.shift = {3, 4};
  const auto disc = std::get<Disc>(transformed(pixel_from_face, Shape(Disc{{1, 2}, 0.5})));
  EXPECT_EQ(disc.center, glm::dvec2(103, -196));
  EXPECT_EQ(disc.radius, 50);
}

}  // namespace mien::test
