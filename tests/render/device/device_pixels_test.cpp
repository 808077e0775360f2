#include <mien/device_pixels.h>
#include "render/device/packed_row.h"
#include "tests/support/pictures/rendered.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace mien {
namespace {

constexpr DeviceFormat kFormats[] = {DeviceFormat::rgb565, DeviceFormat::rgb565_swapped,
                                     DeviceFormat::bgrx, DeviceFormat::mono};

Scene two_discs() {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {0.9, 0.8, 0.7, 1});
  build.layer("one", build.shape(Disc{{-0.2, 0.1}, 0.5}), {{0.1, 0.2, 0.7, 0.6}});
  build.layer("two", build.shape(Disc{{0.3, -0.1}, 0.4}), {{0.8, 0.2, 0.1, 0.6}});
  return std::move(build).finish();
}

std::vector<std::byte> drawn(DeviceFormat format, const View& view, int threads = 1) {
  const PixelRect rect = drawn_rect(view);
  const std::size_t stride = device_row_bytes(format, rect.width);
  std::vector<std::byte> bytes(stride * std::size_t(rect.height));
  EXPECT_TRUE(render_for_device({bytes.data(), stride, format}, two_discs(), view,
                                {.threads = {.count = threads}}));
  return bytes;
}

TEST(DevicePixels, AreThePicturesPacked) {
  for (const DeviceFormat format : kFormats)
    for (const bool dither : {true, false}) {
      const View view{.width = 61, .height = 83, .dither = dither};
      const auto picture = render(two_discs(), view, {.depth = depth_for(format)});
      ASSERT_TRUE(picture);
      const std::size_t stride = device_row_bytes(format, 61);
      std::vector<std::byte> packed(stride * 83);
      for (int y = 0; y < 83; ++y)
        pack_row(format, picture->bytes.data() + picture->stride() * std::size_t(y), 0, y, 61,
                 dither, packed.data() + stride * std::size_t(y));
      EXPECT_TRUE(drawn(format, view) == packed) << int(format);
      EXPECT_TRUE(drawn(format, view, 3) == packed) << int(format);
    }
}

TEST(DevicePixels, OfARegionAreThoseOfTheWhole) {
  const View view{.width = 64, .height = 50};
  View part = view;
  part.region = PixelRect{16, 21, 24, 20};
  for (const DeviceFormat format : kFormats) {
    const std::vector<std::byte> all = drawn(format, view), some = drawn(format, part);
    const std::size_t wide = device_row_bytes(format, 64), narrow = device_row_bytes(format, 24),
                      before = device_row_bytes(format, 16);
    for (std::size_t y = 0; y < 20; ++y)
      for (std::size_t i = 0; i < narrow; ++i)
        ASSERT_EQ(some[narrow * y + i], all[wide * (y + 21) + before + i]) << int(format);
  }
}

TEST(DevicePixels, LeaveWhatIsBetweenRowsAlone) {
  std::vector<std::byte> bytes(40 * 16, std::byte{0x5a});
  ASSERT_TRUE(render_for_device({bytes.data(), 40, DeviceFormat::rgb565}, two_discs(),
                                {.width = 16, .height = 16}));
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t i = 32; i < 40; ++i) EXPECT_EQ(bytes[40 * y + i], std::byte{0x5a});
}

TEST(DevicePixels, TellWhatIsWrong) {
  std::vector<std::byte> bytes(4096);
  const DeviceBuffer out{bytes.data(), 64, DeviceFormat::rgb565};
  EXPECT_FALSE(render_for_device(out, two_discs(), {.width = 0, .height = 4}));
  int asked = 0;
  const auto stopped =
      render_for_device(out, two_discs(), {.width = 32, .height = 32}, {.progress = [&](double) {
                          ++asked;
                          return false;
                        }});
  ASSERT_FALSE(stopped);
  EXPECT_NE(stopped.error().what.find("cancelled"), std::string::npos);
  EXPECT_GT(asked, 0);
}

TEST(DevicePixels, RowsAreAsLongAsTheyAre) {
  EXPECT_EQ(device_row_bytes(DeviceFormat::rgb565, 240), 480u);
  EXPECT_EQ(device_row_bytes(DeviceFormat::bgrx, 3), 12u);
  EXPECT_EQ(device_row_bytes(DeviceFormat::mono, 8), 1u);
  EXPECT_EQ(device_row_bytes(DeviceFormat::mono, 9), 2u);
  EXPECT_EQ(device_row_bytes(DeviceFormat::mono, -1), 0u);
}

}  // namespace
}  // namespace mien
