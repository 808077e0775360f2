#include "render/image/png/animated_png.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/pictures/read_film.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(AnimatedPng, PartsTakeThePlaceOfWhatWasThere) {
  const test::ScratchFolder folder;
  const auto path = folder / "a.apng";
  const int file = ::open(path.c_str(), O_CREAT | O_RDWR, 0600);
  FileOutput out(file, false);
  const Image first = test::sample_image(300, 200, Depth::u8, false);
  Image second = first;
  for (int y = 50; y < 60; ++y)
    for (int x = 20; x < 40; ++x)
      for (int c = 0; c < 4; ++c) {
        auto& byte = second.bytes[second.stride() * std::size_t(y) + std::size_t(4 * x + c)];
        byte = std::byte(c == 3 ? y % 2 * 255 : 17);
      }
  AnimatedPng png(out, {300, Depth::u8, false}, 200);
  ASSERT_TRUE(png.add({0, 0, 300, 200}, first.bytes.data(), first.stride(), {1, 30}));
  ASSERT_TRUE(png.add({20, 50, 20, 10}, second.bytes.data() + second.stride() * 50 + 80,
                      second.stride(), {65535, 1000}));
  ASSERT_TRUE(png.finish());
  ::close(file);
  const test::ReadFilm film = test::read_film(path);
  ASSERT_EQ(film.frames.size(), 2u);
  EXPECT_TRUE(film.endless);
  EXPECT_EQ(film.frames[0].seconds, 1 / 30.0);
  EXPECT_EQ(film.frames[1].seconds, 65.535);
  for (std::size_t i = 0; i < 2; ++i) {
    const Image& image = i == 0 ? first : second;
    EXPECT_TRUE(
        std::equal(image.row(0), image.row(0) + image.bytes.size(), film.frames[i].pixels.begin()))
        << i;
  }
}

TEST(AnimatedPng, AFullDeviceIsAnError) {
  const int full = ::open("/dev/full", O_RDWR);
  FileOutput out(full, false);
  const Image image = test::sample_image(3, 2, Depth::u8, true);
  AnimatedPng png(out, {3, Depth::u8, true}, 2);
  const auto done = png.add({0, 0, 3, 2}, image.bytes.data(), image.stride(), {1, 30});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "cannot be written: No space left on device");
  ::close(full);
}

}  // namespace
}  // namespace mien
