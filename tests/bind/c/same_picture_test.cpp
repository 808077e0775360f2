// What C draws is what C++ draws, byte by byte: both libraries in one program.

#include <gtest/gtest.h>
#include <mien/mien.h>
#include <mien_c.h>

#include <vector>

#include "tests/support/faces/face_path.h"
#include "tests/support/pictures/rendered.h"

namespace mien {
namespace {

struct InC {
  mien_face* face = nullptr;
  mien_pose* pose = nullptr;
  mien_renderer* renderer = nullptr;

  explicit InC(const std::string& path) {
    EXPECT_EQ(mien_face_read(path.data(), path.size(), &face, nullptr), MIEN_OK);
    EXPECT_EQ(mien_pose_new(face, &pose, nullptr), MIEN_OK);
    EXPECT_EQ(mien_renderer_new(&renderer, nullptr), MIEN_OK);
  }
  ~InC() { mien_renderer_free(renderer), mien_pose_free(pose), mien_face_free(face); }

  std::vector<std::byte> draw(const mien_view& view, int32_t depth, std::size_t bytes) {
    std::vector<std::byte> all(bytes);
    mien_pixels pixels;
    mien_pixels_init(&pixels, sizeof pixels);
    int32_t rect[4];
    EXPECT_EQ(mien_drawn_rect(&view, rect, nullptr), MIEN_OK);
    pixels.depth = depth, pixels.data = all.data(), pixels.bytes = bytes;
    pixels.stride = bytes / std::size_t(rect[3]);
    mien_scene* scene = nullptr;
    EXPECT_EQ(mien_scene_new(pose, &scene, nullptr), MIEN_OK);
    EXPECT_EQ(mien_render(renderer, scene, &view, &pixels, nullptr, nullptr), MIEN_OK);
    mien_scene_free(scene);
    return all;
  }
};

TEST(MienC, DrawsTheBytesOfCpp) {
  for (const char* name : {"toon", "bruno", "clay", "seed0"}) {
    const std::string path = test::face_path(name);
    const auto face = read_face(path);
    ASSERT_TRUE(face);
    InC in_c(path);
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
      View view{.width = 200, .height = 150, .fit = Fit::slice, .blend = Blend::srgb};
      view.background = Color{0.1, 0.2, 0.3, 0.4}, view.region = PixelRect{7, 9, 150, 120};
      view.light = glm::dvec3{1, 1, 1}, view.dither = depth == Depth::u16;
      mien_view same;
      mien_view_init(&same, sizeof same);
      same.width = 200, same.height = 150, same.fit = MIEN_FIT_SLICE, same.blend = MIEN_BLEND_SRGB;
      same.has_background = same.has_region = same.has_light = 1;
      for (int i = 0; i < 4; ++i) same.background[i] = 0.1 * (i + 1);
      same.background[2] = 0.3;
      same.region[0] = 7, same.region[1] = 9, same.region[2] = 150, same.region[3] = 120;
      same.light[0] = same.light[1] = same.light[2] = 1, same.dither = depth == Depth::u16;
      const Image wanted =
          test::rendered(scene_from_face(pose_face(*face, {.time = 1.25})), view, {.depth = depth});
      ASSERT_EQ(mien_pose_time(in_c.pose, 1.25, nullptr), MIEN_OK);
      EXPECT_TRUE(in_c.draw(same, int32_t(depth), wanted.bytes.size()) == wanted.bytes) << name;
    }
  }
}

TEST(MienC, DefaultsAreThoseOfCpp) {
  mien_view view;
  mien_view_init(&view, sizeof view);
  const View defaults;
  EXPECT_EQ(view.width, defaults.width);
  EXPECT_EQ(view.height, defaults.height);
  EXPECT_EQ(view.fit, int32_t(defaults.fit));
  EXPECT_EQ(view.blend, int32_t(defaults.blend));
  EXPECT_EQ(view.dither, int32_t(defaults.dither));
  EXPECT_FALSE(view.has_background || view.has_region || view.has_light);
  EXPECT_EQ(mien_version_text(), std::string(MIEN_VERSION_STRING));
}

TEST(MienC, PosesThatAreSetAgainDoNotGrowAndLaterOnesWin) {
  InC in_c(test::face_path("toon"));
  const auto face = read_face(test::face_path("toon"));
  for (int i = 0; i <= 100; ++i)
    for (const char* text : {"gaze.x=0.01", "gaze.left.x=-0.02", "gaze.x=0.03"})
      ASSERT_EQ(mien_pose_set(in_c.pose, text, MIEN_NUL_ENDED, nullptr), MIEN_OK);
  std::vector<double> posed(face->vector.size());
  ASSERT_EQ(mien_pose_vector(in_c.pose, posed.data(), int32_t(posed.size()), nullptr), MIEN_OK);
  const Pose last{.settings = {read_setting(*face, "gaze.left.x=-0.02").value(),
                               read_setting(*face, "gaze.x=0.03").value()}};
  EXPECT_EQ(posed, pose_face(*face, last).vector);
}

}  // namespace
}  // namespace mien
