#include "lib/rig/muscle/equilibrium.h"

#include <mien/pose.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "tests/support/faces/face_path.h"
#include "tests/support/faces/faces.h"
#include "tests/support/faces/muscle_reference.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"

namespace mien {
namespace {

const std::string kMale = test::face_path("male");

glm::dvec2 point_of(const Face& face, const std::string& slice) {
  const int found = face.model->layout.find(slice);
  if (found < 0) throw std::runtime_error("no " + slice);
  const auto begin = std::size_t(face.model->layout[found].begin);
  return {face.vector[begin], face.vector[begin + 1]};
}

void expect_like_reference(const std::map<std::string, double>& emotions) {
  const test::MuscleReference reference(kMale);
  const auto pulls = reference.mix(emotions);
  const auto truth = reference.run([&](double) { return pulls; }, 8, 1. / 512);
  std::vector<std::string> settings;
  for (const auto& [emotion, strength] : emotions)
    settings.push_back(fmt::format("emotion.{}={}", emotion, strength));
  const Face posed = test::posed(test::face_named("male"), settings);
  for (const auto& [name, where] : truth) {
    const std::size_t slash = name.find('/');
    const glm::dvec2 left = point_of(posed, name.substr(0, slash) + ".left" + name.substr(slash));
    const glm::dvec2 right = point_of(posed, name.substr(0, slash) + ".right" + name.substr(slash));
    EXPECT_NEAR(left.x, where.real(), 1e-9) << name;
    EXPECT_NEAR(left.y, where.imag(), 1e-9) << name;
    EXPECT_EQ(right.x, -left.x) << name;
    EXPECT_EQ(right.y, left.y) << name;
  }
  EXPECT_EQ(truth.size(), 15u);
}

TEST(MuscleEquilibrium, SixRecipesComeToRestWhereALongSimulationDoes) {  // M5, M8, M10
  for (const char* emotion : {"joy", "sadness", "anger", "disgust", "fear", "surprise"}) {
    SCOPED_TRACE(emotion);
    expect_like_reference({{emotion, 1}});
    if (test::kSanitized) break;
  }
}

TEST(MuscleEquilibrium, MixesDoToo) {  // M6, M8, M10
  expect_like_reference({{"joy", 0.5}, {"surprise", 0.7}});
  expect_like_reference({{"anger", 0.8}, {"disgust", 0.6}, {"sadness", 0.3}});
  test::Random random(5);
  for (int i = 0; i < test::times(6); ++i) {
    std::map<std::string, double> mix;
    for (const char* emotion : {"joy", "sadness", "anger", "disgust", "fear", "surprise"})
      if (random.chance(0.5)) mix[emotion] = random.unit();
    SCOPED_TRACE(i);
    expect_like_reference(mix);
  }
}

/// Explicit trapezoids in steps of 1/8192 s, in Cartesian coordinates with std::hypot.
glm::dvec2 simulated(const MusclePointLaw& law, double seconds) {
  const auto push = [&](double x, double y, double vx, double vy) {
    double ax = law.stiffness * (law.rest.x - x) - law.damping * vx;
    double ay = law.stiffness * (law.rest.y - y) - law.damping * vy;
    for (const MuscleSpring& s : law.springs) {
      const double dx = s.origin.x - x, dy = s.origin.y - y, r = std::hypot(dx, dy);
      ax += s.stiffness * (r - s.free_length) * dx / r;
      ay += s.stiffness * (r - s.free_length) * dy / r;
    }
    return glm::dvec2{ax, ay};
  };
  double x = law.rest.x, y = law.rest.y, vx = 0, vy = 0;
  const double h = 1. / 8192;
  for (int n = 0; n < int(seconds / h); ++n) {
    const glm::dvec2 a = push(x, y, vx, vy);
    const double wx = vx + h * a.x, wy = vy + h * a.y;
    const glm::dvec2 b = push(x + h * vx, y + h * vy, wx, wy);
    x += 0.5 * h * (vx + wx), y += 0.5 * h * (vy + wy);
    vx += 0.5 * h * (a.x + b.x), vy += 0.5 * h * (a.y + b.y);
  }
  return {x, y};
}

/// Random laws, with muscles strong enough to pull points past origins and into other equilibria than
/// the nearest.
TEST(MuscleEquilibrium, IsTheOneThatIsReachedFromRest) {  // M8
  test::Random random(7);
  int followed = 0, elsewhere = 0;
  for (int i = 0; i < 60; ++i) {
    MusclePointLaw law{
        random.point(-20, 20), random.between(5, 30), random.between(5, 9), false, {}};
    const int count = 1 + random.below(4);
    for (int m = 0; m < count; ++m) {
      const glm::dvec2 origin = law.rest + random.between(10, 60) * random.direction();
      const double length = std::hypot(origin.x - law.rest.x, origin.y - law.rest.y);
      law.springs.push_back(
          {origin, random.between(10, 120), length - random.between(0, 80), Side::none});
    }
    const MuscleEquilibrium found = muscle_equilibrium(law);
    bool stuck = false;  // on a tip, which this simulation rings about for ever
    for (const MuscleSpring& spring : law.springs) stuck |= found.p == spring.origin;
    if (stuck) continue;
    const glm::dvec2 truth = simulated(law, 12);
    followed += !found.proven;
    EXPECT_NEAR(found.p.x, truth.x, 1e-9) << i;
    EXPECT_NEAR(found.p.y, truth.y, 1e-9) << i;
    const glm::dvec2 force = muscle_force(law, found.p);
    EXPECT_LT(std::hypot(force.x, force.y), 1e-9);
    elsewhere += std::hypot(found.p.x - law.rest.x, found.p.y - law.rest.y) > 30;
  }
  EXPECT_GT(followed, 5);
  EXPECT_GT(elsewhere, 1);
}

/// Two equal wells: a spring that pushes away from its origin. The point starts beside the ridge and
/// must come down on its own side.
TEST(MuscleEquilibrium, FallsToTheSideItStartsOn) {  // M8
  for (const double side : {-1.0, 1.0}) {
    const MusclePointLaw law{{0, 0.01 * side}, 1, 3, false, {{{0, 0}, 10, 5, Side::none}}};
    const MuscleEquilibrium found = muscle_equilibrium(law);
    EXPECT_NEAR(found.p.x, 0, 1e-12);
    EXPECT_GT(found.p.y * side, 1);
    const glm::dvec2 force = muscle_force(law, found.p);
    EXPECT_LT(std::hypot(force.x, force.y), 1e-9);
  }
}

TEST(MuscleEquilibrium, SticksToATipThatIsStrongEnough) {  // M8
  const auto at_rest = [](double y) {
    return MusclePointLaw{{0, y}, 10, 8, false, {{{0, 0}, 5, -7, Side::none}}};
  };
  EXPECT_EQ(muscle_equilibrium(at_rest(0)).p, (glm::dvec2{0, 0}));
  EXPECT_EQ(muscle_equilibrium(at_rest(3)).p, (glm::dvec2{0, 0}));
  // 10 (4 − y) = 5 (y + 7): y = 1/3
  EXPECT_NEAR(muscle_equilibrium(at_rest(4)).p.y, 1. / 3, 1e-12);
}

TEST(MuscleEquilibrium, OfANumberIsWhereItsSpringsBalance) {
  const MuscleNumberLaw law{30, 8, 15};
  EXPECT_EQ(muscle_equilibrium(law), 0.5);
}

/// Whatever the bounds of a face file allow comes to an end, at a finite place.
TEST(MuscleEquilibrium, IsFiniteForAllThatAFileAllows) {
  test::Random random(11);
  for (int i = 0; i < 200; ++i) {
    MusclePointLaw law{random.size(-6, 9) * random.direction(),
                       random.size(-3, 6),
                       random.size(-2, 4),
                       random.chance(0.3),
                       {}};
    const int count = random.below(7);
    for (int m = 0; m < count; ++m) {
      glm::dvec2 origin = random.chance(0.2) ? law.rest : random.size(-6, 9) * random.direction();
      const double length = std::hypot(origin.x - law.rest.x, origin.y - law.rest.y);
      law.springs.push_back(
          {origin, random.size(-6, 6), length - random.size(-6, 9), Side(random.below(3))});
    }
    const glm::dvec2 p = muscle_equilibrium(law).p;
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << i;
    if (law.on_axis) {
      EXPECT_EQ(p.x, law.rest.x);
    }
  }
}

}  // namespace
}  // namespace mien
