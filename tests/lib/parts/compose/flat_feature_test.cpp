#include "lib/parts/compose/flat_feature.h"

#include <gtest/gtest.h>

#include "lib/file/json/json_copy.h"
#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

using test::SmallLibrary;

/// What features of a nose become, and their texts.
struct Flattened : FlatFeatures {
  std::vector<std::string> texts;

  static std::map<std::string, double> named(const std::vector<Depth>& depths) {
    std::map<std::string, double> all;
    for (const Depth& one : depths) all[std::string(one.name)] = one.depth;
    return all;
  }
  std::map<std::string, double> depths() const { return named(flat); }
};

class FlatFeatureTest : public testing::Test {
 protected:
  Flattened flatten(const std::string& features, const std::string& style = "soft",
                    std::map<std::string, double> numbers = {}) {
    SmallLibrary small;
    small.topology =
        test::with(small.topology, "\"features\": []", "\"features\": [" + features + "]");
    small.topology = test::with(small.topology, "\"soft\": {}", "\"soft\": {" + style_ + "}");
    library_ = small.read().value();
    const Recipe recipe{.name = {}, .code = {}, .parts = {}, .numbers = std::move(numbers)};
    PartGeometry geometry(*library_, recipe);
    const PartStyle paints(*library_, style);
    Flattened made;
    JsonTree& tree = tree_.emplace("flat");
    TreeWriter out(tree);
    out.array();
    const LibraryNode& topology = library_->topology();
    const Reading& in = topology.in();
    in.for_each(in.need(*topology.node, "features"), [&](const JsonNode& node, int) {
      flatten_feature(in, node, "nose", *library_, paints, geometry, made, out);
    });
    out.close();
    for (const FlatFeatures::One& one : made.all())
      add_json(tree, tree.nodes[std::size_t(one.node)], made.texts.emplace_back());
    return made;
  }

  std::string style_;  ///< what "soft" says
  std::unique_ptr<PartLibrary> library_;
  std::optional<JsonTree> tree_;  // names are its
};

TEST_F(FlatFeatureTest, PointsAreTheFacesAndHalvesAreWhole) {
  const Flattened made = flatten(
      R"({"name": "a", "slot": "front", "role": "hair.line", "in": "eye", "kind": "path", "half": true,
          "points": [[0, 5], [1.5, 3, "bend"], [1, 2]]})",
      "soft", {{"size", 2}});
  ASSERT_EQ(made.all().size(), 1u);
  EXPECT_EQ(made.all()[0].slot, 1u);
  EXPECT_EQ(
      made.texts[0],
      R"({"name": "a", "kind": "path", "points": [[0, 6.5], [2, 3.5, "bend"], [1, 2], [-1, 2], [-2, 3.5, "bend"]], )"
      R"("paint": "hair_line"})");
}

/// A pattern's points are the frame's, its lengths are scaled, and what turns as a plate is told so.
TEST_F(FlatFeatureTest, PatternsLieInTheirFrames) {
  const Flattened made = flatten(
      R"({"name": "a", "slot": "front", "role": "hair.line", "in": "eye", "kind": "scatter", "turn": {"plate": 0.3},
          "patch": [[[1, 2], {"xy": [1.5, 2], "turn": 0.2}], [[1, 4], [1.5, 4]]], "count": 9, "of": "stroke", "length": 0.1, "half_width": 0.01})",
      "soft", {{"size", 2}});
  ASSERT_EQ(made.all().size(), 1u);
  EXPECT_EQ(
      made.texts[0],
      R"({"name": "a", "kind": "scatter", "patch": [[[1, 2], [2, 2]], [[1, 5], [2, 5]]], "count": 9, "of": "stroke", )"
      R"("length": 0.175, "half_width": 0.0175, "paint": "hair_line"})");
  EXPECT_EQ(made.named(made.plates), (std::map<std::string, double>{{"a", 0.3}}));
  EXPECT_EQ(made.depths().at("a/patch/0/1"), 0.2);
  EXPECT_TRUE(made.raised.empty());
}

