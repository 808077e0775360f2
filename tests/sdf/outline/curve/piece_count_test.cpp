#include "sdf/outline/curve/piece_count.h"

#include <gtest/gtest.h>

#include "tests/support/random/random.h"

namespace mien::test {
namespace {

const OutlineFrame kCountedFrame{{}, {{0, 0}, {64, 64}}, 1.0 / 800};

/// Of straight and bent sides, partly outside of the window.
Path counted_path(std::span<const glm::dvec2> at, Random& r) {
  Path path{{Path::Loop{}}};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const glm::dvec2 a = at[i], b = at[(i + 1) % at.size()];
    path.loops[0].sides.push_back({a, r.below(4) ? 0.5 * (a + b) : a + r.point(-3, 3), b});
  }
  return path;
}

std::size_t pieces_made(const Path& path) {
  Outlines outlines;
  OutlineMaker maker;
  maker.begin(kCountedFrame, outlines);
  maker.fill(path);
  return outlines.pieces.size();
}

TEST(PieceCount, KnowsEveryPieceOfAPathThatDoesNotRunBack) {
  Random r(2);
  for (const int points : {3, 100, 5000}) {
    std::vector<glm::dvec2> at;
    for (int i = 0; i < points; ++i) at.push_back(r.point(-10, 74));
    const Path path = counted_path(at, r);
    PieceCount count(kCountedFrame);
    count.add(path);
    EXPECT_EQ(count.pieces(), pieces_made(path)) << points;
  }
}

// To and fro on a line is a line, and there and back the same way encloses nothing.
TEST(PieceCount, IsNeverMoreThanThereIs) {
  Random r(3);
  for (const int points : {40, 5000}) {
    std::vector<glm::dvec2> line, back;
    for (int i = 0; i < points; ++i)
      line.emplace_back(r.between(5, 60), 20), back.push_back(r.point(5, 60));
    for (int i = points; i-- > 0;) back.push_back(back[std::size_t(i)]);
    for (const auto& at : {line, back}) {
      Path path{{Path::Loop{}}};
      for (std::size_t i = 0; i < at.size(); ++i) {
        const glm::dvec2 a = at[i], b = at[(i + 1) % at.size()];
        path.loops[0].sides.push_back({a, 0.5 * (a + b), b});
      }
      PieceCount count(kCountedFrame);
      count.add(path);
      EXPECT_LE(count.pieces(), pieces_made(path)) << points;
    }
  }
}

}  // namespace
}  // namespace mien::test
