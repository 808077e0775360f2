#include "lib/rig/eye/bulge.h"
#include "lib/rig/eye/gaze.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/faces/eye_surface.h"

namespace mien {
namespace {

using test::eye_surface;

constexpr EyeBody kEye{.center = {0.2, 0.1}, .radius = 0.2, .cornea = 0.04, .bulge = 0.02};
constexpr glm::dvec3 kAhead{0, 0, 1};

glm::dvec3 tilted(double angle, double around = 0) {
  return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)};
}
double rim(const EyeBody& eye) {
  return std::acos(1 - eye.cornea / eye.radius);
}

TEST(Bulge, IsExactlyNothingOutsideTheCapAndAtBulge0_C1) {
  const double alpha = rim(kEye);
  for (double theta = 0; theta < 3.1; theta += 0.01) {
    const double push = lid_push(kEye, tilted(theta, 2), kAhead);
    if (theta > alpha + 1e-9) {
      EXPECT_EQ(push, 0) << theta;
    } else if (theta < alpha - 1e-3) {
      EXPECT_GT(push, 0) << theta;
    }
    EyeBody flat = kEye;
    flat.bulge = 0;
    EXPECT_EQ(lid_push(flat, tilted(theta, 2), kAhead), 0);
    EXPECT_EQ(edge_push(flat, {0.25, 0.13}, kAhead), glm::dvec2(0));
  }
  EXPECT_EQ(lid_push(kEye, kAhead, kAhead), kEye.bulge);
}

/// u is the chord in units of the rim's own chord; the law is smooth: no kink on the axis nor at the
/// rim.
TEST(Bulge, FollowsItsLawWithoutAKink_C1) {
  const double alpha = rim(kEye), rim_chord = glm::length(tilted(alpha) - kAhead);
  for (double theta = 0; theta < alpha; theta += 0.01) {
    const double u = glm::length(tilted(theta) - kAhead) / rim_chord;
    EXPECT_NEAR(u, std::sin(theta / 2) / std::sin(alpha / 2), 1e-12);
    EXPECT_NEAR(lid_push(kEye, tilted(theta), kAhead), kEye.bulge * std::pow(1 - u * u, 2), 1e-15);
  }
  const auto slope = [](double theta) {
    return (lid_push(kEye, tilted(theta + 1e-6), kAhead) -
            lid_push(kEye, tilted(theta - 1e-6), kAhead)) /
           2e-6;
  };
  EXPECT_NEAR(slope(0), 0, 1e-9);
  EXPECT_NEAR(slope(alpha), 0, 1e-6);
  for (double theta = -1; theta < 1; theta += 1e-3)
    EXPECT_LT(std::abs(slope(theta + 1e-3) - slope(theta)), 1e-3)
        << theta;  // a cone's jumps by 0.04
}

TEST(Bulge, CompatIsTheSourcesFormula_C1) {
  EyeBody eye{.center = {0, 0}, .radius = 1, .cornea = 0.3, .bulge = 0.5, .law = BulgeLaw::compat};
  const double a = std::sqrt(0.3 * 1.7);
  std::mt19937 random{3};
  std::normal_distribution<double> normal;
  int pushed = 0;
  for (int i = 0; i < 500; ++i) {
    const auto direction = [&] {
      const glm::dvec3 v{normal(random), normal(random), std::abs(normal(random))};
      return glm::normalize(v);
    };
    const glm::dvec3 d = direction(), g = direction();
    const double want = 0.5 * std::max(0.0, a - std::min(1.0, glm::length(d - g)));
    EXPECT_NEAR(lid_push(eye, d, g), want, 1e-15);
    pushed += want > 0;
    const glm::dvec2 p{0.9 * d.x, 0.9 * d.y};  // along the axis, not outwards
    const glm::dvec2 moved = edge_push(eye, p, g);
    EXPECT_NEAR(moved.x * g.y, moved.y * g.x, 1e-15);
  }
  EXPECT_GT(pushed, 50);
}