TEST_F(FlatFeatureTest, WidthsAndRadiiAreScaled) {
  const Flattened made = flatten(
      R"({"name": "a", "slot": "front", "role": "hair", "in": "eye", "kind": "stroke", "spine": [[1, 2], [1, 3], [1, 4]],
          "half_width": [0, {"is": 0.1, "adds": {"apart": 1}}, 0.2]},
         {"name": "b", "slot": "back", "role": "hair", "in": "eye", "kind": "ellipse", "center": [1, 2], "radii": [0.1, 0.2]})",
      "soft", {{"size", 2}});
  EXPECT_NE(made.texts[0].find(R"("half_width": [0, 0.175, 0.35])"), std::string::npos)
      << made.texts[0];
  EXPECT_NE(made.texts[1].find(R"("radii": [0.2, 0.3])"), std::string::npos) << made.texts[1];
}

TEST_F(FlatFeatureTest, DepthsAndRidesAreKept) {
  const Flattened made = flatten(
      R"({"name": "head", "slot": "back", "role": "skin", "in": "face", "kind": "path", "turn": 0,
          "points": [{"xy": [0.5, -1], "turn": 0.2}, [0, 1], [-0.5, -1]]},
         {"name": "beard", "slot": "front", "role": "hair", "in": "face", "kind": "path", "half": true, "turn": {"raised": 0.1},
          "points": [[0, 0], {"at": "chin", "plus": [0.1, 0]}, {"at": "chin", "plus": [0, -0.1]}]},
         {"name": "neck", "slot": "back", "role": "skin", "kind": "path", "turn": "still", "points": [[0, 0], [1, 0], [0, 1]]})");
  EXPECT_EQ(made.depths().at("head"), 0);
  EXPECT_EQ(made.depths().at("head/points/0"), 0.2);
  EXPECT_EQ(made.depths().at("beard/points/1"), 0.2);  // as deep as what it is beside
  EXPECT_EQ(made.named(made.raised), (std::map<std::string, double>{{"beard", 0.1}}));
  EXPECT_EQ(made.still(), std::vector<std::string_view>{"neck"});
  std::vector<Ride> rides;
  EXPECT_TRUE(made.for_each_ride("head/points/0", [&](const Ride& one) { rides.push_back(one); }));
  EXPECT_FALSE(made.for_each_ride("head/points/1", [](const Ride&) {}));
  ASSERT_EQ(rides.size(), 4u);
  EXPECT_EQ(rides[0].slice, "beard/points/1");
  EXPECT_EQ(rides[0].side, 1);
  EXPECT_EQ(rides[3].side, -1);
}

