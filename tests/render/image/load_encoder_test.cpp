#include "render/image/load_encoder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "render/image/write_pieces.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(LoadEncoder, WritesEveryTypeByItsModule) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(9, 5, Depth::u8, true);
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg"}) {
    const auto written = write_image_by(load_encoder, image, folder / name, {});
    EXPECT_TRUE(written) << name << ": " << written.error().what;
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
}

}  // namespace
}  // namespace mien
