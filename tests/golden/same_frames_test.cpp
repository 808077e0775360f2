// A renderer that remembers the frame before draws what one without a memory draws, to the byte:
// whatever changed, whatever is asked for.

#include <mien/mien.h>

#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/faces/faces.h"
#include "tests/support/process/asked.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/changed_scene.h"
#include "tests/support/random/degenerate_scene.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_lit_scene.h"
#include "tests/support/random/random_scene.h"

namespace mien {
namespace {

constexpr std::byte kUnwritten{0xA5};

/// A buffer of the caller's, its rows farther apart than they need to be.
struct Buffer {
  std::vector<std::byte> bytes;
  std::size_t stride = 0;

  PixelBuffer of(const PixelRect& rect, Depth depth, std::size_t spare) {
    stride = std::size_t(rect.width) * 4 * bytes_per_channel(depth) + spare;
    bytes.assign(stride * std::size_t(rect.height), kUnwritten);
    return {bytes.data(), stride, depth};
  }
};

/// What frames of one renderer are asked for: mostly as before, now and then something else.
class Wishes {
 public:
  /// Pictures so many times as tall: bands of rows are what is drawn again, so few bands are mostly all.
  explicit Wishes(test::Random& random, int taller = 1) : taller_(taller), random_(random) {
    begin();
  }

  void move_on() {
    if (random_.chance(0.05)) begin();
    if (random_.chance(0.1)) depth = Depth(random_.below(3));
    if (random_.chance(0.05)) view.dither = !view.dither;
    if (random_.chance(0.05)) view.blend = random_.chance(0.5) ? Blend::srgb : Blend::linear;
    if (random_.chance(0.04)) view.background = Color{random_.unit(), 0.5, 0.5, random_.unit()};
    if (random_.chance(0.04)) view.light = glm::dvec3{random_.between(-1, 1), 0.6, 0.8};
    if (random_.chance(0.1)) view.region.reset();
    if (random_.chance(0.2))
      view.region =
          PixelRect{random_.chance(0.7) ? 0 : random_.below(view.width), random_.below(view.height),
                    view.width, 1 + random_.below(60 * taller_)};
  }

  View view;
  Depth depth = Depth::u8;

 private:
  void begin() {
    constexpr int kNarrower = test::kSanitized ? 2 : 1;
    view.width = (60 + 7 * random_.below(6)) / kNarrower;
    view.height = taller_ * (50 + 5 * random_.below(6));
  }
  const int taller_;
  test::Random& random_;
};

/// Frames of one renderer beside those of fresh ones; how many of its pixels were not drawn.
class Judge {
 public:
  long long recalled() const { return recalled_; }
  long long pixels() const { return pixels_; }

  testing::AssertionResult frame(const Scene& scene, const Wishes& wish, int threads) {
    const PixelRect rect = drawn_rect(wish.view);
    ++frames_;
    const PixelBuffer out = buffers_[frames_ % 2].of(rect, wish.depth, 16 * (frames_ % 3));
    const PixelBuffer fresh = fresh_.of(rect, wish.depth, 16 * (frames_ % 3));
    const RenderOptions how{.threads = {.count = threads}};
    RenderStats stats;
    EXPECT_TRUE(renderer_.render_into(out, scene, wish.view, how, &stats));
    EXPECT_TRUE(Renderer().render_into(fresh, scene, wish.view, {.threads = {.count = 1}}));
    recalled_ += stats.recalled_pixels, pixels_ += stats.pixels;
    const Buffer& drawn = buffers_[frames_ % 2];
    for (int y = 0; y < rect.height; ++y)
      if (std::memcmp(&drawn.bytes[drawn.stride * std::size_t(y)],
                      &fresh_.bytes[drawn.stride * std::size_t(y)], drawn.stride) != 0)
        return testing::AssertionFailure() << "frame " << frames_ << ", row " << rect.y + y;
    return testing::AssertionSuccess();
  }

 private:
  Renderer renderer_;
  Buffer buffers_[2], fresh_;
  std::size_t frames_ = 0;
  long long recalled_ = 0, pixels_ = 0;
};

/// A pose near the one before, or somewhere else.
class Posing {
 public:
  Posing(const Face& face, test::Random& random) : face_(face), random_(random) {
    for (const char* name : {"gaze.x", "gaze.y", "blink", "yaw", "emotion.joy"})
      if (const auto found = read_setting(face, std::string(name) + "=0"))
        settings_.push_back(*found);
  }

  Scene scene() {
    if (!settings_.empty() && random_.chance(0.8)) {
      const int which = random_.chance(0.7) ? 0 : random_.below(int(settings_.size()));
      constexpr double kReach[] = {0.05, 0.03, 0.8, 10, 1};
      settings_[std::size_t(which)].values[0] = kReach[std::min(which, 4)] * random_.between(0, 1);
    }
    Face face = face_;
    if (random_.chance(0.1))  // anything of it, a little
      face.vector[std::size_t(random_.below(int(face.vector.size())))] *= 1 + 1e-4;
    Pose pose;
    pose.settings = settings_;
    return scene_from_face(pose_face(face, pose));
  }

 private:
  const Face& face_;
  test::Random& random_;
  std::vector<Setting> settings_;
};

/// 250 of them, or as many as MIEN_SEQUENCES says: the long form draws a thousand.
TEST(SameFrames, OfManySequencesOfPoses) {
  constexpr const char* kFaces[] = {"seed0", "toon", "male", "bruno", "toon",
                                    "seed0", "toon", "male", "bruno", "clay"};
  std::vector<Face> faces;
  for (const char* name : kFaces) faces.push_back(test::face_named(name));
  long long recalled = 0, pixels = 0;
  for (int seed = 1; seed <= test::times(test::asked_of("MIEN_SEQUENCES", 250)); ++seed) {
    test::Random random{std::uint64_t(seed)};
    const std::size_t which = std::size_t(seed) % std::size(kFaces);
    Posing posing(faces[which], random);
    Wishes wishes(random);
    Judge judge;
    for (int i = 0; i < 6; ++i, wishes.move_on())
      ASSERT_TRUE(judge.frame(posing.scene(), wishes, 1 + random.below(2)))
          << kFaces[which] << ", seed " << seed;
    recalled += judge.recalled(), pixels += judge.pixels();
  }
  EXPECT_GT(recalled, pixels / 10) << "a memory that is never used proves nothing";
}

/// Painted and lit ones, and ones whose outlines' order is in doubt here and there.
Scene any_scene(int seed) {
  if (seed % 10 == 0) return test::random_lit_scene(std::uint64_t(seed));
  if (seed % 3 == 0) return test::degenerate_scene(std::uint64_t(seed), seed % 2 ? 1e-3 : 1e-6);
  return test::random_painted_scene(std::uint64_t(seed));
}

TEST(SameFrames, OfScenesInWhichOneThingChanges) {
  long long recalled = 0, pixels = 0;
  for (int seed = 1; seed <= test::times(test::asked_of("MIEN_SEQUENCES", 250) / 25); ++seed) {
    test::Random random{std::uint64_t(seed)};
    Scene scene = any_scene(seed);
    Wishes wishes(random, 4);
    Judge judge;
    for (int i = 0; i < 24; ++i) {
      ASSERT_TRUE(judge.frame(scene, wishes, 1)) << "seed " << seed;
      scene = test::changed_scene(scene, random);
      if (i % 4 == 3) wishes.move_on();
    }
    recalled += judge.recalled(), pixels += judge.pixels();
  }
  EXPECT_GT(recalled, pixels / 10);
}

}  // namespace
}  // namespace mien
