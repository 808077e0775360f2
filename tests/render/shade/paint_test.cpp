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

}  // namespace
}  // namespace mien
