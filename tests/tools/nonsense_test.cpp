// The nonsense test finds what is planted, and nothing where nothing is.

#include "tools/mien/people/nonsense.h"
#include <mien/composed_face.h>
#include <mien/face_code.h>
#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>

#include "tests/support/faces/posing.h"

namespace mien {
namespace {

using Move = std::function<glm::dvec2(glm::dvec2)>;

/// Moves every point whose name begins so.
void move_points(Face& face, std::string_view begin, const Move& move) {
  int moved = 0;
  for (const Slice& slice : face.model->layout.slices())
    if (slice.kind == SliceKind::point && slice.name.starts_with(begin)) {
      double* at = &face.vector[std::size_t(slice.begin)];
      const glm::dvec2 to = move({at[0], at[1]});
      at[0] = to.x, at[1] = to.y, ++moved;
    }
  ASSERT_GT(moved, 0) << begin;
}

Move by(double x, double y) {
  return [=](glm::dvec2 p) { return p + glm::dvec2{x, y}; };
}

void copy_slice(Face& face, std::string_view from, std::string_view to) {
  const Layout& layout = face.model->layout;
  const Slice &a = layout[layout.find(from)], &b = layout[layout.find(to)];
  for (int i = 0; i < a.size; ++i)
    face.vector[std::size_t(b.begin + i)] = face.vector[std::size_t(a.begin + i)];
}

Recipe bearded() {
  return {
      .name = "planted",
      .code = {},
      .parts = {{"hair", "side_part"}, {"glasses", "round"}, {"beard", "full"}, {"ears", "round"}},
      .numbers = {}};
}

NonsensePose named(const Face& face, const std::string& name) {
  for (NonsensePose& pose : nonsense_poses(face))
    if (pose.name == name) return pose;
  throw std::runtime_error("no pose " + name);
}

std::set<std::string> names_of(const std::vector<NonsenseFault>& faults) {
  std::set<std::string> names;
  for (const NonsenseFault& fault : faults) names.insert(std::string(fault.check));
  return names;
}

class Nonsense : public testing::Test {
 protected:
  std::set<std::string> found(const Face& posed, const NonsensePose& pose = {}) const {
    std::set<std::string> names;
    for (const NonsenseFault& fault : test_.faults(face_, posed, pose)) {
      EXPECT_EQ(fault.pose, pose.name);
      names.insert(std::string(fault.check));
    }
    return names;
  }
  std::set<std::string> after(std::string_view begin, const Move& move) const {
    Face posed = face_;
    move_points(posed, begin, move);
    return found(posed);
  }

