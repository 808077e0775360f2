#include "render/image/picture_encoder.h"
#include "render/blend/transfer.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using OIIO::TypeDesc;
using test::encode_to;
using test::Read;
using test::read;
using test::value;

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

TEST(TooLittleMemory, SaysHowMuch) {
  EXPECT_EQ(too_little_memory(5 << 19, 1 << 20).what,
            "needs at least 2.5 MiB of memory, more than the 1 MiB allowed");
}

TEST(SlotsWithin, AreAsManyAsTheBudgetHolds) {
  EXPECT_EQ(slots_within({4, 1000}, 0, 100), 4);
  EXPECT_EQ(slots_within({4, 399}, 100, 100), 2);
  EXPECT_EQ(slots_within({4, 99}, 0, 100), 0);
  EXPECT_EQ(slots_within({4, 99}, 100, 1), 0);
}

}  // namespace
}  // namespace mien
