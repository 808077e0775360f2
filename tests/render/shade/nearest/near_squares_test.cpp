// Squares within squares: what is farther all over one is not asked there, and nothing that is seen changes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/shade/nearest/near_squares_test.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/nearest/near_squares-inl.h"

#ifndef MIEN_TESTS_NEAR_SQUARES_
#define MIEN_TESTS_NEAR_SQUARES_
namespace mien::test {
struct SeenSquare {
  float x, y, r;
};
}  // namespace mien::test
#endif

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

/// Enters one square after the other, each from the one before; places are the last one's. Nodes are as other areas left
/// them, since tiles use their memory again.
void SeeInSquares(NearArea& area, const std::vector<test::SeenSquare>& squares, const float* x,
                  const float* y, std::vector<NearNode>& last, BranchPair& to) {
  FindFeetOf(area);
  std::vector<NearNode> before;
  NearNode used;
  used.asks = NearNode::Asks::first, used.side = -1;
  for (const test::SeenSquare& s : squares) {
    last.assign(area.nodes().size(), used);
    EnterSquare(area, before.empty() ? nullptr : before.data(), s.x, s.y, s.r, last.data());
    before = last;
  }
  LookAround(area, last.data(), squares.back().x, squares.back().y, x, y, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/random/random.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::batch {
HWY_EXPORT(SeeInSquares);
namespace {

constexpr glm::dvec2 kTileMiddle{24.0, 24.0};

Area random_shape(SceneBuilder& scene, test::Random& random) {
  const glm::dvec2 at = random.point(12.0, 36.0), way = random.direction();
  const double size = random.between(0.5, 6.0);
  switch (random.below(4)) {
    case 0:
      return scene.shape(Disc{at, size});
    case 1:
      return scene.shape(Ellipse{at, {size, size * random.between(0.3, 1.0)}, way});
    case 2:
      return scene.shape(TaperedStroke{
          {at - size * way, at + size * random.direction(), at + size * way}, {0.3, 1.0, 0.2}});
    default:
      return scene.shape(Triangle{at, at + size * way, at + size * random.direction()});
  }
}

/// A tree of a dozen shapes, with every operator.
AreaDistance random_tree(test::Random& random) {
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  Area area = random_shape(scene, random);
  for (int i = 0; i < 12; ++i) {
    const Area other = random_shape(scene, random);
    switch (random.below(9)) {
      case 0:
        area = scene.subtract(area, other);
        break;
      case 1:
        area = scene.unite(scene.shell(area, random.between(0.3, 1.5)), other);
        break;
      case 2:
        area = scene.unite(scene.offset(other, random.between(-0.3, 4.0)), area);
        break;
      case 3:
        area = scene.intersect(area, scene.complement(other));
        break;
      default:
        area = scene.unite(area, other);
    }
  }
  return AreaDistance(std::move(scene).finish(), area, {});
}

struct InSquares {
  std::array<float, 16> x{}, y{};
  std::vector<NearNode> nodes;
  BranchPair seen{};

  void look(NearArea& area, const std::vector<test::SeenSquare>& squares) {
    HWY_DYNAMIC_DISPATCH(SeeInSquares)(area, squares, x.data(), y.data(), nodes, seen);
  }
  int left_out() const {
    int count = 0;
    for (const NearNode& node : nodes) count += node.asks == NearNode::Asks::nothing;
    return count;
  }
};

TEST(NearSquares, SeeTheSameWithoutWhatIsFartherAllOverThem) {
  test::on_every_set([] {
    test::Random random(71);
    int looked = 0, ridges = 0, left_out = 0, nodes = 0;
    for (int k = 0; k < 600; ++k) {
      const AreaDistance distance = random_tree(random);
      const FeetArea feet(distance, {0, 0});
      NearArea area;
      area.narrow(feet, kTileMiddle, 12.0);
      if (area.crowded()) continue;
      const auto square = [&](const test::SeenSquare& in, float half) {
        const float room = in.r / 1.4143f - half;
        return test::SeenSquare{in.x + float(random.between(-room, room)),
                                in.y + float(random.between(-room, room)), 1.4143f * half};
      };
      const test::SeenSquare tile{0.0f, 0.0f, 11.4f}, block = square(tile, 2.0f),
                                                      pixel = square(block, 0.5f);
      InSquares one, other;
      for (std::size_t i = 0; i < 16; ++i) {
        other.x[i] = one.x[i] = pixel.x + float(random.between(-0.5, 0.5));
        other.y[i] = one.y[i] = pixel.y + float(random.between(-0.5, 0.5));
      }
      one.look(area, {tile, block, pixel});
      other.look(area, {tile});
      left_out += one.left_out(), nodes += int(one.nodes.size());
      for (std::size_t i = 0; i < 16; ++i) {
        const glm::dvec2 p = kTileMiddle + glm::dvec2{one.x[i], one.y[i]};
        ++looked;
        ASSERT_NEAR(one.seen.best.d[i], distance.at(p), 2e-3) << k << " " << p.x << " " << p.y;
        // A ridge in the square is seen as from the whole tile.
        const glm::vec2 to{one.x[i] + other.seen.off[i] * other.seen.ex[i] - pixel.x,
                           one.y[i] + other.seen.off[i] * other.seen.ey[i] - pixel.y};
        if (std::max(std::abs(to.x), std::abs(to.y)) > 0.5f) continue;
        // Two stretches of one curve are no ridge.
        const float turn = std::hypot(other.seen.best.nx[i] - other.seen.beyond.nx[i],
                                      other.seen.best.ny[i] - other.seen.beyond.ny[i]);
        if (turn < 0.1f) continue;
        ++ridges;
        ASSERT_NEAR(one.seen.off[i], other.seen.off[i], 0.02) << k;
      }
    }
    EXPECT_GT(looked, 3000);
    EXPECT_GT(ridges, 200);
    EXPECT_GT(left_out, nodes / 4);
  });
}

/// A shape alone decides, whatever another area's node asked before; it used to ask itself without an end.
TEST(NearSquares, AShapeAloneDecides) {
  test::on_every_set([] {
    SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
    const Area disc = scene.shape(Disc{{24.0, 24.0}, 5.0});
    const AreaDistance distance(std::move(scene).finish(), disc, {});
    const FeetArea feet(distance, {0, 0});
    NearArea near;
    near.narrow(feet, kTileMiddle, 12.0);
    InSquares at;
    at.look(near, {{0.0f, 0.0f, 11.4f}, {2.0f, 2.0f, 2.83f}});
    ASSERT_EQ(at.nodes.size(), 1u);
    EXPECT_EQ(at.nodes[0].asks, NearNode::Asks::both);
    at.nodes[0].asks = NearNode::Asks::first;
    EXPECT_EQ(near.deciding(at.nodes.data()), 0u);
  });
}

/// Discs and lines in rows: a square sees a few of them, and those are the nearest ones.
TEST(NearSquares, AskOfAUnionOfManyOnlyThoseThatAreNear) {
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  const auto one = [&](int i) {
    const glm::dvec2 at{13.0 + 3 * (i % 8), 13.0 + 3 * (i / 8)};
    const double size = 0.5 + 0.1 * (i % 7);
    return i % 2 ? scene.shape(Disc{at, size})
                 : scene.shape(Line{at - glm::dvec2{0, 1}, at + glm::dvec2{0, 1}, 0.3 * size});
  };
  Area area = one(0);
  for (int i = 1; i < 64; ++i) area = scene.unite(area, one(i));
  const AreaDistance distance(std::move(scene).finish(), area, {});
  const FeetArea feet(distance, {0, 0});
  NearArea near;
  near.narrow(feet, kTileMiddle, 12.0);
  test::Random random(72);
  int leaves = 0, squares = 0;
  for (int k = 0; k < 256; ++k) {
    const float px = float(k % 16) - 7.5f, py = float(k / 16) - 7.5f;
    const auto block = [](float v) { return 4.0f * std::floor(v / 4.0f) + 2.0f; };
    InSquares at;
    for (std::size_t i = 0; i < 16; ++i) {
      at.x[i] = px + float(random.between(-0.5, 0.5));
      at.y[i] = py + float(random.between(-0.5, 0.5));
    }
    at.look(near, {{0.0f, 0.0f, 11.4f}, {block(px), block(py), 2.83f}, {px, py, 0.71f}});
    for (std::size_t i = 0; i < 16; ++i)
      ASSERT_NEAR(at.seen.best.d[i], distance.at(kTileMiddle + glm::dvec2{at.x[i], at.y[i]}), 2e-3)
          << px << " " << py;
    ++squares;
    for (std::size_t n = 0; n < at.nodes.size(); ++n)
      leaves += near.nodes()[n].op == Op::shape && at.nodes[n].asks != NearNode::Asks::nothing;
  }
  EXPECT_LT(leaves, 6 * squares) << "of " << near.leaves().size();
}

}  // namespace
}  // namespace mien::batch
#endif
