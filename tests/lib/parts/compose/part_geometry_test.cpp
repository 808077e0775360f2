#include "lib/parts/compose/part_geometry.h"

#include <gtest/gtest.h>

#include "tests/support/faces/small_library.h"

namespace mien {
namespace {

class PartGeometryTest : public testing::Test {
 protected:
  /// The point that a text says, in the frame "eye" of a face with these numbers.
  FoundPoint point(const std::string& text, std::map<std::string, double> numbers = {}) {
    const Recipe recipe{.name = {}, .code = {}, .parts = {}, .numbers = std::move(numbers)};
    PartGeometry& geometry = geometry_.emplace(*library_, recipe);
    geometry.add_point("head/points/0", {{0.5, -1}, 0.2, true});
    geometry.add_value("width", 0.25);
    text_ = R"({"frame": "eye", "point": )" + text + "}";
    const auto tree = JsonTree::read(text_, "test", limits_);
    const Reading in(*tree, limits_, nullptr);
    const PartFrame frame = geometry.frame(in, in.need(tree->root(), "frame"));
    return geometry.point(in, in.need(tree->root(), "point"), frame, "nose");
  }

  glm::dvec2 pair(const std::string& text, std::map<std::string, double> numbers = {}) {
    point("[0, 0]", std::move(numbers));
    text_ = R"({"pair": )" + text + "}";
    const auto tree = JsonTree::read(text_, "test", limits_);
    const Reading in(*tree, limits_, nullptr);
    return geometry_->pair(in, in.need(tree->root(), "pair"), "nose");
  }

