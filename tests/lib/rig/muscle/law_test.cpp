#include "lib/rig/muscle/law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"

namespace mien {
namespace {

MusclePointLaw random_law(test::Random& random) {
  MusclePointLaw law{random.point(-100, 100), random.between(1, 50), 8, false, {}};
  const int count = 1 + random.below(5);
  for (int i = 0; i < count; ++i)
    law.springs.push_back({random.point(-100, 100), random.between(1, 100),
                           random.between(-30, 150), Side(random.below(3))});
  return law;
}

TEST(MuscleLaw, TheForceIsTheFallOfTheEnergy) {  // M8
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const MusclePointLaw law = random_law(random);
    const glm::dvec2 p = random.point(-100, 100), force = muscle_force(law, p);
    const double h = 1e-4;
    const auto slope = [&](glm::dvec2 way) {
      return (muscle_energy(law, p + h * way) - muscle_energy(law, p - h * way)) / (2 * h);
    };
    const double size = 1e-5 * (1 + std::abs(force.x) + std::abs(force.y));
    EXPECT_NEAR(force.x, -slope({1, 0}), size);
    EXPECT_NEAR(force.y, -slope({0, 1}), size);
  }
}

TEST(MuscleLaw, TheStiffnessIsTheFallOfTheForce) {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const MusclePointLaw law = random_law(random);
    const glm::dvec2 p = random.point(-100, 100);
    const double h = 1e-5;
    const glm::dvec2 by_x =
        (muscle_force(law, p + glm::dvec2{h, 0}) - muscle_force(law, p - glm::dvec2{h, 0})) /
        (2 * h);
    const glm::dvec2 by_y =
        (muscle_force(law, p + glm::dvec2{0, h}) - muscle_force(law, p - glm::dvec2{0, h})) /
        (2 * h);
    const MuscleStiffness stiffness = muscle_stiffness(law, p);
    EXPECT_NEAR(stiffness.xx, -by_x.x, 1e-3 * (1 + std::abs(stiffness.xx)));
    EXPECT_NEAR(stiffness.yy, -by_y.y, 1e-3 * (1 + std::abs(stiffness.yy)));
    EXPECT_NEAR(stiffness.xy, -by_x.y, 1e-3 * (1 + std::abs(stiffness.xy)));
  }
}

TEST(MuscleLaw, MirroredLawsHaveMirroredForcesToTheBit) {  // M5
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const MusclePointLaw law = random_law(random);
    MusclePointLaw mirrored = law;
    mirrored.rest.x = -law.rest.x;
    for (MuscleSpring& spring : mirrored.springs)
      spring.origin.x = -spring.origin.x, spring.side = other(spring.side);
    const glm::dvec2 p = random.point(-100, 100), force = muscle_force(law, p);
    const glm::dvec2 there = muscle_force(mirrored, {-p.x, p.y});
    EXPECT_EQ(there.x, -force.x);
    EXPECT_EQ(there.y, force.y);
  }
}

/// A stroke longer than the muscle: at the origin it holds against what is weaker, and gives way to the
/// rest of what is stronger.
TEST(MuscleLaw, ATipHoldsUpToItsForce) {  // M8
  MusclePointLaw law{{0, 3}, 10, 8, false, {{{0, 0}, 5, -7, Side::none}}};
  EXPECT_EQ(muscle_force(law, {0, 0}), (glm::dvec2{0, 0}));  // 30 against 35
  law.rest = {0, 4};
  EXPECT_EQ(muscle_force(law, {0, 0}), (glm::dvec2{0, 5}));  // 40 against 35
}

}  // namespace
}  // namespace mien
