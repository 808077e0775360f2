// What is laid over a picture and pictures about it are written in strips, as pictures are: within
// the memory allowed, and the same for any of it; a region shows the whole's pixels.

#include <gtest/gtest.h>

#include "tests/support/pictures/read_back.h"
#include "tests/support/process/effort.h"
#include "tests/support/process/run_command.h"

namespace mien {
namespace {

using test::face_path;
using test::Ran;
using test::run_mien;
using test::ScratchFolder;
using Words = std::vector<std::string>;

const Words kKinds[] = {{"--effect", "mosaic:9,0.3", "--effect", "grid:7"},
                        {"--effect", "mosaic:1"},
                        {"--debug", "looks"},
                        {"--debug", "normals"}};

Ran render(const std::filesystem::path& to, const Words& kind, const Words& more) {
  Words words{"render", face_path("toon"), "-o", to.string()};
  words.insert(words.end(), kind.begin(), kind.end());
  words.insert(words.end(), more.begin(), more.end());
  return run_mien(words);
}

TEST(Strips, HoldNoMoreThanTheMemory) {
  const ScratchFolder folder;
  for (const Words& kind : kKinds) {
    const Ran ran = render(folder / "a.png", kind, {"--size", "300", "--memory", "1K"});
    EXPECT_EQ(ran.code, 1) << kind[1];
    EXPECT_NE(ran.err.find("of memory, more than the 1 KiB allowed"), std::string::npos) << ran.err;
  }
  const Ran ran = run_mien({"render", face_path("toon"), "-o", (folder / "a.png").string(),
                            "--error-map", (folder / "e.png").string(), "--size", "64x2000",
                            "--region", "0,0,4,4", "--memory", "1K"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Strips, AreTheSameForAnyMemoryAndThreads) {
  const ScratchFolder folder;
  for (const char* type : {".png", ".tif"})
    for (const Words& kind : kKinds) {
      const auto a = folder / (std::string("a") + type), b = folder / (std::string("b") + type);
      ASSERT_EQ(render(a, kind, {"--size", "200"}).code, 0);
      const Ran ran = render(b, kind, {"--size", "200", "--memory", "3M", "--threads", "1"});
      ASSERT_EQ(ran.code, 0) << ran.err;
      EXPECT_EQ(test::read(a).channels, test::read(b).channels) << kind[1] << type;
    }
}

TEST(Strips, OfAnErrorMapHaveOneScale) {
  const ScratchFolder folder;
  std::vector<float> maps[2];
  std::string said[2];
  const auto map = (folder / "e.png").string();
  for (int i = 0; i < 2; ++i) {
    const Ran ran = render(folder / "a.png", {"--error-map", map},
                           {"--size", "600", "--memory", i ? "7M" : "1G"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    maps[i] = test::read(map).channels;
    said[i] = ran.out;
  }
  EXPECT_EQ(maps[0], maps[1]);
  EXPECT_EQ(said[0], said[1]);
}

/// The whole's pixels from (x, y) on.
std::vector<float> cut(const test::Read& whole, int x, int y, int width, int height) {
  const auto channels = std::size_t(whole.spec.nchannels);
  std::vector<float> part;
  for (int row = y; row < y + height; ++row) {
    const auto from =
        (std::size_t(row) * std::size_t(whole.spec.width) + std::size_t(x)) * channels;
    part.insert(part.end(), whole.channels.begin() + std::ptrdiff_t(from),
                whole.channels.begin() + std::ptrdiff_t(from + channels * std::size_t(width)));
  }
  return part;
}

// Items G9, G10.
TEST(Strips, ARegionShowsTheWholesPixels) {
  const ScratchFolder folder;
  for (const Words& kind : kKinds) {
    ASSERT_EQ(render(folder / "a.png", kind, {"--size", "96x54"}).code, 0);
    ASSERT_EQ(render(folder / "b.png", kind, {"--size", "96x54", "--region", "21,13,33,22"}).code,
              0);
    const test::Read part = test::read(folder / "b.png");
    EXPECT_EQ(part.spec.width, 33);
    EXPECT_EQ(part.channels, cut(test::read(folder / "a.png"), 21, 13, 33, 22)) << kind[1];
  }
}

TEST(Strips, OfAVastPictureShowItsCorner) {
  const ScratchFolder folder;
  const Words more{"--size", "200000", "--region", "0,0,10,10", "--memory", "64M"};
  EXPECT_EQ(render(folder / "a.png", {"--effect", "grid:4"}, more).code, 0);
  EXPECT_EQ(test::read(folder / "a.png").spec.width, 10);
}

TEST(Strips, WhatFindsNoMemorySaysSo) {
  if (test::kSanitized) GTEST_SKIP() << "its own allocator ends the program instead";
  const ScratchFolder folder;
  const Ran ran = run_mien({"animate", face_path("toon"), "--frames", "0-1", "--threads", "1",
                            "--size", "1000000", "-o", (folder / "%d.png").string()});
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("memory ran out: the picture has 1000000 x 562500 pixels"),
            std::string::npos)
      << ran.err;
}

TEST(Strips, ADebugPictureTakesNoEffectsAndTellsNoStats) {
  const ScratchFolder folder;
  for (const Words& more : {Words{"--effect", "grid:4"}, Words{"--stats", "json"}}) {
    const Ran ran = render(folder / "a.png", {"--debug", "looks"}, more);
    EXPECT_EQ(ran.code, 2) << more[0];
    EXPECT_NE(ran.err.find(more[0] + ": is of the face's own picture"), std::string::npos)
        << ran.err;
  }
}

}  // namespace
}  // namespace mien