/// Native: everything times s is the push times s. The source's is not (its a is a length beside a
/// pure number).
TEST(Bulge, ScalesWithTheEye_C1) {
  for (const double s : {0.25, 8.0, 3.7}) {
    const EyeBody big{.center = s * kEye.center,
                      .radius = s * kEye.radius,
                      .cornea = s * kEye.cornea,
                      .bulge = s * kEye.bulge};
    const glm::dvec3 g = gaze_axis({0.05, -0.02}, kEye.radius);
    for (double x = 0.02; x < 0.4; x += 0.013)
      for (double y = -0.1; y < 0.3; y += 0.017) {
        const glm::dvec2 small = edge_push(kEye, {x, y}, g),
                         large = edge_push(big, s * glm::dvec2{x, y}, g);
        EXPECT_LT(glm::length(large - s * small), 1e-15 * s);
        EXPECT_NEAR(lid_rise(big, s * glm::dvec2{x, y}, g), s * lid_rise(kEye, {x, y}, g),
                    1e-15 * s);
      }
  }
  EyeBody source = kEye, source8 = kEye;
  source.law = source8.law = BulgeLaw::compat;
  source8.radius *= 8, source8.cornea *= 8, source8.bulge *= 8;
  EXPECT_GT(lid_push(source8, tilted(0.3), kAhead), 20 * lid_push(source, tilted(0.3), kAhead));
}

/// The highest place of a closed lid is over the iris, wherever it goes; a little nearer to the
/// middle, since the push points outwards.
TEST(Bulge, RisesWhereTheIrisIs_C2) {
  for (const glm::dvec2 gaze : {glm::dvec2{0, 0}, {0.08, 0}, {-0.05, 0.04}, {0.02, -0.09}}) {
    const glm::dvec3 g = gaze_axis(gaze, kEye.radius);
    glm::dvec2 highest{0};
    double most = -1;
    for (double x = -0.2; x <= 0.2; x += 0.002)
      for (double y = -0.2; y <= 0.2; y += 0.002)
        if (const double rise = lid_rise(kEye, kEye.center + glm::dvec2{x, y}, g); rise > most)
          most = rise, highest = {x, y};
    EXPECT_LT(glm::length(highest - gaze), 0.05 * kEye.radius) << highest.x << " " << highest.y;
    EXPECT_NEAR(most, kEye.bulge * g.z, 0.02 * kEye.bulge) << gaze.x << " " << gaze.y;
  }
}

/// The hill that relief light falls on is where the push is, and as high.
TEST(Bulge, IsADomeForTheLight_C2) {
  for (const glm::dvec2 gaze : {glm::dvec2{0, 0}, {0.06, 0}, {0.01, -0.06}, {-0.08, 0.04}}) {
    const EyeBody eye{.center = {0.2, 0.1}, .radius = 0.2, .cornea = 0.05, .bulge = 0.03};
    const glm::dvec3 g = gaze_axis(gaze, eye.radius);
    const CorneaDome dome = cornea_dome(eye, g);
    EXPECT_LE(std::abs(dome.tilt), 45);
    const double tilt = dome.tilt * 3.14159265358979323846 / 180;
    const glm::dvec2 along{std::cos(tilt), std::sin(tilt)};
    double worst = 0;
    for (double x = -0.2; x <= 0.2; x += 0.004)
      for (double y = -0.2; y <= 0.2; y += 0.004) {
        const glm::dvec2 p = eye.center + glm::dvec2{x, y}, way = p - dome.center;
        const double across = way.y * along.x - way.x * along.y;
        const double v = 1 - std::pow(glm::dot(way, along) / dome.radii.x, 2) -
                         std::pow(across / dome.radii.y, 2);
        const double height = v > 0 ? dome.height * v * v : 0;
        worst = std::max(worst, std::abs(height - lid_rise(eye, p, g)));
      }
    // An ellipse stands for the push: 0.041 of the bulge was measured straight ahead, 0.064 aside.
    EXPECT_LT(worst, (gaze == glm::dvec2(0) ? 0.05 : 0.08) * eye.bulge)
        << gaze.x << " " << worst / eye.bulge;
  }
}

TEST(Bulge, ALidHasAThickness) {
  EyeBody eye = kEye;
  eye.bulge = 0.08;
  EXPECT_EQ(least_lid_thickness(eye), 0.02);
  eye.bulge = -0.08;
  EXPECT_EQ(least_lid_thickness(eye), 0);
}

