#include "render/image/oiio/oiio_reader.h"

#include <gtest/gtest.h>

#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tests/support/pictures/sample_image.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

/// Read in strips of so many rows.
std::vector<std::byte> read_again(PictureReader& reader, const Image& image, int strip) {
  std::vector<std::byte> bytes(image.bytes.size());
  for (int y = 0; y < image.height; y += strip)
    if (!reader.next(std::min(strip, image.height - y),
                     bytes.data() + std::size_t(y) * image.stride(), image.stride(),
                     [] { return false; }))
      ADD_FAILURE() << "rows from " << y << " on cannot be read";
  return bytes;
}

// Alpha is as it was stored: a reader that multiplies it in would lose colours.
TEST(OiioReader, GivesBackWhatWasWritten) {
  const test::ScratchFolder folder;
  for (const bool opaque : {true, false})
    for (const Depth depth : {Depth::u8, Depth::u16, Depth::f32})
      for (const char* name : {"a.png", "a.tif"}) {
        if (depth == Depth::f32 && name == std::string_view("a.png")) continue;
        const Image image = test::sample_image(700, 601, depth, opaque);
        ASSERT_TRUE(write_image_by(load_encoder, image, folder / name, {}));
        for (const int strip : {1, 17, 256, 601}) {
          const auto reader = load_reader(folder / name);
          ASSERT_TRUE(reader) << reader.error().what;
          EXPECT_EQ((*reader)->width(), 700);
          EXPECT_EQ((*reader)->height(), 601);
          EXPECT_EQ((*reader)->depth(), depth);
          EXPECT_EQ((*reader)->opaque(), opaque);
          EXPECT_TRUE(read_again(**reader, image, strip) == image.bytes)
              << name << ", depth " << int(depth) << ", " << strip << " rows at once";
        }
      }
}

TEST(OiioReader, SaysWhatIsNoPicture) {
  const test::ScratchFolder folder;
  test::write_text(folder / "a.png", "no picture");
  const auto none = load_reader(folder / "a.png");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().where, (folder / "a.png").string());
  EXPECT_TRUE(none.error().what.starts_with("cannot be read: ")) << none.error().what;
  EXPECT_FALSE(load_reader(folder / "b.png"));
}

TEST(OiioReader, EndsWithThePicture) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(20, 10, Depth::u8, true);
  ASSERT_TRUE(write_image_by(load_encoder, image, folder / "a.png", {}));
  const auto reader = load_reader(folder / "a.png");
  ASSERT_TRUE(reader);
  std::vector<std::byte> bytes(image.bytes.size() * 2);
  const auto done = (*reader)->next(20, bytes.data(), image.stride(), [] { return false; });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "has fewer rows than it should");
}

TEST(OiioReader, StopsWhenAsked) {
  const test::ScratchFolder folder;
  const Image image = test::sample_image(2100, 300, Depth::u8, true);
  ASSERT_TRUE(write_image_by(load_encoder, image, folder / "a.tif", {}));
  const auto reader = load_reader(folder / "a.tif");
  ASSERT_TRUE(reader);
  std::vector<std::byte> bytes(image.bytes.size());
  int asked = 0;
  const auto done =
      (*reader)->next(300, bytes.data(), image.stride(), [&] { return ++asked == 2; });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what, "cancelled");
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace mien
