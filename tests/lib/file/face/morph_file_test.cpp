// Items G1, G2, G5, G7: targets from pairs of faces, and what their weights do.

#include <gtest/gtest.h>

#include <mien/face_model.h>
#include <mien/morph_file.h>

#include "tests/support/faces/faces.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::face_named;
using test::posed;

Face with_other_numbers(const Face& face) {
  Face other = face;
  // Colours and the mouth: what rides on a lid is moved by the eye's laws besides.
  for (const Slice& slice : face.model->layout.slices())
    if (face.model->eyes.empty() || slice.name.starts_with("palette/") ||
        slice.name.starts_with("mouth") || slice.name.starts_with("lip"))
      for (int i = slice.begin; i < slice.begin + slice.size; i += 3)
        other.vector[std::size_t(i)] = 0.1 + 0.7 * other.vector[std::size_t(i)] / 3;
  apply_rules(other.model->layout, face.vector, other.vector);
  return other;
}

Face with_targets(const Face& rest, const std::vector<MorphTarget>& targets) {
  const auto text = morph_text(rest, targets);
  EXPECT_TRUE(text) << (text ? "" : text.error().what);
  const auto face = read_morphs_text(rest, *text);
  EXPECT_TRUE(face) << (face ? "" : sentence(face.error()));
  return *face;
}

// G1, G2: weight 0 is the rest face and weight 1 the target, bit for bit, through the file.
TEST(MorphFile, WeightsZeroAndOneAreBitForBit) {
  for (const char* name : {"toon", "seed0", "male"}) {
    const Face rest = face_named(name), target = with_other_numbers(rest);
    const Face face = with_targets(rest, {{"other", target}});
    EXPECT_EQ(posed(face, {"other=0"}).vector, rest.vector) << name;
    EXPECT_EQ(posed(face, {"other=1"}).vector, target.vector) << name;
  }
}

// G1: linear in each weight, and in sums; negative and large weights too.
TEST(MorphFile, WeightsAreLinearAndAddUp) {
  const Face rest = face_named("seed0");
  Face a = rest, b = rest;
  const auto lid =
      std::size_t(rest.model->layout[rest.model->layout.find("upper_lid.left/spine/1")].begin);
  a.vector[lid] += 0.25;
  a.vector[lid + 1] -= 0.5;
  b.vector[lid] -= 0.125;
  const Face face = with_targets(rest, {{"a", a}, {"b", b}});
  for (const double wa : {-2.0, 0.0, 0.6, 1.0, 3.5})
    for (const double wb : {-1.0, 0.0, 1.0, 2.0}) {
      const Face at = posed(face, {"a=" + std::to_string(wa), "b=" + std::to_string(wb)});
      EXPECT_NEAR(at.vector[lid], rest.vector[lid] + 0.25 * wa - 0.125 * wb, 1e-14);
      EXPECT_NEAR(at.vector[lid + 1], rest.vector[lid + 1] - 0.5 * wa, 1e-14);
    }
}

// G2: compact, and the order of targets is kept.
TEST(MorphFile, HoldsOnlyWhatDiffers) {
  const Face rest = face_named("toon");
  Face target = rest;
  target.vector[0] = 0.1;
  const auto text = morph_text(rest, {{"tint", target}, {"nothing", rest}});
  ASSERT_TRUE(text);
  EXPECT_LT(text->size(), 400u) << *text;
  EXPECT_NE(text->find("[0.1, "), std::string::npos) << *text;
}

// G7: colours cross-fade in linear light: half-way is the mean of the lights.
TEST(MorphFile, GenderCrossFadesColoursInLinearLight) {
  const Face rest = face_named("toon");
  const Face half = posed(rest, {"gender=0.5"}), whole = posed(rest, {"gender=1"});
  const Slice& hair = rest.model->layout[rest.model->layout.find("palette/hair")];
  for (int c = 0; c < 4; ++c) {
    const auto i = std::size_t(hair.begin + c);
    EXPECT_NEAR(half.vector[i], 0.5 * (rest.vector[i] + whole.vector[i]), 1e-15);
  }
  EXPECT_NE(rest.vector[std::size_t(hair.begin)], whole.vector[std::size_t(hair.begin)]);
}

// G5: the shipped targets, by name; each alone at weight 0 leaves the face as it is.
TEST(MorphFile, ShippedTargetsRestAtZero) {
  const Face rest = face_named("toon");
  for (const std::string name : {"ah", "smile", "fear", "gender"}) {
    EXPECT_EQ(posed(rest, {name + "=0"}).vector, rest.vector);
    EXPECT_NE(posed(rest, {name + "=0.6"}).vector, rest.vector);
  }
  EXPECT_NE(posed(rest, {"ah=0.4", "smile=0.6"}).vector, posed(rest, {"smile=0.6"}).vector);
}

TEST(MorphFile, RefusesWhatDoesNotFit) {
  const Face toon = face_named("toon"), male = face_named("male");
  EXPECT_EQ(
      morph_text(toon, {{"x", male}})
          .error()
          .what.find("\"x\" is another face, not this one in another shape: it has no \"palette/"),
      0u);
  EXPECT_FALSE(morph_text(toon, {{"x", toon}, {"x", toon}}));
  EXPECT_FALSE(morph_text(toon, {{"a/b", toon}}));
  EXPECT_FALSE(morph_text(toon, {{"smile", toon}}));  // the face has it already
  const char* const bads[] = {
      "",
      "{}",
      R"({"format": "mien-face", "format_version": 1, "poses": {}})",
      R"({"format": "mien-morphs", "format_version": 2, "poses": {}})",
      R"({"format": "mien-morphs", "format_version": 1, "poses": {"a": {"slices": {"nose": [1]}}}})",
      R"({"format": "mien-morphs", "format_version": 1, "poses": {"a": {"slices": {"eye.left/points/0": [1]}}}})"};
  for (const char* bad : bads) EXPECT_FALSE(read_morphs_text(male, bad)) << bad;
  const auto unknown = read_morphs_text(male, bads[4], "a.json");
  EXPECT_EQ(unknown.error().where, "a.json:1:83: /poses/a/slices/nose") << unknown.error().what;
  EXPECT_FALSE(read_morphs(male, "/none.json"));
}

}  // namespace
}  // namespace mien
