#include "render/image/tiff/tiff_encoder.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::encode_to;
using test::Read;
using test::read;

TEST(EncodeTiff, IsTiledZippedAndHasAProfile) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(
      encode_to(folder / "a.tif", test::sample_image(40, 30, Depth::u8, false), FileType::tiff));
  const Read got = read(folder / "a.tif");
  EXPECT_EQ(got.spec.tile_width, 256);
  EXPECT_EQ(got.spec.get_string_attribute("compression"), "zip");
  EXPECT_EQ(got.spec.get_int_attribute("oiio:UnassociatedAlpha"), 1);
  EXPECT_EQ(got.spec.get_string_attribute("ICCProfile:profile_description"), "sRGB");

  ASSERT_TRUE(
      encode_to(folder / "b.tif", test::sample_image(40, 30, Depth::f32, false), FileType::tiff));
  const Read light = read(folder / "b.tif");
  EXPECT_EQ(light.spec.get_int_attribute("oiio:UnassociatedAlpha"), 0) << "light is premultiplied";
  EXPECT_EQ(light.spec.get_string_attribute("ICCProfile:profile_description"),
            "Linear light, sRGB primaries");
}

TEST(EncodeTiff, HasAResolutionAlways) {
  const test::ScratchFolder folder;
  const auto dpi_of = [&](double dpi) {
    EXPECT_TRUE(encode_to(folder / "a.tif", test::sample_image(4, 3, Depth::u8, true),
                          FileType::tiff, {.dpi = dpi}));
    const Read got = read(folder / "a.tif");
    EXPECT_EQ(got.spec.get_string_attribute("ResolutionUnit"), "in");
    EXPECT_EQ(got.spec.get_float_attribute("YResolution"),
              got.spec.get_float_attribute("XResolution"));
    return got.spec.get_float_attribute("XResolution");
  };
  EXPECT_EQ(dpi_of(0), 72);
  EXPECT_EQ(dpi_of(300), 300);
}

/// The first bytes of a file of that frame.
std::string head_of(const PictureFrame& frame, int& pieces, PixelRect& first) {
  const test::ScratchFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  FileOutput out(file, false);
  const WriteOptions how;
  {
    const auto made =
        tiff_encoder({frame, FileType::tiff, how, {2, std::uint64_t(256) << 20}, out});
    EXPECT_TRUE(made);
    pieces = (*made)->pieces();
    first = (*made)->piece(0);
  }
  ::close(file);
  return test::read_text(folder / "a").substr(0, 3);
}

TEST(TiffEncoder, IsBigWhereThePixelsAre) {
  int pieces;
  PixelRect first;
  EXPECT_EQ(head_of({32768, 32768, Depth::u8, true}, pieces, first), "II*");
  EXPECT_EQ(head_of({32768, 32768, Depth::u8, false}, pieces, first), "II+");
  EXPECT_EQ(first.height, 256);
}

TEST(TiffEncoder, TilesGrowWhereThereWouldBeMillions) {
  const WriteOptions how;
  FileOutput out(-1, false);
  const auto made =
      tiff_encoder({{1 << 20, 1 << 20, Depth::u8, true}, FileType::tiff, how, {2, 1 << 20}, out});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what.substr(0, 15), "needs at least ");
}

TEST(TiffEncoder, FlatTilesAndOthersComeBack) {
  // Two flat tiles of different colours, one mixed, and an edge tile.
  Image image{700, 300, Depth::u8, true, {}};
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 700; ++x) {
      const int level = x < 256 ? 40 : x < 512 ? 90 : (x * y) & 255;
      for (int c = 0; c < 4; ++c) image.bytes.push_back(std::byte(c == 3 ? 255 : level + c));
    }
  }
  const test::ScratchFolder folder;
  ASSERT_TRUE(encode_to(folder / "a.tif", image, FileType::tiff));
  const Read got = read(folder / "a.tif");
  double worst = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 700; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double there = double(got.channels[std::size_t((y * 700 + x) * 3 + c)]);
        worst = std::fmax(worst, std::fabs(there - test::value(image, x, y, c)));
      }
    }
  }
  EXPECT_LT(worst, 1e-6);
}

}  // namespace
}  // namespace mien
