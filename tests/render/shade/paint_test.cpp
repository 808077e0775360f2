#include "render/shade/paint.h"

#include <gtest/gtest.h>

#include "render/shade/paint_table.h"

#include <cmath>
#include <memory>

namespace mien {
namespace {

constexpr View kPaintView{.width = 200, .height = 200};  // 100 px a unit

std::unique_ptr<PaintTable> table_of(const Paint& paint) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.shape(Disc{{0, 0}, 0.5});  // area 0
  build.layer("layer", build.everywhere(), paint);
  auto table = std::make_unique<PaintTable>();
  table->make(std::move(build).finish(), kPaintView, Depth::u8);
  return table;
}

/// At a pixel counted from the picture's middle.
double place(const Gradient& gradient, glm::dvec2 pixel) {
  const auto table = table_of({.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  const PaintField& field = table->varied.at(0).paint.field;
  const glm::dvec2 p = pixel + glm::dvec2{100, 100};
  return field.at(p, field.distance < 0 ? 0 : table->distances[std::size_t(field.distance)].at(p));
}

TEST(PaintField, IsTheGradientsPlaceInPixels) {  // y is down in pixels
  const std::vector<Stop> stops{{0, {}}, {1, {}}};
  EXPECT_NEAR(place({LinearGradient{{0, 0}, {0.5, 0}}, stops}, {20, 77}), 0.4, 1e-14);
  EXPECT_NEAR(place({LinearGradient{{0, 0}, {0, 0.5}}, stops}, {3, -20}), 0.4, 1e-14);
  EXPECT_NEAR(place({RadialGradient{{0.1, 0.2}, {0.5, 0.25}}, stops}, {10, -45}), 1, 1e-14);
  EXPECT_NEAR(place({RadialGradient{{0.1, 0.2}, {0.5, 0.25}, {0, 1}}, stops}, {10, -45}), 0.5,
              1e-14);
  EXPECT_NEAR(place({DistanceGradient{Area{0}, -0.1, 0.3}, stops}, {60, 0}), 0.5, 1e-14);
}

TEST(PaintField, ItsMeanIsThatOfManyPlaces) {
  PaintField field{
      .kind = PaintField::Kind::radial, .center = {3, 4}, .unit = {0.2, 0.05, -0.1, 0.3}};
  for (const glm::dvec2 p : {glm::dvec2{8, 9}, {-2, 4}, {3, 12}}) {
    double sum = 0.0;
    constexpr int kSide = 50;  // places over a pixel
    for (int i = 0; i < kSide * kSide; ++i)
      sum += field.at(p + (glm::dvec2{i % kSide, i / kSide} + 0.5) / double(kSide) - 0.5, 0.0);
    EXPECT_NEAR(field.mean(p, 1.0 / 12), sum / (kSide * kSide), 1e-4);
    EXPECT_GT(std::abs(field.at(p, 0.0) - sum / (kSide * kSide)),
              2e-4);  // the middle is not enough
  }
  field.kind = PaintField::Kind::linear, field.across = {0.5, 0.25}, field.shift = 1.0;
  EXPECT_EQ(field.mean({2, 4}, 1.0 / 12), 3.0);
}

}  // namespace
}  // namespace mien
