// The renderer that remembers: the same pixels as without a memory, and no allocation per frame.

#include <mien/mien.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/support/faces/faces.h"
#include "tests/support/process/allocations.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

Scene scene_of(const char* face, double blink) {
  const Face read = test::face_named(face);
  return scene_from_face(blink < 0 ? pose_face(read, {})
                                   : test::posed(read, {"blink=" + std::to_string(blink)}));
}

/// Rows without padding.
std::vector<std::byte> frame(Renderer* renderer, const Scene& scene, const View& view,
                             Depth depth) {
  const std::size_t stride = std::size_t(view.width) * 4 * bytes_per_channel(depth);
  std::vector<std::byte> pixels(stride * std::size_t(view.height));
  const PixelBuffer out{pixels.data(), stride, depth};
  const RenderOptions how{.threads = {.count = 1}};
  EXPECT_TRUE(renderer ? renderer->render_into(out, scene, view, how)
                       : render_into(out, scene, view, how));
  return pixels;
}

TEST(Renderer, DrawsWhatRenderIntoDraws) {
  constexpr int kSmaller = test::kSanitized ? 3 : 1;
  Renderer renderer;
  for (const char* face : {"toon", "seed0", "clay", "male", "toon"})
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::u8}) {
      const bool blinks = face == std::string("toon") || face == std::string("seed0");
      const Scene scene = scene_of(face, blinks ? 0.4 : -1);
      for (const Blend blend : {Blend::linear, Blend::srgb}) {
        const int width = (blend == Blend::linear ? 90 : 33) / kSmaller;
        const View view{.width = width, .height = 70 / kSmaller, .blend = blend};
        EXPECT_EQ(frame(&renderer, scene, view, depth), frame(nullptr, scene, view, depth))
            << face << ' ' << width;
      }
    }
}

TEST(Renderer, CanBeMovedAndRefusesWhatIsNoPicture) {
  const Scene scene = scene_of("seed0", 0);
  Renderer first;
  frame(&first, scene, {.width = 40, .height = 20}, Depth::u8);
  Renderer second = std::move(first);
  const View view{.width = 50, .height = 30};
  EXPECT_EQ(frame(&second, scene, view, Depth::u8), frame(nullptr, scene, view, Depth::u8));
  EXPECT_EQ(frame(&first, scene, view, Depth::u8), frame(nullptr, scene, view, Depth::u8))
      << "moved from: as new";
  std::uint32_t pixel = 0;
  EXPECT_FALSE(second.render_into({&pixel, 4, Depth::u8}, scene, {.width = 0, .height = 1}));
}

/// Two poses in turn: after the first frames of each, until rows are kept, too.
TEST(Renderer, AllocatesNothingAfterTheFirstFramesOfAKind) {
  for (const char* face : {"seed0", "male", "toon", "bruno", "clay"})
    for (const Depth depth : {Depth::u8, Depth::u16}) {
      const Face read = test::face_named(face);
      const bool looks = face != std::string("male");
      const Scene scenes[] = {
          scene_from_face(looks ? test::posed(read, {"gaze.x=0.01"}) : pose_face(read, {})),
          scene_from_face(looks ? test::posed(read, {"gaze.x=0.02"}) : pose_face(read, {}))};
      Renderer renderer;
      const View view{.width = 160, .height = 120, .blend = Blend::srgb};
      std::vector<std::uint64_t> pixels(160 * 120);
      const RenderOptions how{.threads = {.count = 1}};
      const auto draw = [&](int i) {
        return bool(
            renderer.render_into({pixels.data(), 160 * 8, depth}, scenes[i % 2], view, how));
      };
      for (int i = 0; i < 4; ++i) EXPECT_TRUE(draw(i));
      const long before = test::allocations();
      for (int i = 0; i < 4; ++i) EXPECT_TRUE(draw(i));
      EXPECT_EQ(test::allocations() - before, 0) << face;
    }
}

