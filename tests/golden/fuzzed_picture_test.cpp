// Random scenes of plain colours, on lattices and off them, every pixel judged: a slice of what
// mien_fuzz_pictures does for as long as one likes.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>

#include "tests/support/process/effort.h"
#include "tests/support/random/fuzzed_picture.h"

namespace mien::test {
namespace {

void expect_right(std::string_view kind, std::uint64_t seed, int side, FuzzTally& tally) {
  Scene scene;
  ASSERT_TRUE(fuzzed_scene(kind, seed, scene));
  judge_fuzzed(scene, side, tally);
  EXPECT_EQ(tally.over, 0) << kind << ' ' << seed << ": " << tally.where;
}

class ManyFuzzedPictures : public testing::TestWithParam<const char*> {};

TEST_P(ManyFuzzedPictures, AreRightInEveryPixel) {
  FuzzTally tally;
  for (int seed = 1; seed <= times(24); ++seed)
    expect_right(GetParam(), std::uint64_t(seed), seed % 2 ? 24 : 32, tally);
  EXPECT_LE(tally.doubted, tally.pictures / 4);
  RecordProperty("worst", fmt::format("{:.3f} of what is allowed, of {} pixels asked about",
                                      tally.worst, tally.asked));
}

INSTANTIATE_TEST_SUITE_P(Kinds, ManyFuzzedPictures,
                         testing::Values("lattice", "jittered", "generic", "huge", "strokes",
                                         "mixed"),
                         [](const auto& kind) { return std::string(kind.param); });

/// Scenes that once were wrong: strokes whose spine all but turns back; slivers; caps whose moments went by their chords;
/// distances of shells, polylines and combinations whose ridges lie a pixel apart.
TEST(FuzzedPictures, ThatWereWrongOnceAreRight) {
  struct Found {
    const char* kind;
    std::uint64_t seed;
    int side;
  };
  FuzzTally tally;
  for (const Found& f :
       {Found{"jittered", 91, 32},
        {"jittered", 160, 32},
        {"jittered", 278, 24},
        {"jittered", 295, 24},
        {"jittered", 397, 32},
        {"jittered", 20847, 32},
        {"jittered", 1004321, 24},  // slivers within a path, which the judges
        {"jittered", 1013555, 32},  // overlooked
        {"generic", 809, 24},
        {"painted", 2, 24},
        {"painted", 3, 24},
        {"painted", 120, 24},
        {"painted", 138, 24},
        {"painted", 44, 24},      // a hairpin between two looks along a spine
        {"painted", 20002, 24},   // a ridge half a pixel beside a block's foot
        {"painted", 5010, 32},    // a ridge whose slope jumps by little, seen by one block
        {"painted", 300012, 32},  // a thin shell: three ridges in two pixels
        {"painted", 178, 24},
        {"painted", 286, 24},
        {"painted", 419, 24}})
    expect_right(f.kind, f.seed, f.side, tally);
}

TEST(FuzzedScene, KnowsItsKinds) {
  Scene scene;
  for (const char* kind : {"lattice", "jittered", "generic", "huge", "strokes", "painted", "mixed"})
    EXPECT_TRUE(fuzzed_scene(kind, 1, scene));
  EXPECT_FALSE(fuzzed_scene("other", 1, scene));
}

}  // namespace
}  // namespace mien::test
