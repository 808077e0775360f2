#include "lib/parts/compose/style_features.h"

#include <gtest/gtest.h>

#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

class SelectedFeatures : public testing::Test {
 protected:
  std::vector<std::string> names(const std::string& selection, std::size_t order,
                                 Operands which = Operands::all) {
    test::SmallLibrary small;
    small.topology = test::with(small.topology, "\"features\": []",
                                "\"features\": [], \"selection\": " + selection);
    const auto library = small.read().value();
    const Reading& in = library->topology().in();
    return selected_features(in, in.need(*library->topology().node, "selection"), order, *library,
                             features_, which);
  }

  static FlatFeatures known_features() {
    FlatFeatures features;
    for (const FlatFeatures::One& one : {FlatFeatures::One{1, 0, "fringe", "hair", {}, 3},
                                         {0, 1, "ear", "skin", "both", 1},
                                         {0, 2, "bun", "hair", "left", 1},
                                         {1, 3, "room", "none", {}, 3},
                                         {1, 4, "cap", "hat", {}, 0}})
      features.add(one);
    return features;
  }

  FlatFeatures features_ = known_features();
};

using FoundNames = std::vector<std::string>;

TEST_F(SelectedFeatures, AreOfTheirRolesAndSlots) {
  EXPECT_EQ(names(R"({"roles": ["hair"]})", 3), (FoundNames{"bun.left", "fringe"}));
  EXPECT_EQ(names(R"({"roles": ["hair"], "slots": ["back"]})", 3), FoundNames{"bun.left"});
  EXPECT_EQ(names(R"({"slots": ["front"]})", 3), (FoundNames{"cap", "fringe"}))
      << "what has no role is an area";
  EXPECT_EQ(names(R"({"roles": ["skin"]})", 3), (FoundNames{"ear.left", "ear.right"}));
  EXPECT_TRUE(names(R"({"roles": ["wool"]})", 3).empty());
  EXPECT_EQ(names(R"({"roles": ["back/hair", "hat"]})", 3), (FoundNames{"cap", "bun.left"}));
}

TEST_F(SelectedFeatures, AreDrawnBeforeTheArea) {
  EXPECT_EQ(names(R"({"roles": ["hair", "hat"]})", 1), (FoundNames{"cap", "bun.left"}));
}

TEST_F(SelectedFeatures, OfAUnionWhatIsCutToAnotherOneIsLeftOut) {
  for (const FlatFeatures::One& one : {FlatFeatures::One{1, 5, "sleeve", "cloth", "both", 1},
                                       {1, 6, "cuff", "cloth", "both", 1, false, {"sleeve"}},
                                       {1, 7, "patch", "cloth", "left", 1, false, {"room", "cap"}},
                                       {1, 8, "badge", "cloth", "left", 1, false, {"pin"}},
                                       {1, 9, "pin", "cloth", "right", 1}})
    features_.add(one);
  const std::string all = R"({"roles": ["cloth", "hat"]})";
  EXPECT_EQ(names(all, 1).size(), 8u) << "an intersection is another one without it";
  EXPECT_EQ(names(all, 1, Operands::of_union),
            (FoundNames{"cap", "sleeve.left", "sleeve.right", "badge.left", "pin.right"}))
      << "the badge's pin is on the other side";
  EXPECT_EQ(names(R"({"roles": ["cloth"]})", 1, Operands::of_union),
            (FoundNames{"sleeve.left", "sleeve.right", "patch.left", "badge.left", "pin.right"}))
      << "the cap is none of them";
}

TEST_F(SelectedFeatures, SlotsAreKnown) {
  EXPECT_THROW(names(R"({"slots": ["frnt"]})", 3), Refusal);
  EXPECT_THROW(names(R"({"roles": ["frnt/hair"]})", 3), Refusal);
}

}  // namespace
}  // namespace mien
