#include "sdf/shape/shape_distances.h"

#include "tests/support/random/random.h"

#include <gtest/gtest.h>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace mien::test {
namespace {

/// A star of so many points, every other one at `inner` of its size.
Path star(int points, double inner = 0.5) {
  Path path{{Path::Loop{}}, FillRule::nonzero};
  const auto at = [&](int i) {
    const double turn = 2.0 * 3.141592653589793 * (i % points) / points;
    return (i % 2 ? inner : 1.0) * glm::dvec2{std::cos(turn), std::sin(turn)};
  };
  for (int i = 0; i < points; ++i)
    path.loops[0].sides.push_back({at(i), 0.5 * (at(i) + at(i + 1)), at(i + 1)});
  return path;
}

}  // namespace

TEST(ShapeDistances, AreThoseOfTheShapes) {
  const std::vector<Shape> shapes{Disc{{0, 0}, 1}, star(10), star(400)};
  ShapeDistances asked(shapes.size());
  Random r(1);
  for (int pass = 0; pass < 2; ++pass, asked.begin(shapes.size()))
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec2 p = r.point(-2, 2);
      for (std::size_t k = 0; k < shapes.size(); ++k)
        EXPECT_NEAR(asked.at(k, shapes[k], p), distance(shapes[k], p), 1e-14);
    }
}

TEST(ShapeDistances, OfAPathOfManySidesAskFewOfThem) {
  const std::vector<Shape> shapes{star(100'000, 0.9999)};
  const ShapeDistances asked(shapes.size());
  const auto seconds_each = [](int times, const auto& ask) {
    Random r(2);
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) ask(r.point(-2, 2));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / times;
  };
  const auto by_tree = [&](glm::dvec2 p) { asked.at(0, shapes[0], p); };
  seconds_each(100, by_tree);  // until it is made
  EXPECT_LT(20.0 * seconds_each(5000, by_tree),
            seconds_each(50, [&](glm::dvec2 p) { (void)distance(shapes[0], p); }));
}

TEST(ShapeDistances, MayBeAskedBySeveralThreads) {
  const std::vector<Shape> shapes{star(2000)};
  const ShapeDistances asked(shapes.size());
  std::vector<std::thread> threads;
  std::vector<double> most(4, 0.0);
  for (std::size_t t = 0; t < most.size(); ++t)
    threads.emplace_back([&, t] {
      Random r(3);
      for (int i = 0; i < 500; ++i) {
        const glm::dvec2 p = r.point(-2, 2);
        most[t] = std::max(most[t], std::abs(asked.at(0, shapes[0], p) - distance(shapes[0], p)));
      }
    });
  for (std::thread& t : threads) t.join();
  for (const double m : most) EXPECT_LE(m, 1e-14);
}

}  // namespace mien::test
