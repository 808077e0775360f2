// What rides on a composed face's mouth.

#include "lib/parts/compose/flat_mouth.h"

#include <mien/composed_face.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace mien {
namespace {

Face face_wearing(const std::string& family, const std::string& part) {
  Recipe recipe;
  recipe.parts[family] = part;
  return face_from_recipe(recipe).value();
}

const MouthRider* rider_named(const Face& face, const std::string& slice) {
  const auto& riders = face.model->mouth->riders;
  const auto found = std::find_if(riders.begin(), riders.end(), [&](const MouthRider& rider) {
    return face.model->layout[rider.slice].name == slice;
  });
  return found == riders.end() ? nullptr : &*found;
}

double share_of(const Face& face, const MouthRider& rider, const std::string& other) {
  for (const MouthRider::With& with : rider.with)
    if (face.model->layout[with.slice].name == other) return with.share;
  return 0;
}

TEST(FlatMouth, LetsAMoustacheRideOnItsOwnSideStiffly) {
  const Face face = face_wearing("moustache", "walrus");
  for (const std::string side : {"left", "right"}) {
    const MouthRider* rider = rider_named(face, "moustache." + side + "/spine/1");
    ASSERT_TRUE(rider);
    EXPECT_TRUE(rider->stiff);
    EXPECT_DOUBLE_EQ(share_of(face, *rider, "lip_upper." + side + "/spine/0"), 0.6);
    EXPECT_DOUBLE_EQ(share_of(face, *rider, "upper_edge." + side + "/spine/2"), 0.4);
  }
}

TEST(FlatMouth, LetsABeardRideOnBothHalvesOfTheJaw) {
  const Face face = face_wearing("beard", "full");
  double left = 0, right = 0;
  for (const MouthRider& rider : face.model->mouth->riders) {
    left += share_of(face, rider, "head/points/4"), right += share_of(face, rider, "head/points/7");
    if (face.model->layout[rider.slice].name.starts_with("beard_line")) {
      EXPECT_FALSE(rider.stiff);
    }
  }
  EXPECT_GT(left, 1);
  EXPECT_DOUBLE_EQ(left, right);
}

}  // namespace
}  // namespace mien
