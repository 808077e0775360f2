// Every standard name does what the table of names says, on the sample faces and on people of all kinds.

#include "lib/face/standard_moves.h"

#include <mien/composed_face.h>
#include <mien/poser.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lib/face/standard_names.h"
#include "lib/file/json/reading.h"
#include "tests/support/faces/posing.h"

namespace mien {
namespace {

struct MoveWay {
  std::string landmark, way;
  double least, most;
};

struct MoveRow {
  std::string name;
  std::vector<std::string> with;  ///< as --set takes it
  std::vector<MoveWay> ways;
  std::set<std::string> kinds;
};

struct MoveTable {
  std::map<std::string, std::vector<std::string>> landmarks;  ///< one slice, or two of a gap
  std::vector<MoveRow> rows;
};

MoveTable read_table() {
  const JsonTree tree = JsonTree::read(standard_moves(), "standard_moves.json", {}).value();
  const FaceLimits limits;
  const Reading in(tree, limits, nullptr);
  MoveTable table;
  in.for_each(in.need(tree.root(), "landmarks"), [&](const JsonNode& node, int) {
    std::vector<std::string>& slices = table.landmarks[std::string(tree.key(node))];
    if (node.kind == JsonKind::string) return slices.push_back(std::string(in.string(node)));
    in.for_each(node,
                [&](const JsonNode& one, int) { slices.push_back(std::string(in.string(one))); });
  });
  in.for_each(in.need(tree.root(), "moves"), [&](const JsonNode& node, int) {
    MoveRow row{.name = std::string(tree.key(node))};
    if (const JsonNode* with = in.find(node, "with"))
      in.for_each(*with, [&](const JsonNode& one, int) {
        row.with.push_back(fmt::format("{}={}", tree.key(one), in.number(one)));
      });
    in.for_each(in.need(node, "moves"), [&](const JsonNode& landmark, int) {
      in.for_each(landmark, [&](const JsonNode& way, int) {
        const std::vector<double> range = in.numbers(way, 2, 2);
        row.ways.push_back(
            {std::string(tree.key(landmark)), std::string(tree.key(way)), range[0], range[1]});
      });
    });
    in.for_each(in.need(node, "of"),
                [&](const JsonNode& kind, int) { row.kinds.insert(std::string(in.string(kind))); });
    table.rows.push_back(std::move(row));
  });
  return table;
}

const MoveTable& table() {
  static const MoveTable read = read_table();
  return read;
}

std::vector<double> numbers(const Face& face, const std::string& slice) {
  return test::slice_of(face, slice);
}

/// How far a landmark goes a way.
double moved(const MoveWay& way, const Face& before, const Face& after) {
  const std::vector<std::string>& slices = table().landmarks.at(way.landmark);
  if (way.way == "apart")
    return glm::distance(test::point_of(after, slices[0]), test::point_of(after, slices[1]));
  const std::vector<double> a = numbers(before, slices[0]), b = numbers(after, slices[0]);
  if (way.way == "shown") return b[0];
  if (way.way == "thick" || way.way == "thin") return b[0] / a[0];
  const double dx = b[0] - a[0], dy = b[1] - a[1], out = a[0] >= 0 ? dx : -dx;
  if (way.way == "up") return dy;
  if (way.way == "down") return -dy;
  if (way.way == "left") return dx;
  if (way.way == "right") return -dx;
  if (way.way == "out") return out;
  if (way.way == "in") return -out;
  throw std::runtime_error("no way called " + way.way);
}

/// What is wrong with a name's row on a face, or nothing.
std::string wrong(const MoveRow& row, Poser& poser, const Face& face) {
  std::vector<std::string> words{"emotion.joy=0"};
  words.insert(words.end(), row.with.begin(), row.with.end());
  const Face before = poser.pose(test::pose_of(face, words));
  words.push_back(row.name + "=1");
  const Face& after = poser.pose(test::pose_of(face, words));
  for (const MoveWay& way : row.ways)
    if (const double by = moved(way, before, after); !(by >= way.least && by <= way.most))
      return fmt::format("{} goes {} {} of [{}, {}]", way.landmark, by, way.way, way.least,
                         way.most);
  for (const auto& [landmark, slices] : table().landmarks)
    if (!row.kinds.contains(landmark.substr(0, landmark.find('.'))))
      for (const std::string& slice : slices)
        if (numbers(before, slice) != numbers(after, slice)) return landmark + " does not stay";
  return {};
}

TEST(StandardMoves, HasARowForEveryName) {
  std::set<std::string> rows;
  for (const MoveRow& row : table().rows) rows.insert(row.name);
  for (const std::string_view set : {"arkit", "facs", "vrm", "viseme", "azure"})
    for (const std::string_view name : standard_names(set))
      EXPECT_TRUE(rows.contains(fmt::format("{}.{}", set, name))) << set << " " << name;
  EXPECT_EQ(rows.size(), 52u + 46 + 18 + 15 + 22);
}

void expect_moves(const Face& face, const std::string& who) {
  Poser poser(face);
  for (const MoveRow& row : table().rows)
    EXPECT_EQ(wrong(row, poser, face), "") << who << " " << row.name;
}

TEST(StandardMoves, OfTheSampleFacesAreTheTables) {
  for (const char* name : {"toon", "bruno", "clay"})
    expect_moves(test::sample_face(std::string("faces/") + name), name);
}

bool has_shut_lips(const Face& face) {
  const Mouth& mouth = *face.model->mouth;
  const auto numbers_of = [&](const MouthPoint& bend) {
    return numbers(face, std::string(face.model->layout[bend.slice].name));
  };
  return numbers_of(mouth.upper[1]) == numbers_of(mouth.lower[1]) &&
         numbers(face, "lip_upper.left/half_width")[0] > 0 &&
         numbers(face, "lip_lower.left/half_width")[0] > 0;
}

TEST(StandardMoves, OfFiftyPeopleAreTheTables) {
  for (int i = 0; i < 50; ++i) {
    Recipe recipe = recipe_from_seed(seed_from_word(fmt::format("moves of people/{}", i)));
    // The tables are of lips that rest shut: from a gap on, the same moves are others.
    if (!has_shut_lips(face_from_recipe(recipe).value())) recipe.parts["mouth"] = "soft";
    expect_moves(face_from_recipe(recipe).value(), recipe.code);
  }
}

/// The test sees a name that does another's work.
TEST(StandardMoves, AreNotThoseOfOtherNames) {
  const Face face = test::sample_face("faces/toon");
  Poser poser(face);
  for (MoveRow row : table().rows)
    if (row.name == "arkit.mouthSmileLeft") {
      row.name = "arkit.mouthSmileRight";
      EXPECT_NE(wrong(row, poser, face), "");
      row.name = "arkit.eyeBlinkLeft", row.ways.clear();
      EXPECT_TRUE(wrong(row, poser, face).starts_with("lid.")) << wrong(row, poser, face);
    }
}

}  // namespace
}  // namespace mien