  const NonsenseTest test_;
  const Face face_ = *face_from_recipe(bearded());
};

TEST_F(Nonsense, IsSilentOnAGoodFace) {
  EXPECT_EQ(found(face_), std::set<std::string>{});
  const NonsensePose joy = named(face_, "emotion.joy=1");
  EXPECT_EQ(found(pose_face(face_, joy.pose), joy), std::set<std::string>{});
}

TEST_F(Nonsense, FindsLidsThatDoNotMeet) {
  const NonsensePose shut = named(face_, "blink=1");
  Face posed = pose_face(face_, shut.pose);
  EXPECT_EQ(found(posed, shut), std::set<std::string>{});
  move_points(posed, "opening.left/upper", by(0, 0.02));
  EXPECT_TRUE(found(posed, shut).contains("lids_meet"));
}

TEST_F(Nonsense, FindsAMouthThatDoesNotSpeak) {
  const NonsensePose shut = named(face_, "emotion.joy=1 arkit.jawOpen=0.6 arkit.mouthClose=0.6");
  const NonsensePose bitten = named(face_, "emotion.anger=1 viseme.FF=1");
  EXPECT_EQ(found(pose_face(face_, shut.pose), shut), std::set<std::string>{});
  EXPECT_EQ(found(pose_face(face_, bitten.pose), bitten), std::set<std::string>{});
  Face posed = pose_face(face_, shut.pose);
  move_points(posed, "lower_edge.left/spine/1", by(0, -1e-9));
  EXPECT_EQ(found(posed, shut), std::set<std::string>{"lips_close"});
  posed = pose_face(face_, shut.pose);
  for (const char* lip : {"lip_lower.left", "lip_lower.right", "lip_upper.left", "lip_upper.right"})
    copy_slice(posed, "lip_light/half_width", std::string(lip) + "/half_width");
  EXPECT_TRUE(found(posed, shut).contains("lips_close")) << "lines for lips";
  posed = pose_face(face_, shut.pose);
  for (const char* point : {"head/points/4", "head/points/5", "head/points/6", "head/points/7"})
    move_points(posed, point, by(0, 0.08));
  EXPECT_TRUE(found(posed, shut).contains("chin_follows"));
  posed = pose_face(face_, bitten.pose);
  move_points(posed, "lower_edge", by(0, -0.03));
  EXPECT_EQ(found(posed, bitten), std::set<std::string>{"teeth_touch"});
}

TEST_F(Nonsense, FindsFeaturesOutOfPlace) {
  EXPECT_TRUE(after("limbus.left/center", by(0.3, 0)).contains("pupil_in_opening"));
  EXPECT_TRUE(after("opening.left/outer", by(0.25, 0)).contains("eye_in_head"));
  EXPECT_TRUE(after("opening.left/inner", by(-0.15, 0)).contains("eyes_apart"));
  EXPECT_TRUE(after("lip_lower.left/spine/0", by(0, -0.4)).contains("mouth_in_head"));
  EXPECT_TRUE(after("lip_upper", by(0, 0.2)).contains("lip_below_nose"));
  EXPECT_TRUE(after("lip_upper", by(0, 0.6)).contains("lip_below_nose")) << "far above it";
  EXPECT_TRUE(after("brow.right", by(0, -0.18)).contains("brow_above_lid"));
  EXPECT_TRUE(after("brow.right", by(0, -0.6)).contains("brow_above_lid")) << "far below it";
  EXPECT_TRUE(after("brow", by(0, 0.25)).contains("brow_seen"));
}

TEST_F(Nonsense, FindsHairAndWhatIsWornOutOfPlace) {
  EXPECT_TRUE(after("hair_", [](glm::dvec2 p) { return 0.5 * p; }).contains("scalp_covered"));
  EXPECT_TRUE(after("hair_", [](glm::dvec2 p) {
                return glm::dvec2{0.6 * p.x, p.y};
              }).contains("hairline_overlaps"));
  EXPECT_TRUE(after("ear.left", by(0.4, 0)).contains("ear_rooted"));
  EXPECT_TRUE(after("lens.left", by(0.3, 0)).contains("pupil_in_lens"));
  EXPECT_TRUE(after("rim.left", by(0, 0.35)).contains("arm_joined"));
  EXPECT_TRUE(after("beard", by(0, 0.2)).contains("beard_on_chin"));
  EXPECT_TRUE(after("hair_front", by(0, 0.4)).contains("in_canvas"));
  EXPECT_TRUE(after("ear.left", [](glm::dvec2 p) {
                return glm::dvec2{1 - p.x, p.y};
              }).contains("no_loops"));
}

TEST_F(Nonsense, FindsAnEarOutsideAScarf) {
  Recipe recipe = bearded();
  recipe.parts["headwear"] = "beanie";
  std::string text = *face_text_from_recipe(recipe);
  const std::string hat = "\"beanie\"";
  text.replace(text.find(hat), hat.size(), "\"hijab\"");  // a scarf as short as a hat
  for (std::size_t at; (at = text.find("\"beanie")) != std::string::npos;)
    text.replace(at, 7, "\"hijab");
  const Expected<Face> face = read_face_text(text, "short scarf");
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(names_of(test_.faults(*face, *face, {})).contains("ear_hidden"));
}

TEST_F(Nonsense, FindsColoursThatAreAlike) {
  Face posed = face_;
  copy_slice(posed, "palette/skin", "palette/cloth");
  EXPECT_EQ(found(posed), std::set<std::string>{"colours"});
  copy_slice(posed = face_, "palette/skin", "palette/line");
  EXPECT_EQ(found(posed), std::set<std::string>{"colours"});
}

TEST_F(Nonsense, LetsInkGiveAllThingsOneColourButLines) {
  Recipe recipe = bearded();
  recipe.style = "ink";
  const Face drawn = *face_from_recipe(recipe);
  Face posed = drawn;
  copy_slice(posed, "palette/skin", "palette/cloth");
  EXPECT_EQ(names_of(test_.faults(drawn, posed, {})), std::set<std::string>{});
  copy_slice(posed, "palette/skin", "palette/line");
  EXPECT_EQ(names_of(test_.faults(drawn, posed, {})), std::set<std::string>{"colours"});
}

TEST_F(Nonsense, KnowsShornHairInEveryStyle) {
  Recipe recipe = bearded();
  recipe.parts["hair"] = "buzz", recipe.parts["headwear"] = "bucket";
  recipe.style = "ink";
  const Face drawn = *face_from_recipe(recipe);
  const NonsensePose turned = named(drawn, "yaw=-30 pitch=25");
  EXPECT_EQ(names_of(test_.faults(drawn, pose_face(drawn, turned.pose), turned)),
            std::set<std::string>{});
}

/// Where a style draws several features as one area, each of them hides what lies below it.
TEST_F(Nonsense, SeesHairThatIsDrawnAsOneArea) {
  Recipe recipe = bearded();
  recipe.style = "pictogram";
  const Face drawn = *face_from_recipe(recipe);
  EXPECT_EQ(names_of(test_.faults(drawn, drawn, {})), std::set<std::string>{});
  Face posed = drawn;
  move_points(posed, "hair_", [](glm::dvec2 p) { return 0.5 * p; });
  EXPECT_TRUE(names_of(test_.faults(drawn, posed, {})).contains("scalp_covered"));
}

/// The edge round a figure is drawn below it, though it comes after what it goes round.
TEST_F(Nonsense, TellsAStickersEdgeFromItsHair) {
  Recipe recipe = bearded();
  recipe.style = "sticker";
  const Face drawn = *face_from_recipe(recipe);
  const NonsensePose turned = named(drawn, "yaw=-30");
  Face posed = pose_face(drawn, turned.pose);
  EXPECT_EQ(names_of(test_.faults(drawn, posed, turned)), std::set<std::string>{});
  move_points(posed, "hair_", [](glm::dvec2 p) { return 0.5 * p; });
  EXPECT_TRUE(names_of(test_.faults(drawn, posed, turned)).contains("scalp_covered"));
}

TEST_F(Nonsense, FindsAFeelingThatReadsAsAnother) {
  NonsensePose joy = named(face_, "emotion.joy=1");
  const Face angry = pose_face(face_, named(face_, "emotion.anger=1").pose);
  joy.lowers_brow = true;
  EXPECT_TRUE(found(angry, joy).contains("reads"));
}

/// A fade grows thinner towards the skin, so it has no edge there; skin between it and the outline is
/// seen all the same.
TEST_F(Nonsense, FindsAFadeBesideTheOutlineAlone) {
  Recipe recipe = bearded();
  recipe.parts["hair"] = "fade";
  const Face face = *face_from_recipe(recipe);
  const NonsensePose turned = named(face, "yaw=-30 pitch=-25");
  Face posed = pose_face(face, turned.pose);
  EXPECT_EQ(names_of(test_.faults(face, posed, turned)), std::set<std::string>{});
  posed = face;
  EXPECT_EQ(names_of(test_.faults(face, posed, {})), std::set<std::string>{});
  move_points(posed, "side_fade", [](glm::dvec2 p) { return glm::dvec2{0.92 * p.x, p.y}; });
  EXPECT_TRUE(names_of(test_.faults(face, posed, {})).contains("hairline_overlaps"));
}

/// What is painted as skin hides no skin, but it hides a brow.
TEST_F(Nonsense, FindsABrowUnderSkin) {
  Recipe recipe = bearded();
  recipe.parts["headwear"] = "cap";
  std::string text = *face_text_from_recipe(recipe);
  const std::string paint = "\"paint\": \"accent\"";
  text.replace(text.find(paint, text.find("\"name\": \"visor\"")), paint.size(),
               "\"paint\": \"skin_shade\"");
  const Face face = read_face_text(text, "skin visor").value();
  EXPECT_EQ(names_of(test_.faults(face, face, {})), std::set<std::string>{});
  Face posed = face;
  move_points(posed, "visor", by(0, -0.12));
  EXPECT_TRUE(names_of(test_.faults(face, posed, {})).contains("brow_seen"));
}

TEST_F(Nonsense, FindsNothingInPeople) {
  constexpr int kPeople = 12;
  for (int i = 0; i < kPeople; ++i) {
    const Recipe recipe = recipe_from_seed(seed_from_word("nonsense/" + std::to_string(i)));
    for (const NonsenseFault& fault : test_.faults(*face_from_recipe(recipe)))
      ADD_FAILURE() << recipe.code << " " << fault.check << " at " << fault.pose << ", "
                    << fault.what << ": " << fault.measured << ", allowed " << fault.allowed;
  }
}

/// Hats on bald heads: whatever they leave bare is seen.
TEST_F(Nonsense, FindsNothingUnderHats) {
  for (const char* hat : {"cap", "beanie", "turban", "headscarf", "hijab"}) {
    Recipe recipe = bearded();
    recipe.parts["hair"] = "bald", recipe.parts["headwear"] = hat;
    for (const NonsenseFault& fault : test_.faults(*face_from_recipe(recipe)))
      ADD_FAILURE() << hat << " " << fault.check << " at " << fault.pose << ", " << fault.what
                    << ": " << fault.measured << ", allowed " << fault.allowed;
  }
}

TEST_F(Nonsense, FindsNothingInTheSampleRecipes) {
  for (const char* name : {"faces/toon", "faces/bruno", "faces/clay"})
    for (const NonsenseFault& fault : test_.faults(test::sample_face(name)))
      ADD_FAILURE() << name << " " << fault.check << " at " << fault.pose << ", " << fault.what
                    << ": " << fault.measured << ", allowed " << fault.allowed;
}

TEST_F(Nonsense, TakesFacesThatLackFeatures) {
  for (const char* name : {"seed0", "male"}) test_.faults(test::sample_face(name));
}

TEST_F(Nonsense, NamesEachCheckOnce) {
  std::set<std::string_view> names;
  for (const NonsenseCheck& check : nonsense_checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.says.empty());
  }
}

}  // namespace
}  // namespace mien
