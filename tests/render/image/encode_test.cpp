#include <mien/render/blend/transfer.h>
#include <mien/render/image/descriptor_proxy.h>
#include <mien/render/image/encode.h>

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "tests/support/sample_image.h"
#include "tests/support/scratch_folder.h"

namespace mien {
namespace {

using OIIO::TypeDesc;

/// What a file holds, as another program reads it: levels as they are, no alpha multiplied in.
struct Read {
  OIIO::ImageSpec spec;
  std::vector<float> channels;  ///< 0 … 1
  bool good = false;
};

Read read(const std::filesystem::path& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto in = OIIO::ImageInput::open(path.string(), &config);
  if (!in) {
    ADD_FAILURE() << path << ": " << OIIO::geterror();
    return {};
  }
  Read got{in->spec(), {}, true};
  got.channels.resize(std::size_t(got.spec.width) * std::size_t(got.spec.height) *
                      std::size_t(got.spec.nchannels));
  got.good = in->read_image(0, 0, 0, got.spec.nchannels, TypeDesc::FLOAT, got.channels.data());
  EXPECT_TRUE(got.good) << in->geterror();
  return got;
}

Expected<Done> encode_to(const std::filesystem::path& path, const Image& image, FileType type,
                         const WriteOptions& how = {}) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
  DescriptorProxy out(file, false);
  auto done = encode(image, type, how, out);
  ::close(file);
  return done;
}

/// The value of one channel of the image in 0 … 1, as its depth means it.
double value(const Image& image, int x, int y, int c) {
  const std::uint8_t* row = image.row(y);
  switch (image.depth) {
    case Depth::u8:
      return row[4 * x + c] / 255.0;
    case Depth::u16:
      return reinterpret_cast<const std::uint16_t*>(row)[4 * x + c] / 65535.0;
    case Depth::f32:
      return double(reinterpret_cast<const float*>(row)[4 * x + c]);
  }
  return 0;
}

/// What the file should hold there: levels for PNG, TIFF of levels and JPEG; premultiplied light
/// for EXR.
double expected(const Image& image, FileType type, int x, int y, int c) {
  const double v = value(image, x, y, c), alpha = value(image, x, y, 3);
  const bool light = image.depth == Depth::f32;
  if (type == FileType::exr && !light && c < 3) return linear_from_srgb(v) * alpha;
  if (type == FileType::png && light && c < 3)
    return alpha > 0 ? srgb_from_linear(std::fmin(v / alpha, 1)) : 0;
  return v;
}

struct Case {
  FileType type;
  Depth depth;
  bool opaque, half;
  TypeDesc::BASETYPE stored;
  double tolerance;
};

class Encode : public testing::TestWithParam<Case> {};

TEST_P(Encode, ComesBackAsItWent) {
  const Case& c = GetParam();
  const test::ScratchFolder folder;
  const Image image =
      test::sample_image(301, 270, c.depth, c.opaque);  // across bands and tiles, none of them full
  const auto done =
      encode_to(folder / "a", image, c.type, {.half = c.half, .recipe = "{\"face\": \"a\"}"});
  ASSERT_TRUE(done) << sentence(done.error());
  // Formats are told by the extension when read.
  const char* names[] = {"a.png", "a.tif", "a.exr", "a.jpg"};
  std::filesystem::rename(folder / "a", folder / names[int(c.type)]);
  const Read got = read(folder / names[int(c.type)]);
  ASSERT_TRUE(got.good);

  EXPECT_EQ(got.spec.width, 301);
  EXPECT_EQ(got.spec.height, 270);
  ASSERT_EQ(got.spec.nchannels, c.opaque ? 3 : 4);
  EXPECT_EQ(got.spec.format, TypeDesc(c.stored));
  EXPECT_EQ(got.spec.get_string_attribute("ImageDescription"), "{\"face\": \"a\"}");
  EXPECT_EQ(got.spec.get_string_attribute("Software").substr(0, 5), "mien ");
  EXPECT_EQ(got.spec.get_string_attribute("DateTime"), "");
  double worst = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int k = 0; k < got.spec.nchannels; ++k) {
        const float there =
            got.channels[std::size_t((y * image.width + x) * got.spec.nchannels + k)];
        worst = std::fmax(worst, std::fabs(double(there) - expected(image, c.type, x, y, k)));
      }
    }
  }
  EXPECT_LE(worst, c.tolerance);
}

