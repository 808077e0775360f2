#include "render/image/oiio/oiio_encoder.h"
#include "lib/picture/srgb.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::encode_to;
using test::Read;
using test::read;
using test::value;

TEST(EncodeExr, IsTaggedLinear) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(
      encode_to(folder / "a.exr", test::sample_image(40, 30, Depth::u8, true), FileType::exr));
  const Read got = read(folder / "a.exr");
  EXPECT_EQ(got.spec.get_string_attribute("oiio:ColorSpace"), "Linear");
  EXPECT_NE(got.spec.find_attribute("chromaticities"), nullptr);
}

TEST(EncodeJpeg, IsCloseAndFullyColoured) {
  // A red field beside a green one: with subsampled colour the border would bleed.
  Image image{64, 64, Depth::u8, true, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool left = i % 64 < 32;
    for (int v : {left ? 200 : 20, left ? 20 : 160, 30, 255}) image.bytes.push_back(std::byte(v));
  }
  const test::ScratchFolder folder;
  ASSERT_TRUE(encode_to(folder / "a.jpg", image, FileType::jpeg, {.jpeg_quality = 98}));
  const Read got = read(folder / "a.jpg");
  ASSERT_EQ(got.spec.nchannels, 3);
  for (int x : {0, 30, 31, 32, 33, 63}) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(got.channels[std::size_t((32 * 64 + x) * 3 + c)], value(image, x, 32, c),
                  8 / 255.0)
          << x << " " << c;
    }
  }
}

TEST(EncodeJpeg, TakesAnyQualityAndLeavesOutALongRecipe) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(16, 16, Depth::u16, true);
  EXPECT_TRUE(encode_to(folder / "a.jpg", image, FileType::jpeg,
                        {.jpeg_quality = 1000, .recipe = std::string(70'000, 'x')}));
  EXPECT_EQ(read(folder / "a.jpg").spec.get_string_attribute("ImageDescription"), "");
}

TEST(EncodeExr, IsTiledWhereItIsWide) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(8500, 300, Depth::u8, true);
  ASSERT_TRUE(encode_to(folder / "a.exr", image, FileType::exr));
  const Read got = read(folder / "a.exr");
  EXPECT_EQ(got.spec.tile_width, 256);
  for (int x : {0, 255, 256, 8499}) {
    EXPECT_NEAR(got.channels[std::size_t((299 * 8500 + x) * 3)],
                linear_from_srgb(value(image, x, 299, 0)), 1.0 / 2048)
        << x;
  }
}

}  // namespace
}  // namespace mien