  const std::unique_ptr<PartLibrary> library_ = test::SmallLibrary{}.read().value();
  std::optional<PartGeometry> geometry_;  // points have its names
  FaceLimits limits_;
  std::string text_;
};

TEST_F(PartGeometryTest, PointsAreInTheirFrame) {
  EXPECT_EQ(point("[1.5, 3]").at, glm::dvec2(1.5, 3));
  EXPECT_EQ(point("[1.5, 3]", {{"size", 2}}).at, glm::dvec2(2, 3.5));
  EXPECT_EQ(point("[1.5, 3]", {{"apart", 0.25}}).at, glm::dvec2(1.75, 3));
}

TEST_F(PartGeometryTest, TheRightSideIsTheLeftOnesImage) {
  EXPECT_EQ(point("[-1.5, 3]", {{"size", 2}}).at, glm::dvec2(-2, 3.5));
  EXPECT_EQ(point("[0, 3]", {{"size", 2}}).at, glm::dvec2(0, 3.5));
}

TEST_F(PartGeometryTest, NumbersCountFromTheirRest) {
  const char* text = R"({"xy": [1, 2], "adds": {"length": [1, 10]}})";
  EXPECT_EQ(point(text).at, glm::dvec2(1, 2));
  EXPECT_EQ(point(text, {{"nose.length", 0.75}}).at, glm::dvec2(1.25, 4.5));
}

TEST_F(PartGeometryTest, RadiiGrowWithNumbersByTheirPartsRadius) {
  const char* text = R"({"radius": "width", "times": [1, 2], "adds": {"size": [0.5, 1]}})";
  EXPECT_EQ(pair(text), glm::dvec2(0.25, 0.5));
  EXPECT_EQ(pair(text, {{"size", 2}}), glm::dvec2(0.375, 0.75));
}

// Hair rises with the forehead at its edge and not at its top.
TEST(PartLift, RisesAndDiesAway) {
  const PartLift crown{.by = 0.1, .from = -0.1, .to = 0.5, .ends = {}};
  EXPECT_EQ(crown.at(-0.2), 0);
  EXPECT_NEAR(crown.at(0.2), 0.05, 1e-15);
  EXPECT_EQ(crown.at(3), 0.1);
  const PartLift forehead{.by = 0.04, .from = 0.1, .to = 0.4, .ends = std::pair{0.5, 0.7}};
  EXPECT_EQ(forehead.at(0.1), 0);
  EXPECT_EQ(forehead.at(0.45), 0.04);
  EXPECT_NEAR(forehead.at(0.6), 0.02, 1e-15);
  EXPECT_EQ(forehead.at(0.9), 0);
  const PartFrame frame{.lifts = {crown, forehead}};
  EXPECT_NEAR(frame.place({0.3, 0.6}).y, 0.6 + 0.1 + 0.02, 1e-15);
}

TEST_F(PartGeometryTest, BesidePointsOfTheFaceAndWithThem) {
  const FoundPoint found = point(R"({"at": "chin", "plus": [0.1, 0]})", {{"size", 2}});
  EXPECT_NEAR(found.at.x, 0.7, 1e-15);
  EXPECT_EQ(found.at.y, -1);
  EXPECT_EQ(found.depth, 0.2);
  ASSERT_EQ(geometry_->rides(found).size(), 1u);
  EXPECT_EQ(geometry_->rides(found)[0].slice, "head/points/0");
  const FoundPoint half =
      point(R"({"at": {"chin": 0.5}, "plus": [0, 1], "rides": {"chin": 0.9}, "turn": 0.7})");
  EXPECT_EQ(half.at, glm::dvec2(0.25, 0.5));
  EXPECT_EQ(half.depth, 0.7);
  ASSERT_EQ(geometry_->rides(half).size(), 1u) << "instead of what it is beside";
  EXPECT_EQ(geometry_->rides(half)[0].weight, 0.9);
}

TEST_F(PartGeometryTest, BesideSeveralPointsAndWithEachOfThem) {
  point("[0, 0]");
  geometry_->add_point("tip", {{0.1, 0.2}, {}, true});
  geometry_->add_point("loose", {{1, 1}, {}, false});
  geometry_->add_point("tip", {{0.3, 0.2}, {}, true});  // stands for the one before
  const std::string text = R"({"at": {"tip": 0.5, "loose": 0.25, "chin": 0.25}})";
  const auto tree = JsonTree::read(text, "test", limits_);
  const FoundPoint found =
      geometry_->point(Reading(*tree, limits_, nullptr), tree->root(), PartFrame{}, "nose");
  EXPECT_EQ(found.at,
            0.5 * glm::dvec2(0.3, 0.2) + 0.25 * glm::dvec2(1, 1) + 0.25 * glm::dvec2(0.5, -1));
  ASSERT_EQ(geometry_->rides(found).size(), 2u) << "what is no slice takes nothing along";
  EXPECT_EQ(geometry_->rides(found)[0].slice, "tip");
  EXPECT_EQ(geometry_->rides(found)[1].weight, 0.25);
}

TEST_F(PartGeometryTest, NumbersStayWithinTheirLimits) {
  const auto scalar = [&](const std::string& text, std::map<std::string, double> numbers = {}) {
    point("[0, 0]", std::move(numbers));
    const auto tree = JsonTree::read(text, "test", limits_);
    return geometry_->scalar(Reading(*tree, limits_, nullptr), tree->root(), "nose");
  };
  const char* text = R"({"is": 2, "adds": {"size": 3}, "least": 1, "most": 4})";
  EXPECT_EQ(scalar(text), 2);
  EXPECT_EQ(scalar(text, {{"size", 1.5}}), 3.5);
  EXPECT_EQ(scalar(text, {{"size", 0.5}}), 1);
  EXPECT_EQ(scalar(text, {{"size", 2}}), 4);
}

TEST_F(PartGeometryTest, UnknownNamesHaveANearestOne) {
  const auto what = [&](const std::string& text) -> std::string {
    try {
      point(text);
    } catch (const Refusal& refusal) {
      return refusal.error.where + ": " + refusal.error.what;
    }
    return "read";
  };
  EXPECT_NE(what(R"({"at": "chn"})").find("did you mean \"chin\""), std::string::npos);
  EXPECT_NE(what(R"({"xy": [0, 0], "adds": {"sise": [1, 0]}})").find("did you mean \"size\""),
            std::string::npos);
  EXPECT_NE(what(R"({"xy": [0, 0], "ads": {"size": [1, 0]}})").find("did you mean \"adds\""),
            std::string::npos);
  EXPECT_NE(what(R"({"radius": "widht", "times": [1, 1]})").find("did you mean \"width\""),
            std::string::npos);
}

}  // namespace
}  // namespace mien
