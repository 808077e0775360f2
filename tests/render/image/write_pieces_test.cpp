// Pictures drawn on the way to their files: the same bytes as those of whole images.

#include "render/image/write_pieces.h"
#include <mien/render.h>

#include <gtest/gtest.h>

#include "tests/support/pictures/rendered.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::read_text;
using test::ScratchFolder;

constexpr const char* kNames[] = {"a.png", "a.tif", "a.exr", "a.jpg"};

/// Outlines, corners and a ribbon, over more than one piece and strip.
Scene sample_scene() {
  SceneBuilder build({{{0, 0}, {100, 100}}, true}, {0.8, 0.6, 0.3, 1});
  build.layer("disc", build.shape(Disc{{40, 45}, 30}), {{0.1, 0.2, 0.7, 1}});
  build.layer("hair", build.shape(QuadStroke{{{5, 95}, {60, 10}, {95, 90}}, 0.4}), {{0, 0, 0, 1}});
  build.layer("glass", build.shape(Triangle{{10, 5}, {90, 20}, {50, 80}}), {{1, 0, 0, 0.5}});
  return std::move(build).finish();
}

Depth depth_of(const char* name) {
  return std::string(name) == "a.exr" ? Depth::f32 : Depth::u8;
}

std::string whole(const View& view, const char* name, Depth depth) {
  const ScratchFolder folder;
  const auto done =
      write_image(test::rendered(sample_scene(), view, {.depth = depth}), folder / name);
  EXPECT_TRUE(done) << sentence(done.error());
  return read_text(folder / name);
}

std::string streamed(const View& view, const char* name, PictureOptions how) {
  const ScratchFolder folder;
  const auto done = write_picture(sample_scene(), view, folder / name, how);
  EXPECT_TRUE(done) << sentence(done.error());
  EXPECT_EQ(folder.names(), std::vector<std::string>{name});
  return done ? read_text(folder / name) : "";
}

TEST(WritePicture, IsTheWholeImagesFileForAnyThreadsAndMemory) {
  const View view{.width = 700, .height = 520};
  for (const char* name : kNames) {
    const std::string wanted = whole(view, name, depth_of(name));
    for (int threads : {1, 2, 7}) {
      PictureOptions how;
      how.write.threads.count = threads;
      EXPECT_TRUE(streamed(view, name, how) == wanted) << name << " " << threads;
      how.memory = std::string(name) == "a.png" ? 6 << 20 : 3 << 20;
      EXPECT_TRUE(streamed(view, name, how) == wanted) << name << " " << threads << " in little";
    }
  }
}

TEST(WritePicture, ARegionIsTheRegionsFile) {
  const View view{.width = 900, .height = 700, .region = PixelRect{133, 77, 401, 303}};
  for (const char* name : kNames)
    EXPECT_TRUE(streamed(view, name, {}) == whole(view, name, depth_of(name))) << name;
}

TEST(WritePicture, EveryDepthAndTransparency) {
  const View view{.width = 300, .height = 260, .background = Color{0, 0, 0, 0}};
  for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32}) {
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
      PictureOptions how;
      how.depth = depth;
      EXPECT_TRUE(streamed(view, name, how) == whole(view, name, depth))
          << name << " " << int(depth);
    }
  }
}

TEST(WritePicture, SaysWhatItTook) {
  const ScratchFolder folder;
  const auto took = write_picture(sample_scene(), {.width = 300, .height = 200}, folder / "a.png");
  ASSERT_TRUE(took);
  EXPECT_EQ(took->render.pixels, 300 * 200);
  EXPECT_GT(took->draw, 0);
  EXPECT_GT(took->encode, 0);
}

TEST(WritePicture, ErrorsAreSentences) {
  const ScratchFolder folder;
  PictureOptions little;
  little.memory = 1000;
  const std::string said = sentence(
      write_picture(sample_scene(), {.width = 64, .height = 64}, folder / "a.png", little).error());
  EXPECT_EQ(said.find((folder / "a.png").string() + ": needs at least 1."), 0u) << said;
  EXPECT_EQ(
      sentence(write_picture(sample_scene(), {.background = Color{0, 0, 0, 0}}, folder / "a.jpg")
                   .error()),
      (folder / "a.jpg").string() +
          ": JPEG cannot hold transparency; give the picture an opaque background or another "
          "format");
  EXPECT_EQ(
      sentence(write_picture(sample_scene(), {.region = PixelRect{9000, 0, 5, 5}}, folder / "a.png")
                   .error()),
      (folder / "a.png").string() + ": the image has no pixels");
  for (const View& none :
       {View{.width = 0}, View{.height = 0}, View{.height = View::kMaxSide + 1}}) {
    const std::string wrong =
        sentence(write_picture(sample_scene(), none, folder / "a.png").error());
    EXPECT_NE(wrong.find("a.png: a picture's sides are 1 to 1048576 pixels, not "),
              std::string::npos)
        << wrong;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(WritePicture, CancelledLeavesTheOldFile) {
  for (const char* name : kNames) {
    for (double stop : {0.0, 0.3, 1.0}) {
      const ScratchFolder folder;
      test::write_text(folder / name, "old");
      PictureOptions how;
      double last = 0;
      bool fell = false;
      how.write.progress = [&](double done) {
        fell |= done < last;
        last = done;
        return done < stop;
      };
      const auto done =
          write_picture(sample_scene(), {.width = 600, .height = 900}, folder / name, how);
      EXPECT_EQ(sentence(done.error()), (folder / name).string() + ": cancelled");
      EXPECT_FALSE(fell);
      EXPECT_TRUE(read_text(folder / name) == "old");
      EXPECT_EQ(folder.names(), std::vector<std::string>{name});
    }
  }
}

TEST(StopWatch, RemembersNo) {
  int asked = 0;
  const Progress progress = [&](double) { return ++asked < 3; };
  StopWatch watch(progress);
  EXPECT_FALSE(watch.ask());
  EXPECT_FALSE(watch.done(0.5));
  EXPECT_TRUE(watch.ask());
  EXPECT_TRUE(watch.ask());
  EXPECT_TRUE(watch.done(1));
  EXPECT_EQ(asked, 3) << "no is not asked for again";
}

}  // namespace
}  // namespace mien
