#include "render/image/png/png_bytes.h"

#include <gtest/gtest.h>

#include "tests/support/pictures/read_back.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

TEST(PngBytes, AreThoseOfTheFile) {
  const test::ScratchFolder folder;
  const WriteOptions how{.dpi = 300, .recipe = "{\"mien\": 1}"};
  for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32})
    for (const bool opaque : {true, false})
      for (const int height : {1, 300, 1200}) {  // one strip, several, several pieces
        const Image image = test::sample_image(97, height, depth, opaque);
        const auto bytes = png_bytes(image, how);
        ASSERT_TRUE(test::encode_to(folder / "a.png", image, FileType::png, how));
        const std::string file = test::read_text(folder / "a.png");
        ASSERT_EQ(bytes.size(), file.size());
        EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), file.begin(),
                               [](std::byte a, char b) { return a == std::byte(b); }));
      }
}

}  // namespace
}  // namespace mien
