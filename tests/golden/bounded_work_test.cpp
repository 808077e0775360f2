// Small scenes of large work draw within their limits, end at smaller ones, and can be cancelled anywhere.

#include <mien/debug_picture.h>
#include <mien/error_map.h>
#include <mien/piece_drawer.h>
#include <mien/render.h>
#include <mien/scene_effects.h>
#include <mien/svg.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>

#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"
#include "tests/support/scenes/hostile_scenes.h"

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
  const auto steps = render(scenes[0].scene, kView, {.limits = {.steps = 10'000}}, &stats);
  ASSERT_FALSE(steps);
  EXPECT_EQ(steps.error().what, "drawing takes more than 10000 steps of work (limit `steps`)");
  EXPECT_FALSE(stats.cancelled);
  const auto memory = render(scenes.back().scene, kView, {.limits = {.memory = 1000}});
  ASSERT_FALSE(memory);
  EXPECT_EQ(memory.error().what,
            "outlines and their order need more than 0.977 KiB (limit `memory`)");
}

/// A path that crosses itself a million times or so.
Scene tangle(int points) {
  Random r(4);
  Path path{{Path::Loop{}}, FillRule::even_odd};
  glm::dvec2 at{0, 0};
  for (int i = 0; i < points; ++i) {
    const glm::dvec2 to = i + 1 < points ? r.point(-0.9, 0.9) : glm::dvec2{0, 0};
    path.loops[0].sides.push_back({at, 0.5 * (at + to), to});
    at = to;
  }
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.layer("tangle", build.shape(path), {{0, 0, 0, 1}});
  return std::move(build).finish();
}

TEST(BoundedWork, RefusesWhatCertainlyNeedsTooMuchBeforeItBegins) {
  const Scene scene = tangle(300'000);
  const RenderLimits limits{.memory = 16 << 20};
  std::vector<std::pair<std::string, std::optional<Error>>> errors;
  const auto add = [&](const char* way, const auto& made) {
    errors.emplace_back(way, made ? std::optional<Error>() : made.error());
  };
  RenderStats stats;
  add("render", render(scene, kView, {.limits = limits}, &stats));
  EXPECT_EQ(stats.memory, 0);
  EXPECT_LT(stats.steps, 50'000'000);  // of a nanosecond
  add("pieces", PieceDrawer::of(scene, kView, Depth::u8, limits));
  add("svg", svg_text(scene, {.width = 64, .height = 64, .limits = limits}));
  add("error map", error_map(scene, kView, {.limits = limits}));
  add("debug picture", debug_picture(scene, kView, DebugPicture::outlines, {.limits = limits}));
  for (const auto& [way, error] : errors) {
    ASSERT_TRUE(error) << way;
    EXPECT_EQ(error->what,
              "outlines and their order need at least 18.3 MiB, more than the 16 MiB allowed "
              "(limit `memory`)")
        << way;
  }
}

TEST(BoundedWork, DrawsInAsMuchMemoryAsItHolds) {
  for (const HostileScene& hostile : hostile_scenes(kSmall)) {
    if (!hostile.name.starts_with("lattice") && !hostile.name.starts_with("circle")) continue;
    RenderStats stats;
    ASSERT_TRUE(render(hostile.scene, kView, {}, &stats)) << hostile.name;
    const auto held = std::uint64_t(stats.memory);
    EXPECT_TRUE(render(hostile.scene, kView, {.limits = {.memory = held}})) << hostile.name;
    EXPECT_FALSE(render(hostile.scene, kView, {.limits = {.memory = held - 1}})) << hostile.name;
  }
}

/// A moment on the clock, and of the process's own computing time, of all its threads.
struct Moment {
  std::chrono::steady_clock::time_point on_clock = std::chrono::steady_clock::now();
  std::clock_t computed = std::clock();
};

/// [s] The lesser of both: a busy machine lengthens the one, further threads the other.
double since(const Moment& then) {
  const Moment now;
  return std::min(std::chrono::duration<double>(now.on_clock - then.on_clock).count(),
                  double(now.computed - then.computed) / CLOCKS_PER_SEC);
}

/// What draws a scene in any way: false if it was cancelled.
using Way = std::function<bool(const Scene&, const Progress&)>;
struct NamedWay {
  std::string name;
  Way way;
};

std::vector<NamedWay> ways() {
  static const View kLarge{.width = 256, .height = 256};
  std::vector<NamedWay> all{
      {"render",
       [](const Scene& scene, const Progress& progress) {
         return bool(render(scene, kLarge, {.progress = progress}));
       }},
      {"svg",
       [](const Scene& scene, const Progress& progress) {
         return bool(svg_text(scene, {.width = 256, .height = 256, .progress = progress}));
       }},
      {"error map",
       [](const Scene& scene, const Progress& progress) {
         return bool(error_map(scene, kLarge, {.progress = progress}));
       }},
      {"pieces", [](const Scene& scene, const Progress& progress) {
         return bool(PieceDrawer::of(scene, kLarge, Depth::u8, {}, [&] { return !progress(0); }));
       }}};
  for (const DebugPicture which : {DebugPicture::outlines, DebugPicture::regions,
                                   DebugPicture::fragments, DebugPicture::distance})
    all.push_back({"debug picture " + std::to_string(int(which)),
                   [which](const Scene& scene, const Progress& progress) {
                     return bool(debug_picture(scene, kLarge, which, {.progress = progress}));
                   }});
  return all;
}

/// Of other ways than render those that are not cut to areas, so that it takes less time.
std::vector<HostileScene> scenes_for(const std::string& way) {
  std::vector<HostileScene> scenes = hostile_scenes(1.0);
  if (way != "render")
    std::erase_if(scenes, [](const HostileScene& h) { return h.name.ends_with(", cut"); });
  return scenes;
}

/// [s] that cancelling takes if the question of that number is answered by no, and all others.
double slowest_end(const Way& way, const Scene& scene, int number) {
  Moment said_no;
  int asked = 0;
  const bool drawn = way(scene, [&](double) {
    if (++asked < number) return true;
    if (asked == number) said_no = {};
    return false;
  });
  return drawn ? 0.0 : since(said_no);
}

TEST(BoundedWork, EndsWithinHalfASecond) {
  for (const auto& [name, way] : ways())
    for (const HostileScene& hostile : scenes_for(name))
      for (const int number : {2, 8})
        EXPECT_LT(slowest_end(way, hostile.scene, number), 0.5) << name << ": " << hostile.name;
}

/// [s] between two questions, at most, while it goes on for 0.15 s, and until it ends then.
double longest_pause(const Way& way, const Scene& scene) {
  const Moment began;
  Moment last;
  double longest = 0;
  (void)way(scene, [&](double) {
    longest = std::max(longest, since(last));
    last = {};
    return since(began) < 0.15;
  });
  return std::max(longest, since(last));
}

TEST(BoundedWork, AsksAllTheTime) {
  constexpr double kMost = test::kSanitized ? 1.0 : 0.3;  // [s]
  for (const auto& [name, way] : ways())
    for (const HostileScene& hostile : scenes_for(name))
      EXPECT_LT(longest_pause(way, hostile.scene), kMost) << name << ": " << hostile.name;
}

/// What drawing takes of a nose, with a feather or a relief or both.
std::int64_t steps_of_nose(bool feather, bool relief) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  const Area nose = build.shape(Ellipse{{0, 0}, {0.09, 0.08}});
  Paint paint{.color = {0.8, 0.5, 0.3, 1}};
  if (feather) paint = falling(nose, paint.color, -0.05, 0);
  if (relief)
    paint.relief = std::make_shared<Relief>(Relief{
        .area = nose, .profile = Profile::round, .width = 0.085, .height = 0.06, .specular = 0.25});
  build.layer("nose", nose, paint);
  RenderStats stats;
  EXPECT_TRUE(render(std::move(build).finish(), {.width = 96, .height = 96}, {}, &stats));
  return stats.steps;
}

/// Under light a feather is cut at its stops: both together cost more than the sum of each alone, which is by integrals.
/// The bound is not by that sum, as a slow feather would make room for both.
TEST(BoundedWork, AFeatherWithAReliefIsFarFromWhatPixelByPixelWouldTake) {
  EXPECT_LT(steps_of_nose(true, false), 450'000);
  EXPECT_LT(steps_of_nose(false, true), 450'000);
  EXPECT_LT(steps_of_nose(true, true), 2'000'000);
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