/// Frames between others that end at every place where they can: asked whether to go on, or at a limit.
TEST(Renderer, AFrameThatEndedEarlyChangesNoOtherOne) {
  const Face face = test::face_named("toon");
  const View view{.width = 90, .height = 160};
  const auto pose = [&](int i) {
    return scene_from_face(test::posed(face, {"gaze.x=0.0" + std::to_string(i % 5)}));
  };
  Renderer renderer;
  std::vector<std::uint32_t> pixels(90 * 160);
  const PixelBuffer out{pixels.data(), 90 * 4, Depth::u8};
  int ended = 0, recalls = 0;
  for (int i = 0; i < test::times(40); ++i) {
    for (int k = 0; k < 3; ++k) {
      RenderStats stats;
      ASSERT_TRUE(renderer.render_into(out, pose(i + k), view, {.threads = {.count = 1}}, &stats));
      recalls += stats.recalled_pixels > 0;
    }
    int left = i / 4;
    RenderOptions how{.threads = {.count = 1 + i % 2}};
    if (i % 4 == 0) how.limits.steps = 2000 << i / 4;
    if (i % 4 == 1) how.limits.memory = 2000 << i / 4;
    if (i % 4 > 1) how.progress = [&](double) { return left-- > 0; };
    ended += !renderer.render_into(out, pose(i + 3), view, how);
    ended += !renderer.render_into(out, pose(i), {.width = 0, .height = 9}, how);
    const Scene next = pose(i + 3 + i % 2);
    ASSERT_EQ(frame(&renderer, next, view, Depth::u8), frame(nullptr, next, view, Depth::u8)) << i;
  }
  EXPECT_GT(ended, test::times(50)) << "40 of them are no pictures";
  EXPECT_GT(recalls, test::times(30));
}

/// One that a caller's exception ends, too.
TEST(Renderer, AFrameThatThrewChangesNoOtherOne) {
  const Face face = test::face_named("toon");
  const View view{.width = 90, .height = 160};
  const auto pose = [&](int i) {
    return scene_from_face(test::posed(face, {"gaze.x=0.0" + std::to_string(i % 5)}));
  };
  for (int i = 0; i < 6; ++i) {
    Renderer renderer;
    for (int k = 0; k < 3; ++k) frame(&renderer, pose(k), view, Depth::u8);
    std::vector<std::uint32_t> pixels(90 * 160);
    int left = i;
    const RenderOptions how{.threads = {.count = 1}, .progress = [&](double) -> bool {
                              return left-- > 0 ? true : throw std::string("the caller's");
                            }};
    try {
      (void)renderer.render_into({pixels.data(), 90 * 4, Depth::u8}, pose(3), view, how);
    } catch (const std::string&) {
    }
    for (const int next : {3, 4})
      ASSERT_EQ(frame(&renderer, pose(next), view, Depth::u8),
                frame(nullptr, pose(next), view, Depth::u8))
          << i;
  }
}

TEST(Renderer, CopiesRowsThatAreAsTheyWere) {
  const Face face = test::face_named("clay");
  Renderer renderer;
  const View view{.width = 90, .height = 60};
  std::vector<std::uint32_t> pixels(90 * 60);
  const auto recalled = [&](const char* gaze, Depth depth = Depth::u8) {
    RenderStats stats;
    EXPECT_TRUE(renderer.render_into({pixels.data(), 90 * 4, depth},
                                     scene_from_face(test::posed(face, {gaze})), view, {}, &stats));
    EXPECT_EQ(stats.pixels, 90 * 60);
    EXPECT_EQ(stats.recalled_pixels + stats.fill_pixels + stats.edge_pixels + stats.varied_pixels,
              stats.pixels);
    return stats.recalled_pixels;
  };
  EXPECT_EQ(recalled("gaze.x=0"), 0);
  EXPECT_EQ(recalled("gaze.x=0.01"), 0) << "now it is worth keeping";
  const long long eyes = recalled("gaze.x=0.02");
  EXPECT_GT(eyes, 90 * 60 / 2);
  EXPECT_LT(eyes, 90 * 60);
  EXPECT_EQ(recalled("gaze.x=0.02"), 90 * 60) << "nothing changed";
}

}  // namespace
}  // namespace mien
