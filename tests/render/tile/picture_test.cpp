#include <gtest/gtest.h>
#include <mien/render/tile/picture.h>

#include <cstdint>
#include <vector>

namespace mien {
namespace {

constexpr int kSide = 128;

/// Black left of x = 100 px, white right of it, in a picture of 300 × 300.
Tape halves() {
  SceneBuilder build({.box = {{0, 0}, {300, 300}}, .y_up = false}, {1, 1, 1, 1});
  build.layer("left", build.shape(HalfPlane{{1, 0}, 100}), {{0, 0, 0, 1}});
  return tape_from_scene(std::move(build).finish(), {.width = 300, .height = 300});
}

/// What drawing one square leaves in a target that holds `rect`, one byte of red per pixel; 0x55 is
/// untouched.
std::vector<int> drawn(int x, int y, const PixelRect& rect, RenderStats& stats) {
  std::vector<std::uint8_t> bytes(std::size_t(rect.width * rect.height) * 4, 0x55);
  const Target target{reinterpret_cast<std::byte*>(bytes.data()), std::size_t(rect.width) * 4,
                      Depth::u8, rect};
  draw_square(halves(), 300, 300, x, y, kSide, target, stats);
  std::vector<int> red;
  for (std::size_t i = 0; i < bytes.size(); i += 4) red.push_back(bytes[i]);
  return red;
}

TEST(DrawSquare, FillsItsSquareAndNothingElse) {
  RenderStats stats;
  const std::vector<int> red = drawn(0, 0, {0, 0, 300, 300}, stats);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      const bool mine = x < kSide && y < kSide;
      ASSERT_EQ(red[std::size_t(y * 300 + x)], !mine ? 0x55 : x < 100 ? 0 : 255) << x << ' ' << y;
    }
  EXPECT_EQ(stats.fill_pixels + stats.one_edge_pixels + stats.divided_pixels, kSide * kSide);
}

TEST(DrawSquare, StopsAtThePicturesEnd) {
  RenderStats stats;
  const int last = 300 / kSide * kSide;
  drawn(last, last, {0, 0, 300, 300}, stats);
  EXPECT_EQ(stats.fill_pixels, (300 - last) * (300 - last));
}

TEST(DrawSquare, DrawsOnlyWhatTheTargetHolds) {
  RenderStats stats;
  const std::vector<int> red = drawn(0, 0, {98, 10, 4, 2}, stats);
  EXPECT_EQ(red, (std::vector<int>{0, 0, 255, 255, 0, 0, 255, 255}));
}

}  // namespace
}  // namespace mien
