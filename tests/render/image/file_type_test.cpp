#include "render/image/file_type.h"

#include <gtest/gtest.h>

#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(FileType, IsByTheExtensionInAnyCase) {
  EXPECT_EQ(*file_type("a.png"), FileType::png);
  EXPECT_EQ(*file_type("a.b/c.PNG"), FileType::png);
  EXPECT_EQ(*file_type("a.tif"), FileType::tiff);
  EXPECT_EQ(*file_type("a.Tiff"), FileType::tiff);
  EXPECT_EQ(*file_type("a.exr"), FileType::exr);
  EXPECT_EQ(*file_type("a.jpg"), FileType::jpeg);
  EXPECT_EQ(*file_type("a.jpeg"), FileType::jpeg);
  EXPECT_EQ(*file_type("-"), FileType::png);
}

TEST(FileType, UnknownOnesAreSentences) {
  EXPECT_EQ(
      sentence(file_type("out/a.gif").error()),
      "out/a.gif: unknown extension .gif; known are .png .tif .tiff .exr .jpg .jpeg, and .svg "
      "to `mien render` and write_svg");
  EXPECT_EQ(sentence(file_type("a.SVG").error()),
            "a.SVG: SVG holds no pixels, so only `mien render` and write_svg write it; known are "
            ".png .tif "
            ".tiff .exr .jpg .jpeg");
  EXPECT_EQ(sentence(file_type("png").error()),
            "png: its name has no extension, which would tell the format; known are .png .tif "
            ".tiff .exr .jpg .jpeg, and .svg to `mien render` and write_svg");
}

TEST(PictureFormats, AreInTheirTypesOrderAndWhatTheHeadersList) {
  for (const PictureFormat& format : picture_formats()) {
    EXPECT_EQ(&format_of(format.type), &format);
    for (const std::string_view extension : format.extensions)
      EXPECT_EQ(*file_type("a" + std::string(extension)), format.type);
  }
  EXPECT_EQ(known_depths(), "PNG 8 16, TIFF 8 16 float, EXR half float, JPEG 8");
  for (const char* header : {"/write.h", "/bind/c/image/mien_image_c.h"}) {
    const std::string text = test::read_text(std::string(MIEN_SOURCE_DIR) + header);
    EXPECT_NE(text.find(known_extensions()), std::string::npos) << header;
  }
}

TEST(CheckFits, KnowsWhatAFormatHolds) {
  EXPECT_TRUE(check_fits({4, 3, Depth::u8, false}, FileType::png));
  EXPECT_TRUE(check_fits({4, 3, Depth::u8, true}, FileType::jpeg));
  EXPECT_EQ(
      check_fits({4, 3, Depth::u8, false}, FileType::jpeg).error().what,
      "JPEG cannot hold transparency; give the picture an opaque background or another format");
  EXPECT_EQ(check_fits({65501, 1, Depth::u8, true}, FileType::jpeg).error().what,
            "JPEG holds sides up to 65500 pixels, not 65501 x 1");
}

TEST(CheckFits, RefusesImagesThatAreNone) {
  EXPECT_EQ(check_fits({}, FileType::png).error().what, "the image has no pixels");
}

}  // namespace
}  // namespace mien
