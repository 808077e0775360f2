#include "sdf/shape/shape_outlines.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "lib/base/watch.h"
#include "tests/support/scenes/overlapping_paths.h"

namespace mien::test {

TEST(ShapeOutlines, AreTheShapesButForPathsThatOverlap) {
  Path even_odd{{pentagram(1)}, FillRule::even_odd};
  const std::vector<Shape> shapes{Disc{{0, 0}, 1}, Path{{kSquare}}, Path{{pentagram(1)}}, even_odd,
                                  Path{}};
  const ShapeOutlines outlines(shapes.size());
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t i = 0; i < shapes.size(); ++i)
      EXPECT_EQ(&outlines.of(i, shapes[i]) == &shapes[i], i != 2) << i;
  const Shape& outline = outlines.of(2, shapes[2]);
  EXPECT_EQ(std::get<Path>(outline).loops[0].sides.size(), 10u);
  EXPECT_EQ(&outlines.of(2, shapes[2]), &outline) << "found once";
}

TEST(ShapeOutlines, MayBeAskedBySeveralThreads) {
  std::vector<Shape> shapes;
  for (int i = 0; i < 50; ++i) shapes.push_back(Path{{pentagram(1 + i)}});
  const ShapeOutlines outlines(shapes.size());
  std::vector<std::vector<const Shape*>> seen(4);
  std::vector<std::thread> threads;
  for (auto& of : seen)
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < shapes.size(); ++i) of.push_back(&outlines.of(i, shapes[i]));
    });
  for (std::thread& t : threads) t.join();
  for (const auto& of : seen) EXPECT_EQ(of, seen[0]);
}

TEST(ShapeOutlines, AreFoundLaterIfTheWorkWasEnded) {
  const Shape shape = Path{{pentagram(1)}};
  const ShapeOutlines outlines(1);
  {
    Watch watch({}, {.memory = 1});
    const Watching here(&watch);
    EXPECT_THROW((void)outlines.of(0, shape), Stopped);
  }
  EXPECT_NE(&outlines.of(0, shape), &shape);
}

}  // namespace mien::test