TEST_F(FlatFeatureTest, PatternsHaveBounds) {
  const auto pattern = [](const std::string& count) {
    return R"({"name": "a", "slot": "front", "role": "hair", "in": "face", "kind": "path",
      "points": [{"scallop": {"center": [0, 0], "radii": [1, 1], "from": 0, "to": 90, "bump": 0.1, "count": )" +
           count + "}}]}";
  };
  EXPECT_NE(flatten(pattern("3")).texts[0].find("\"bend\""), std::string::npos);
  EXPECT_THROW(flatten(pattern("1e9")), Refusal);
  EXPECT_THROW(flatten(pattern("0")), Refusal);
  EXPECT_THROW(flatten(pattern("-1e8")), Refusal);
}

TEST_F(FlatFeatureTest, SaysWhatIsWrong) {
  const char* feature =
      R"({"name": "a", "slot": "frnt", "role": "hair", "kind": "disc", "center": [0, 0], "radius": 1})";
  try {
    flatten(feature);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_NE(refusal.error.what.find("did you mean \"front\""), std::string::npos)
        << refusal.error.what;
  }
  const std::string good = test::with(feature, "frnt", "front");
  EXPECT_THROW(flatten(good + "," + good), Refusal);  // two of one name
}

TEST_F(FlatFeatureTest, StylesReplaceAndHide) {
  const char* features =
      R"({"name": "a", "slot": "front", "role": "hair", "kind": "disc", "center": [0, 0], "radius": 1, "paint": "dark"},
         {"name": "b", "slot": "front", "role": "shine", "kind": "disc", "center": [0, 0], "radius": 1, "opacity": 0.5})";
  const Flattened soft = flatten(features), ink = flatten(features, "ink");
  EXPECT_NE(soft.texts[0].find(R"("paint": "dark")"), std::string::npos);
  EXPECT_NE(ink.texts[0].find(R"("paint": "skin")"), std::string::npos);
  EXPECT_EQ(ink.texts[0].find("dark"), std::string::npos);
  EXPECT_EQ(ink.texts[1],
            R"({"name": "b", "kind": "disc", "center": [0, 0], "radius": 1, "opacity": 0.5})");
}

/// What makes a figure is known before it is drawn, and drawn as an area of itself where it stood.
TEST_F(FlatFeatureTest, AFigureIsKnownBeforeItIsDrawn) {
  const char* features =
      R"({"name": "a", "slot": "front", "role": "hair", "side": "left", "kind": "disc", "center": [0, 0], "radius": 1, "opacity": 0.5},
         {"name": "b", "slot": "front", "role": "none", "kind": "disc", "center": [0, 0], "radius": 1})";
  style_ =
      R"("figure": {"slots": ["front"], "before": "back", "clip": "b"}, "roles": {"hair": {"contour": {}}})";
  const Flattened made = flatten(features);
  ASSERT_EQ(made.texts.size(), 3u);
  EXPECT_EQ(made.texts[0],
            R"({"name": "a", "side": "left", "kind": "disc", "center": [0, 0], "radius": 1})");
  EXPECT_EQ(made.texts[1],
            R"({"name": "a_seen", "side": "left", "kind": "area", "any": ["a"], "clip": "b", )"
            R"("opacity": 0.5, "contour": {}, "paint": "hair"})");
  EXPECT_LT(made.all()[0].order, 1u);
  EXPECT_EQ(made.all()[1].order, 3u);
  EXPECT_EQ(made.texts[2].find("paint"), std::string::npos);
}

TEST_F(FlatFeatureTest, AHandMovesPointsAndWidthsAndNotWhatIsBesideThem) {
  const char* features =
      R"({"name": "a", "slot": "front", "role": "hair", "in": "face", "kind": "stroke", "spine": [[0.1, 0.2], [0, 1], [0, 2]], "half_width": [0.1, 0.1, 0.1]},
         {"name": "b", "slot": "back", "role": "hair", "in": "face", "kind": "disc", "center": {"at": "a/spine/0"}, "radius": 1})";
  style_ = R"("hand": {"amplitude": 0.02, "width": 0.3, "slots": ["front"]})";
  const Flattened made = flatten(features);
  EXPECT_EQ(made.texts[0].find("[0.1, 0.2]"), std::string::npos) << made.texts[0];
  EXPECT_EQ(made.texts[0].find("[0.1, 0.1, 0.1]"), std::string::npos) << made.texts[0];
  EXPECT_NE(made.texts[1].find("[0.1, 0.2]"), std::string::npos) << made.texts[1];
}

TEST_F(FlatFeatureTest, AreasOfRolesAreLists) {
  const char* features =
      R"({"name": "a", "slot": "back", "role": "hair", "kind": "disc", "center": [0, 0], "radius": 1},
         {"name": "all", "slot": "front", "role": "mass", "kind": "area", "any": {"roles": ["hair"]}},
         {"name": "none", "slot": "front", "role": "mass", "kind": "area", "any": {"roles": ["wool"]}})";
  const Flattened made = flatten(features);
  ASSERT_EQ(made.texts.size(), 2u) << "an area of nothing is left out";
  EXPECT_EQ(made.texts[1], R"({"name": "all", "kind": "area", "any": ["a"], "paint": "mass"})");
}

}  // namespace
}  // namespace mien