constexpr double kExact = 1e-6;            // float against double
constexpr double kLevel16 = 0.51 / 65535;  // rounded once
constexpr double kHalf = 1.0 / 2048;       // half floats below 1: 11 bits
const Case kCases[] = {{FileType::png, Depth::u8, true, true, TypeDesc::UINT8, kExact},
                       {FileType::png, Depth::u8, false, true, TypeDesc::UINT8, kExact},
                       {FileType::png, Depth::u16, true, true, TypeDesc::UINT16, kExact},
                       {FileType::png, Depth::u16, false, true, TypeDesc::UINT16, kExact},
                       {FileType::png, Depth::f32, true, true, TypeDesc::UINT16, kLevel16},
                       {FileType::png, Depth::f32, false, true, TypeDesc::UINT16, kLevel16},
                       {FileType::tiff, Depth::u8, true, true, TypeDesc::UINT8, kExact},
                       {FileType::tiff, Depth::u8, false, true, TypeDesc::UINT8, kExact},
                       {FileType::tiff, Depth::u16, false, true, TypeDesc::UINT16, kExact},
                       {FileType::tiff, Depth::f32, true, true, TypeDesc::FLOAT, kExact},
                       {FileType::tiff, Depth::f32, false, true, TypeDesc::FLOAT, kExact},
                       {FileType::exr, Depth::u8, true, false, TypeDesc::FLOAT, kExact},
                       {FileType::exr, Depth::u8, false, true, TypeDesc::HALF, kHalf},
                       {FileType::exr, Depth::u16, false, false, TypeDesc::FLOAT, kExact},
                       {FileType::exr, Depth::f32, false, false, TypeDesc::FLOAT, kExact},
                       {FileType::exr, Depth::f32, true, true, TypeDesc::HALF, kHalf}};
std::string case_name(const testing::TestParamInfo<Case>& info) {
  static const char* const types[] = {"png", "tiff", "exr", "jpeg"};
  static const char* const depths[] = {"u8", "u16", "f32"};
  return std::string(types[int(info.param.type)]) + "_" + depths[int(info.param.depth)] +
         (info.param.opaque ? "_opaque" : "_alpha") + (info.param.half ? "_half" : "");
}
INSTANTIATE_TEST_SUITE_P(Formats, Encode, testing::ValuesIn(kCases), case_name);

TEST(EncodePng, IsTaggedSrgbAndStraight) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(
      encode_to(folder / "a.png", test::sample_image(40, 30, Depth::u8, false), FileType::png));
  EXPECT_NE(test::read_text(folder / "a.png").find("sRGB"), std::string::npos) << "no sRGB chunk";
}

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

TEST(Encode, TheSamePictureIsTheSameBytes) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(300, 200, Depth::u16, false);
  for (FileType type : {FileType::png, FileType::tiff, FileType::exr}) {
    ASSERT_TRUE(encode_to(folder / "a", image, type));
    const std::string first = test::read_text(folder / "a");
    ::usleep(1'100'000);  // a clock in the file would have moved on
    ASSERT_TRUE(encode_to(folder / "a", image, type));
    EXPECT_EQ(test::read_text(folder / "a"), first) << int(type);
  }
}

TEST(Encode, CancelsBetweenBands) {
  const test::ScratchFolder folder;
  std::vector<double> asked;
  const WriteOptions how{
      .progress = [&](double done) { return asked.push_back(done), done < 0.4; }};
  const auto done =
      encode_to(folder / "a", test::sample_image(10, 1024, Depth::u8, true), FileType::png, how);
  EXPECT_EQ(done.error().what, "cancelled");
  EXPECT_EQ(asked, (std::vector<double>{0.0, 0.25, 0.5}));
}

}  // namespace
}  // namespace mien
