#include "render/rows/frame_memory.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

constexpr int kRows = 4, kWidth = 3;
constexpr std::size_t kRowBytes = 4 * kWidth;
constexpr FrameMemory::Frame kFrame{kRows, {0, 0, kWidth, kRows}, Depth::u8, 1};

FrameMemory::Frame with(auto change) {
  FrameMemory::Frame frame = kFrame;
  change(frame);
  return frame;
}

TEST(FrameMemory, KeepsNothingUntilTwoFramesAreAlike) {
  FrameMemory memory;
  EXPECT_FALSE(memory.begin(kFrame)) << "the first";
  EXPECT_FALSE(memory.begin(with([](auto& f) { f.same = 0; })));
  EXPECT_TRUE(memory.begin(kFrame));
  EXPECT_FALSE(memory.begin(with([](auto& f) { f.rows = 5; })));
  EXPECT_FALSE(memory.begin(kFrame));
  EXPECT_FALSE(memory.begin(with([](auto& f) { f.depth = Depth::u16; })));
  EXPECT_FALSE(memory.begin(kFrame));
  EXPECT_FALSE(memory.begin(with([](auto& f) { f.rect.x = 1; })));
}

TEST(FrameMemory, RegionsThatMeetAreAlikePiecesOfOnePictureAreNot) {
  FrameMemory memory;
  const auto rows = [](int y, int height) {
    return with([&](auto& f) { f.rect.y = y, f.rect.height = height; });
  };
  memory.begin(rows(0, 2));
  EXPECT_FALSE(memory.begin(rows(2, 2)));
  EXPECT_TRUE(memory.begin(rows(1, 2)));
}

TEST(FrameMemory, IsNotForPicturesLargerThanItSays) {
  const auto wide = [](int more) {
    return with([&](auto& f) {
      f.rows = 1, f.rect = {0, 0, int(FrameMemory::kMost / 4) + more, 1};
    });
  };
  FrameMemory memory;
  memory.begin(wide(0));
  EXPECT_TRUE(memory.begin(wide(0)));
  memory.begin(wide(1));
  EXPECT_FALSE(memory.begin(wide(1)));
}

TEST(FrameMemory, RecallsRowsUntilTheyAreForgotten) {
  FrameMemory memory;
  memory.begin(kFrame);
  memory.begin(kFrame);
  const std::vector<std::byte> row(kRowBytes, std::byte{7});
  std::vector<std::byte> to(kRowBytes);
  EXPECT_FALSE(memory.holds(2));
  for (const int y : {1, 2, 3}) memory.keep(y, row.data());
  memory.begin(kFrame);
  ASSERT_TRUE(memory.holds(2));
  memory.recall(2, to.data());
  EXPECT_EQ(to, row);
  memory.forget(1, 3);
  EXPECT_FALSE(memory.holds(1) || memory.holds(2));
  EXPECT_TRUE(memory.holds(3));
  memory.begin(with([](auto& f) { f.rect.x = 1; }));
  memory.begin(with([](auto& f) { f.rect.x = 1; }));
  EXPECT_FALSE(memory.holds(3)) << "of other columns";
}

}  // namespace
}  // namespace mien
