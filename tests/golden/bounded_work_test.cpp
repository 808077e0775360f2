// Small scenes of large work draw within their limits, end at smaller ones, and can be cancelled anywhere.

#include <mien/piece_drawer.h>
#include <mien/render.h>

#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/hostile_scenes.h"

namespace mien::test {
namespace {

// Of what the documents promise, so that it takes seconds.
constexpr double kSmall = 0.10;

const View kView{.width = 64, .height = 64};

TEST(BoundedWork, DrawsWhatIsPromised) {
  int count = 0;
  for (const HostileScene& hostile : hostile_scenes(kSmall)) {
    const Depth depth = ++count % 3 ? Depth::u8 : Depth::u16;
    RenderStats stats;
    const auto image =
        render(hostile.scene, kView,
               {.depth = depth, .limits = {.steps = 4'000'000'000, .memory = 128u << 20}}, &stats);
    EXPECT_TRUE(image) << hostile.name << ": " << sentence(image.error());
    EXPECT_GT(stats.steps, 0) << hostile.name;
  }
}

TEST(BoundedWork, SaysWhichLimitIsExceeded) {
  const auto scenes = hostile_scenes(kSmall);
  RenderStats stats;
  const auto steps = render(scenes[0].scene, kView, {.limits = {.steps = 100'000}}, &stats);
  ASSERT_FALSE(steps);
  EXPECT_EQ(steps.error().what, "drawing takes more than 100000 steps of work (limit `steps`)");
  EXPECT_FALSE(stats.cancelled);
  const auto memory = render(scenes[0].scene, kView, {.limits = {.memory = 1000}});
  ASSERT_FALSE(memory);
  EXPECT_EQ(memory.error().what, "outlines and their order need more than 0 MiB (limit `memory`)");
}

/// [s] that cancelling takes, at worst, if every question but the first is answered by no.
double slowest_end(const Scene& scene) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point said_no{};
  int asked = 0;
  const auto image = render(scene, {.width = 256, .height = 256}, {.progress = [&](double) {
                              if (++asked < 2) return true;
                              said_no = Clock::now();
                              return false;
                            }});
  return image ? 0.0 : std::chrono::duration<double>(Clock::now() - said_no).count();
}

TEST(BoundedWork, EndsWithinHalfASecond) {
  for (const HostileScene& hostile : hostile_scenes(1.0))
    EXPECT_LT(slowest_end(hostile.scene), 0.5) << hostile.name;
}

TEST(BoundedWork, AsksWithinATenthOfASecond) {
  for (const HostileScene& hostile : hostile_scenes(1.0)) {
    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    auto last = began;
    double longest = 0;
    (void)render(hostile.scene, kView,
                 {.threads = {.count = 1}, .progress = [&](double) {
                    const auto now = Clock::now();
                    longest = std::max(longest, std::chrono::duration<double>(now - last).count());
                    last = now;
                    return now - began < std::chrono::milliseconds(300);
                  }});
    EXPECT_LT(longest, 0.3) << hostile.name;
  }
}

TEST(BoundedWork, OfPiecesEndsToo) {
  for (const HostileScene& hostile : hostile_scenes(kSmall)) {
    const auto none = PieceDrawer::of(hostile.scene, kView, Depth::u8, {}, [] { return true; });
    if (none) continue;  // it was made before anybody was asked
    EXPECT_EQ(none.error().what, "cancelled") << hostile.name;
  }
  const auto drawer =
      PieceDrawer::of(hostile_scenes(kSmall)[0].scene, kView, Depth::u8, {.steps = 1000});
  ASSERT_FALSE(drawer);
  EXPECT_NE(drawer.error().what.find("limit `steps`"), std::string::npos);
}

}  // namespace
}  // namespace mien::test
