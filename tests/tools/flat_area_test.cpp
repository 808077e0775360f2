#include "tools/mien/people/flat_area.h"
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

FlatArea area_of(const Face& face, const std::string& name) {
  const std::vector<Feature>& all = face.model->features;
  const auto found = std::ranges::find_if(all, [&](const Feature& f) { return f.name == name; });
  if (found == all.end()) throw std::runtime_error("no feature " + name);
  return flat_area(found->figure, face);
}

double size_of(const FlatArea& area) {
  double size = 0;
  for (const Polygon& loop : area.loops) size += std::abs(signed_area(loop));
  return size;
}

TEST(FlatArea, OfAnEllipseIsNearlyItsOwn) {
  const Face face = test::sample_face("toon");
  const FlatArea pupil = area_of(face, "pupil.left");
  const glm::dvec2 size = pupil.box.size();
  EXPECT_NEAR(size_of(pupil) / (std::numbers::pi / 4 * size.x * size.y), 1, 0.02);
  EXPECT_TRUE(pupil.covers(pupil.box.center()));
  EXPECT_FALSE(pupil.covers(pupil.box.lo));
}

TEST(FlatArea, OfAnOpeningGoesWhenLidsShut) {
  const Face face = test::sample_face("toon");
  const double open = size_of(area_of(face, "opening.left"));
  EXPECT_GT(open, 0);
  EXPECT_LT(size_of(area_of(test::face_at(face, {"blink=0.5"}), "opening.left")), 0.7 * open);
  EXPECT_LT(size_of(area_of(test::face_at(face, {"blink=1"}), "opening.left")), 1e-12);
}

TEST(FlatArea, OfAPenLineIsAsWideAsThePen) {
  const Face face = test::sample_face("toon");
  const FlatArea brow = area_of(face, "brow.left");
  ASSERT_FALSE(brow.pen.empty());
  EXPECT_TRUE(brow.loops.empty());
  const PenSample middle = brow.pen[brow.pen.size() / 2];
  EXPECT_TRUE(brow.covers(middle.at));
  EXPECT_TRUE(brow.covers(middle.at + glm::dvec2{0, 0.9 * middle.half_width}));
  EXPECT_FALSE(brow.covers(middle.at + glm::dvec2{0, 2 * middle.half_width}));
}

TEST(FlatArea, OfAPathWithBendsHoldsItsMiddle) {
  const Face face = test::sample_face("toon");
  const FlatArea head = area_of(face, "head");
  ASSERT_EQ(head.loops.size(), 1u);
  EXPECT_TRUE(head.covers(head.box.center()));
  EXPECT_FALSE(head.covers(head.box.lo));
}

}  // namespace
}  // namespace mien
