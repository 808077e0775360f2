// The fourth promise: the same bytes for any threads, tiles and regions. And what follows from
// exactness: no seams, mirror images, no white outside a closing lid.

#include <mien/mien.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstring>

#include "tests/support/faces/faces.h"
#include "tests/support/faces/posing.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random_plain_scene.h"

namespace mien {
namespace {

constexpr const char* kFaces[] = {"seed0", "toon",       "male",        "bruno",
                                  "clay",  "faces/toon", "faces/bruno", "faces/clay"};

Scene posed_scene(const char* name, const std::vector<std::string>& settings = {}) {
  return scene_from_face(test::posed(test::face_named(name), settings));
}

TEST(SamePicture, ForAnyNumberOfThreads) {
  constexpr int kSmaller = test::kSanitized ? 3 : 1;
  for (const char* name : kFaces) {
    const Scene scene = posed_scene(name);
    const View view{.width = 611 / kSmaller, .height = 347 / kSmaller};
    const Image one = test::rendered(scene, view, {.threads = {.count = 1}});
    for (const int threads : {2, 7})
      EXPECT_EQ(test::rendered(scene, view, {.threads = {.count = threads}}).bytes, one.bytes)
          << name;
  }
}

TEST(SamePicture, StitchedFromRegions) {
  constexpr int kSmaller = test::kSanitized ? 7 : 1;  // still of many leaves, cut by the regions
  const int width = 611 / kSmaller, height = 347 / kSmaller;
  const int wide = 203 / kSmaller, high = 97 / kSmaller;
  for (const char* name : kFaces)
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
      const Scene scene = posed_scene(name);
      const Image whole =
          test::rendered(scene, {.width = width, .height = height}, {.depth = depth});
      std::vector<std::byte> stitched(whole.bytes.size());
      const std::size_t pixel = 4 * bytes_per_channel(depth);
      for (int y = 0; y < height; y += high)
        for (int x = 0; x < width; x += wide) {
          const PixelRect part{x, y, std::min(wide, width - x), std::min(high, height - y)};
          EXPECT_TRUE(render_into(
              {stitched.data() + whole.stride() * std::size_t(y) + pixel * std::size_t(x),
               whole.stride(), depth},
              scene, {.width = width, .height = height, .region = part}));
        }
      EXPECT_EQ(stitched, whole.bytes) << name;
    }
}

// Which leaves are asked about together depends on what a region shows: no bit may follow it.
TEST(SamePicture, OfRandomScenesInAnyRegion) {
  constexpr int kWidth = 310, kHeight = 150;
  for (int seed = 1; seed <= test::times(60); ++seed) {
    const Scene scene = test::random_plain_scene(std::uint64_t(seed));
    const Image whole = test::rendered(scene, {.width = kWidth, .height = kHeight});
    for (const PixelRect part : {PixelRect{0, 0, 70, 150}, PixelRect{71, 3, 130, 61},
                                 PixelRect{130, 66, 180, 84}, PixelRect{255, 0, 1, 150}}) {
      View view{.width = kWidth, .height = kHeight};
      view.region = part;
      const Image piece = test::rendered(scene, view);
      for (int y = 0; y < part.height; ++y)
        ASSERT_EQ(std::memcmp(piece.row(y), whole.row(y + part.y) + 4 * part.x,
                              4 * std::size_t(part.width)),
                  0)
            << seed << " row " << y + part.y << ", from " << part.x << ' ' << part.y;
    }
  }
}

TEST(Seams, NoneBetweenAbuttingLayersOfOneColour) {
  for (const Blend blend : {Blend::linear, Blend::srgb}) {
    SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
    const glm::dvec2 n{std::cos(0.3), std::sin(0.3)};
    const Area side = build.shape(HalfPlane{n, 0.037}),
               bowl = build.shape(ParabolaSide{{0, -0.4}, {0, 1}, 1.3});
    for (const Area a : {side, build.complement(side)})
      for (const Area b : {bowl, build.complement(bowl)})
        build.layer("piece", build.intersect(a, b), {{0.2, 0.1, 0.4, 1}});
    const Image image =
        test::rendered(std::move(build).finish(), {.width = 157, .height = 101, .blend = blend});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        ASSERT_EQ(std::memcmp(image.row(y) + 4 * x, image.row(0), 4), 0) << x << ' ' << y;
  }
}

/// With the lamp in the middle, and no dither. In 16 bits, where no tie hides a difference: outlines are
/// fitted from one side, and vertices lie on a grid of 1e-6 px.
TEST(Mirror, TheNativeFaceEqualsItsOwnMirrorImage) {  // E2
  constexpr glm::dvec3 kAbove{0, 0.65, 0.85};
  for (const int width : {320, 640, 992}) {
    const int height = width * 9 / 16;
    std::vector<std::uint16_t> pixels(std::size_t(4 * width * height));
    EXPECT_TRUE(Renderer().render_into(
        {reinterpret_cast<std::byte*>(pixels.data()), std::size_t(8 * width), Depth::u16},
        posed_scene("toon"), {.width = width, .height = height, .light = kAbove, .dither = false}));
    const auto channel = [&](int x, int y, int c) {
      return int(pixels[std::size_t(4 * (y * width + x) + c)]);
    };
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width / 2; ++x)
        for (int c = 0; c < 4; ++c)
          ASSERT_LE(std::abs(channel(x, y, c) - channel(width - 1 - x, y, c)), 2)
              << width << ": " << x << ' ' << y;
  }
  const Image odd = test::rendered(posed_scene("toon", {"blink=0.4"}),
                                   {.width = 333, .height = 200, .light = kAbove, .dither = false});
  for (int y = 0; y < odd.height; ++y)
    for (int x = 0; x < 333 * 4; ++x) {
      const int mirrored = (332 - x / 4) * 4 + x % 4;
      ASSERT_LE(std::abs(int(odd.row(y)[x]) - int(odd.row(y)[mirrored])), 1);
    }
}

/// The head turned left is the mirror image of the head turned right, one with a skull too, which nods and leans.
TEST(Mirror, TurnedHeadsMirrorEachOther_G4) {
  constexpr glm::dvec3 kAbove{0, 0.65, 0.85};
  const View view{.width = 320, .height = 180, .light = kAbove, .dither = false};
  std::string whole = test::text_of_face("toon");
  whole.insert(
      whole.find("\"still\":"),
      R"("skull": 0.69, "body": {"share": 0.2, "radii": [0.95, 0.3], "features": ["neck", "sweater"]}, )");
  for (const std::string& text : {test::text_of_face("toon"), whole}) {
    const Face face = read_face_text(text).value();
    const auto turned = [&](const char* yaw, const char* roll) {
      return test::rendered(
          scene_from_face(test::posed(face, {yaw, roll, "pitch=-12", "blink=0.3"})), view);
    };
    const Image left = turned("yaw=20", "roll=5"), right = turned("yaw=-20", "roll=-5");
    EXPECT_NE(left.bytes, turned("yaw=0", "roll=5").bytes);
    for (int y = 0; y < left.height; ++y)
      for (int x = 0; x < left.width; ++x)
        for (int c = 0; c < 4; ++c)
          ASSERT_LE(std::abs(int(left.row(y)[4 * x + c]) - int(right.row(y)[4 * (319 - x) + c])), 1)
              << x << ' ' << y;
  }
}

}  // namespace
}  // namespace mien
