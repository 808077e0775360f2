// The first promise on faces by code: people of all styles, at rest and with a feeling. The long form: MIEN_PEOPLE=30.

#include <mien/composed_face.h>
#include <mien/poser.h>
#include <mien/scene_from_face.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "lib/rig/pose/expression_setting.h"
#include "tests/support/exact/exact_truth.h"
#include "tests/support/exact/exact_windows.h"
#include "tests/support/process/asked.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

using test::ExactTruth;
using test::Tallies;

constexpr std::array<std::string_view, 7> kFeelings{"",     "joy",     "sadness", "anger",
                                                    "fear", "disgust", "surprise"};

Scene scene_of_person(int person, const std::string& style, std::string_view feeling) {
  Recipe recipe = recipe_from_seed(seed_from_word(fmt::format("exact/{}", person)));
  recipe.style = style;
  const Face face = face_from_recipe(recipe).value();
  Pose pose;
  if (!feeling.empty())
    pose.settings.push_back(
        read_expression(face, "emotion", std::string(feeling), OutOfRange::refuse).value());
  Poser poser(face);
  return scene_from_face(poser.pose(pose));
}

void expect_exact_person(const Tallies& tallies) {
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    EXPECT_GT(tallies[i].judged, 0);
    EXPECT_EQ(tallies[i].over, 0) << test::kStorages[i].name << ": " << tallies[i].where;
  }
}

/// The truth of a pixel takes as long as the square of what is in it: braids are thousands of links.
int times_as_few(const Scene& scene) {
  const int crowd = std::max(1, int(scene.nodes().size()) / 500);
  return crowd * crowd;
}

void expect_exact_people(const Scene& scene, int side, int every) {
  every *= times_as_few(scene);
  const View view{.width = side, .height = side, .dither = false};
  const ExactTruth truth(scene, view, ExactTruth::kLit);
  const auto one_in = [&](int x, int y) {
    const auto hash = (std::uint32_t(x) * 0x9e3779b1u) ^ (std::uint32_t(y) * 0x85ebca6bu);
    return (hash >> 8) % std::uint32_t(every * test::kThinning) == 0;
  };
  Tallies tallies;
  test::judge_window(scene, view, {0, 0, side, side}, truth, test::kAllStorages, one_in, tallies);
  expect_exact_person(tallies);
}

TEST(ExactPeople, OfEveryStyle) {
  const int people = test::asked_of("MIEN_PEOPLE", 5);
  const std::vector<std::string> styles = part_styles();
  for (int i = 0; i < people; ++i) {
    const std::string& style = styles[std::size_t(i) % styles.size()];
    const std::string_view feeling = kFeelings[std::size_t(i) % kFeelings.size()];
    const Scene scene = scene_of_person(i, style, feeling);
    SCOPED_TRACE(fmt::format("person {}, {}, {}", i, style, feeling));
    expect_exact_people(scene, 96, 9);
    if (people > 5) expect_exact_people(scene, 333, 97), expect_exact_people(scene, 1024, 997);
  }
}

/// Kinks of the law of light at a tile's border, in dark hair, in a spectacle's rim a pixel wide.
TEST(ExactPeople, ThatWereWrongOnceAreRight) {
  struct Place {
    int person, side, x, y;
  };
  const std::vector<std::string> styles = part_styles();
  for (const Place& p : {Place{7, 96, 80, 68},
                         {22, 96, 66, 51},
                         {22, 96, 46, 5},
                         {22, 333, 150, 75},
                         {27, 333, 122, 125}}) {
    const Scene scene = scene_of_person(p.person, styles[std::size_t(p.person) % styles.size()],
                                        kFeelings[std::size_t(p.person) % kFeelings.size()]);
    const View view{.width = p.side, .height = p.side, .dither = false};
    const ExactTruth truth(scene, view, ExactTruth::kLit);
    Tallies tallies;
    test::judge_window(
        scene, view, {p.x - 1, p.y - 1, 3, 3}, truth, test::kAllStorages,
        [](int, int) { return true; }, tallies);
    SCOPED_TRACE(fmt::format("person {} at {}", p.person, p.side));
    expect_exact_person(tallies);
  }
}

}  // namespace
}  // namespace mien