/// The lid's sheet clears ball and cornea in every direction, by what the derivation says; with a
/// thinner lid it would not.
TEST(Bulge, TheLidNeverCutsIntoTheEye_C3) {
  for (const double height : {0.005, 0.04, 0.1, 0.2})
    for (const double bulge : {0.001, 0.02, 0.08}) {
      EyeBody eye = kEye;
      eye.cornea = height, eye.bulge = bulge;
      const double most = most_bulge(eye.radius, height);
      double least = 9, thinner = 9;
      for (double theta = 0; theta < 3.14; theta += 0.0005) {
        const glm::dvec3 d = tilted(theta, 1);
        const double surface = eye_surface(eye, d, kAhead),
                     lid = lid_radius(eye) + lid_push(eye, d, kAhead);
        const double v = std::max(0.0, 1 - (1 - std::cos(theta)) * eye.radius / height);
        EXPECT_GE(lid - surface, bulge * (v - 0.5) * (v - 0.5) * (v > 0) - 1e-15) << theta;
        least = std::min(least, lid - surface);
        thinner = std::min(thinner, lid - surface - 0.25 * least_lid_thickness(eye));
      }
      EXPECT_GE(least, 0);
      if (bulge > most || height > 0.02) continue;  // these have room to spare
      EXPECT_LT(thinner, 0) << "a thickness that is not needed";
    }
}

TEST(Bulge, TheEyesSurfaceIsABallWithACapThatMeetsIt_C3) {
  const double alpha = rim(kEye);
  EXPECT_NEAR(eye_surface(kEye, kAhead, kAhead), kEye.radius + kEye.bulge, 1e-15);
  EXPECT_NEAR(eye_surface(kEye, tilted(alpha - 1e-9), kAhead), kEye.radius, 1e-9);
  EXPECT_EQ(eye_surface(kEye, tilted(alpha + 1e-9), kAhead), kEye.radius);
  // All of the cap is one sphere: four of its points determine the centre of a fifth.
  const auto at = [&](double theta) {
    return eye_surface(kEye, tilted(theta), kAhead) * tilted(theta);
  };
  const glm::dvec3 top = at(0), side = at(0.8 * alpha);
  const double k = (glm::dot(top, top) - glm::dot(side, side)) / (2 * (top.z - side.z));
  for (double theta = 0; theta < alpha; theta += 0.05)
    EXPECT_NEAR(glm::length(at(theta) - glm::dvec3(0, 0, k)), top.z - k, 1e-14);
}

/// What stands there is pushed to where it was drawn.
TEST(Bulge, FindsWhereAPushedLidStands_C3) {
  for (const glm::dvec2 gaze : {glm::dvec2{0, 0}, {0.06, 0}, {-0.08, 0.04}}) {
    const glm::dvec3 g = gaze_axis(gaze, kEye.radius);
    int pushed = 0;
    for (double x = -0.25; x <= 0.25; x += 0.013)
      for (double y = -0.25; y <= 0.25; y += 0.013) {
        const glm::dvec2 drawn = kEye.center + glm::dvec2{x, y},
                         standing = standing_place(kEye, drawn, g);
        EXPECT_LT(glm::length(standing + edge_push(kEye, standing, g) - drawn), 1e-15);
        pushed += standing != drawn;
      }
    EXPECT_GT(pushed, 50);
  }
}

TEST(Bulge, IsTotal) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double radius : {0.0, 1e-300, 1e9})
    for (const double cornea : {0.0, 1e-300, 1e9, kInf})
      for (const BulgeLaw law : {BulgeLaw::native, BulgeLaw::compat}) {
        const EyeBody eye{
            .center = {0, 0}, .radius = radius, .cornea = cornea, .bulge = 1, .law = law};
        for (const glm::dvec2 p : {glm::dvec2{0, 0}, {1, 0}, {1e300, -1e300}})
          EXPECT_FALSE(std::isnan(edge_push(eye, p, kAhead).x))
              << radius << " " << cornea << " " << p.x;
      }
}

}  // namespace
}  // namespace mien
