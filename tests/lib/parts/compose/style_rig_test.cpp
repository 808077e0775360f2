#include "lib/parts/compose/style_rig.h"

#include <gtest/gtest.h>

#include "lib/file/json/json_copy.h"
#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

std::string controls_with(const std::string& style) {
  test::SmallLibrary small;
  small.topology = test::with(small.topology, "\"soft\": {}", "\"soft\": {" + style + "}");
  small.topology =
      test::with(small.topology, "\"features\": []",
                 R"("features": [], "controls": [{"name": "gaze", "rest": 0, "scale": ["a"]},
                    {"name": "blink", "rest": 0, "offset": {"lid": [0, 1]}, "scale": ["a"]}])");
  const auto library = small.read().value();
  const PartGeometry geometry(*library, Recipe{.name = {}, .code = {}, .parts = {}, .numbers = {}});
  FlatFeatures features;
  for (const FlatFeatures::One& one : {FlatFeatures::One{1, 0, "brow", "hair", "both", 3},
                                       {0, 1, "head", "skin", {}, 1},
                                       {0, 2, "known", "skin", {}, 0}})
    features.add(one);
  const LibraryNode& topology = library->topology();
  JsonTree tree("controls");
  TreeWriter out(tree);
  write_controls(topology.in(), topology.in().need(*topology.node, "controls"),
                 PartStyle(*library, "soft"), {*library, geometry, features}, out);
  std::string text;
  add_json(tree, tree.root(), text);
  return text;
}

TEST(StyleRig, ControlsAreTheTopologys) {
  EXPECT_EQ(controls_with(""),
            R"([{"name": "gaze", "rest": 0, "scale": ["a"]}, )"
            R"({"name": "blink", "rest": 0, "offset": {"lid": [0, 1]}, "scale": ["a"]}])");
}

TEST(StyleRig, AStyleAddsToThem) {
  EXPECT_EQ(
      controls_with(
          R"("controls": {"blink": {"offset": {"dot": {"$vector": [2, 0], "in": "eye"}}, "scale": ["b"], "unit": "x"}})"),
      R"([{"name": "gaze", "rest": 0, "scale": ["a"]}, )"
      R"({"name": "blink", "rest": 0, "offset": {"lid": [0, 1], "dot": [2, 0]}, "scale": ["a", "b"], "unit": "x"}])");
}

TEST(StyleRig, APenMultipliesTheLinesThatThereAre) {
  const std::string with_pen = controls_with(
      R"("pen": {"most": 2, "lines": {"skin": "contour/widths", "front/hair": "half_width", "back/hair": "radii", "beard": "radii"}})");
  EXPECT_NE(
      with_pen.find(R"({"name": "pen", "range": [1, 2], "rest": 1, "scale": )"
                    R"(["brow.left/half_width", "brow.right/half_width", "head/contour/widths"]})"),
      std::string::npos)
      << with_pen;
  EXPECT_THROW(controls_with(R"("pen": {"most": 2, "lines": {"frnt/hair": "radii"}})"), Refusal);
}

TEST(StyleRig, WhatIsNotOfOneKindIsRefused) {
  EXPECT_THROW(controls_with(R"("controls": {"blink": {"offset": ["b"]}})"), Refusal);
}

}  // namespace
}  // namespace mien
