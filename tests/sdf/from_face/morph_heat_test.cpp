// Item G6: the bar's top is the largest displacement, and that point is drawn in its colour.

#include <gtest/gtest.h>

#include <mien/morph.h>
#include <mien/morph_heat.h>
#include <mien/text_path.h>
#include "sdf/from_face/heat.h"

#include "tests/support/faces/faces.h"

namespace mien {
namespace {

TEST(MorphHeat, TheLargestIsThatOfThePoints) {
  const Face rest = test::face_named("toon"), posed = test::posed(rest, {"ah=0.8"});
  const MorphHeat heat = morph_heat(rest, posed, shipped_lettering());
  EXPECT_EQ(heat.largest, largest_shift(point_shifts(rest, posed)));
  EXPECT_GT(heat.largest, 0.1);
  bool seen = false;
  for (const Layer& layer : heat.scene.layers()) seen = seen || layer.paint.color == heat_color(1);
  EXPECT_TRUE(seen);
}

TEST(MorphHeat, AtRestNothingIsHot) {
  for (const char* name : {"toon", "seed0", "male"}) {
    const Face rest = test::face_named(name);
    const MorphHeat heat = morph_heat(rest, rest);
    EXPECT_EQ(heat.largest, 0);
    for (const Layer& layer : heat.scene.layers())
      EXPECT_TRUE(layer.name == "bar" || layer.paint.color != heat_color(1));
  }
}

}  // namespace
}  // namespace mien
