// The first promise on patterns, made areas, clips, pen contours, feathers and shadows on one feature, and that the judge
// would see them go wrong.

#include <mien/face_file.h>
#include <mien/pattern.h>
#include <mien/render.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/support/exact/exact_truth.h"
#include "tests/support/exact/exact_windows.h"
#include "tests/support/faces/box_letters.h"
#include "tests/support/faces/primitive_features.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

using test::ExactTruth;
using test::primitive_features;
using test::Tallies;
using test::Tally;

Scene primitive_scene(const std::string& features) {
  const Expected<Face> face = read_face_text(test::face_of_primitives(features), "primitives", {},
                                             nullptr, test::box_letters());
  if (!face) throw std::runtime_error(sentence(face.error()));
  return scene_from_face(*face);
}

Tallies judged(const Scene& drawn, const Scene& meant, int side, int every) {
  const View view{.width = side, .height = side, .dither = false};
  const ExactTruth truth(meant, view, ExactTruth::kLit);
  const auto one_in = [&](int x, int y) {
    const auto hash = (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca6bu);
    return (hash >> 8) % std::uint32_t(every) == 0;
  };
  Tallies tallies;
  test::judge_window(drawn, view, {0, 0, side, side}, truth, test::kAllStorages, one_in, tallies);
  return tallies;
}

TEST(ExactPrimitives, AreWithinALevel) {
  for (const auto& [what, features] : primitive_features()) {
    if (what == "head" || what == "cap") continue;
    const Scene scene = primitive_scene(features);
    for (const auto& [side, every] : {std::pair{23, 5}, {64, 41}}) {
      const Tallies tallies = judged(scene, scene, side, every * test::kThinning);
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        EXPECT_GT(tallies[i].judged, 0) << what;
        EXPECT_EQ(tallies[i].over, 0) << what << " at " << side << ", " << test::kStorages[i].name
                                      << ": " << tallies[i].where;
      }
    }
  }
}

/// Letters of boxes: the outlines of a font's are paths like any other.
TEST(ExactPrimitives, TextsAreWithinALevelAndWhereTheyAreMeant) {
  const std::string text =
      R"({"name": "badge", "kind": "text", "text": "mien", "center": [0.1, 0.2], "height": 0.6,
      "tilt": -20, "paint": "half", "clip": "head", "contour": {"color": "black", "half_width": 0.02}})";
  const Scene meant = primitive_scene(text);
  for (const Tally& tally : judged(meant, meant, 31, 5 * test::kThinning))
    EXPECT_EQ(tally.over, 0) << tally.where;
  for (const auto& [from, to] : {std::pair{"mien", "mie"}, {"0.6", "0.61"}, {"-20", "-21"}}) {
    std::string drawn = text;
    drawn.replace(drawn.find(from), std::string(from).size(), to);
    EXPECT_GT(judged(primitive_scene(drawn), meant, 31, 2)[2].over, 5) << to;
  }
}

TEST(ExactPrimitives, HaveNoDoubts) {
  std::string all;
  for (const auto& [what, features] : primitive_features())
    if (what != "head" && what != "cap") all += (all.empty() ? "" : ",\n") + features;
  const Scene scene = primitive_scene(all);
  for (const int side : {48, 160, 640}) {
    RenderStats stats;
    test::rendered(scene, {.width = side, .height = side}, {}, &stats);
    EXPECT_EQ(stats.doubts, 0) << side;
  }
}

/// Any other number is another picture: one figure more, another seed, a clip less.
TEST(ExactPrimitives, ThatAreOthersAreSeenToBe) {
  const struct {
    const char *what, *from, *to;
  } changes[] = {{"outside", R"("clip": {"outside": "cap"}, )", ""},
                 {"clips", R"(["head", {"outside": "cap"}])", R"("head")"},
                 {"area", R"(, "minus": ["hole"])", ""},
                 {"scatter", R"("seed": 4)", R"("seed": 5)"},
                 {"lattice", R"("stagger": true, )", ""},
                 {"repeat", R"("count": 11)", R"("count": 12)"},
                 {"stripes", R"("vary": 0.4)", R"("vary": 0.3)"},
                 {"rounded", R"("corner": 0.2)", R"("corner": 0.25)"},
                 {"pen by angle", R"([0.02, 0.08])", R"([0.02, 0.06])"},
                 {"pen along", R"([0, 0.09])", R"([0, 0.07])"},
                 {"widths", R"([0, 0.1, 0.03, 0])", R"([0, 0.08, 0.03, 0])"},
                 {"feather", R"("feather": 0.3)", R"("feather": 0.2)"},
                 {"shadow on", R"(, "on": "head")", ""}};
  for (const auto& change : changes) {
    const std::string meant = primitive_features().at(change.what);
    std::string drawn = meant;
    ASSERT_NE(drawn.find(change.from), std::string::npos) << change.what;
    drawn.replace(drawn.find(change.from), std::string(change.from).size(), change.to);
    const Tallies tallies = judged(primitive_scene(drawn), primitive_scene(meant), 24, 2);
    EXPECT_GT(tallies[2].over, 5) << change.what;
  }
}

/// The most figures that a pattern may have, all over each other: much work, but bounded.
TEST(ExactPrimitives, ThePatternOfTheMostFiguresIsDrawn) {
  const Scene scene = primitive_scene(fmt::format(
      R"({{"name": "sand", "kind": "scatter", "paint": "half", "count": {}, "patch": [[[-1, -1], [1, -1]], [[-1, 1], [1, 1]]], "of": "disc", "radius": 0.02}})",
      test::kSanitized ? 400 : kMostPatternFigures));
  RenderStats stats;
  test::rendered(scene, {.width = 64, .height = 64}, {}, &stats);
  EXPECT_EQ(stats.doubts, 0);
}

}  // namespace
}  // namespace mien
