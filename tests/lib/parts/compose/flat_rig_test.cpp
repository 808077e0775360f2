// Where a muscle stops: at its own stroke, or where there is no more room.

#include "lib/parts/compose/flat_rig.h"

#include <gtest/gtest.h>

#include "lib/file/json/json_copy.h"
#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

using test::SmallLibrary;

/// The stroke of a muscle with this room, of a head 1 wide with its chin at (0.5, −1), pulled up from
/// the nose; −1: refused.
double stroke_with(const std::string& room, std::map<std::string, double> numbers = {}) {
  SmallLibrary small;
  small.topology =
      test::with(small.topology, "\"features\": []",
                 R"("features": [], "muscles": {"stiffness": 20, "damping": 8, "groups": [
         {"name": "lift", "strength": 60, "stroke": 0.5, "origin": [0, 30], "attach": {}, "in": "face")" +
                     room + "}]}");
  const auto library = small.read().value();
  const Recipe recipe{.name = {}, .code = {}, .parts = {}, .numbers = std::move(numbers)};
  PartGeometry geometry(*library, recipe);
  geometry.add_point("lip", {{0.1, -0.4}, {}, {}});
  geometry.add_point("nose.base", {{0.3, -0.3}, {}, {}});
  geometry.add_value("lip.half", 0.02);
  const LibraryNode& topology = library->topology();
  try {
    JsonTree tree("muscles");
    TreeWriter out(tree);
    write_muscles(topology.in(), topology.in().need(*topology.node, "muscles"), geometry,
                  FlatFeatures{}, nullptr, out);
    std::string text;
    add_json(tree, tree.nodes[0], text);
    const std::string key = "\"stroke\": ";
    return std::stod(text.substr(text.find(key) + key.size()));
  } catch (const Refusal&) {
    return -1;
  }
}

std::string room(const std::string& more) {
  return R"(, "room": {"from": {"at": "lip"}, "to": {"at": "nose.base"}, )" + more + "}";
}

TEST(FlatRig, AMuscleStopsWhereThereIsNoMoreRoom) {
  EXPECT_DOUBLE_EQ(stroke_with(""), 0.5);
  EXPECT_NEAR(stroke_with(room(R"("less": 0, "times": 1, "least": 0)")), 0.1, 1e-6) << "upwards";
  EXPECT_NEAR(stroke_with(room(R"("less": 0.04, "times": 2, "least": 0)")), 0.12, 1e-6);
  EXPECT_NEAR(stroke_with(room(R"("less": 0.2, "times": 2, "least": 0.03)")), 0.03, 1e-6);
  EXPECT_DOUBLE_EQ(stroke_with(room(R"("less": -9, "times": 1, "least": 0)")), 0.5);
}

TEST(FlatRig, RoomGoesOutwardsToo) {
  EXPECT_NEAR(stroke_with(room(R"("along": "x", "less": 0, "times": 1, "least": 0)")), 0.2, 1e-6);
  EXPECT_NEAR(stroke_with(room(R"("along": "y", "less": 0, "times": 1, "least": 0)")), 0.1, 1e-6);
  EXPECT_EQ(stroke_with(room(R"("along": "z", "less": 0, "times": 1, "least": 0)")), -1);
}

TEST(FlatRig, ThickLipsLeaveLessRoom) {
  const std::string thick =
      room(R"("less": {"of": "lip.half", "adds": {"size": 0.03}}, "times": 1, "least": 0)");
  EXPECT_NEAR(stroke_with(thick), 0.08, 1e-6);
  EXPECT_NEAR(stroke_with(thick, {{"size", 2}}), 0.05, 1e-6);
}

/// The text of what is written for an object of the rig.
std::string rig_text(const std::string& node, const FlatFeatures& features) {
  SmallLibrary small;
  small.topology =
      test::with(small.topology, "\"features\": []", "\"features\": [], \"rig\": " + node);
  const auto library = small.read().value();
  const PartGeometry geometry(*library, {.name = {}, .code = {}, .parts = {}, .numbers = {}});
  const LibraryNode& topology = library->topology();
  JsonTree tree("rig");
  TreeWriter out(tree);
  try {
    write_rig(topology.in(), topology.in().need(*topology.node, "rig"),
              {*library, geometry, features}, out);
  } catch (const Refusal& refusal) {
    return refusal.error.what;
  }
  std::string text;
  add_json(tree, tree.nodes[0], text);
  return text;
}

TEST(FlatRig, AControlMovesWhatStandsStillInItsSlots) {
  FlatFeatures features;
  features.add({1, 0, "shirt"}), features.add({0, 0, "halo"});
  features.add({1, 0, "hair"}), features.add({1, 0, "collar"});
  for (const char* still : {"halo", "shirt", "collar"}) features.stand_still(still);
  features.sort();
  EXPECT_EQ(rig_text(R"({"offset": {"$still": [0, 1], "slots": ["front"]}})", features),
            R"({"offset": {"shirt/*": [0, 1], "collar/*": [0, 1]}})");
  EXPECT_EQ(rig_text(R"({"offset": {"$still": [0, 1], "slots": ["fornt"]}})", features),
            "no slot named \"fornt\"; did you mean \"front\"?");
}

}  // namespace
}  // namespace mien
