#include <mien/composed_face.h>
#include <mien/face_edit.h>
#include <mien/face_model.h>
#include <mien/face_pointers.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "lib/parts/recipe/recipe_file.h"
#include "tests/support/faces/face_path.h"
#include "tests/support/faces/face_text.h"
#include "tests/support/random/random.h"

namespace mien {
namespace {

using test::face_with;

std::string file_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// All sample faces in full: those that are, and the recipes put together.
std::vector<std::pair<std::string, std::string>> samples() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string name : {"seed0", "toon", "male", "bruno", "clay"})
    all.emplace_back(name, file_text(test::face_path(name)));
  for (const std::string name : {"faces/toon", "faces/bruno", "faces/clay"}) {
    const auto recipe = read_recipe_file(test::face_path(name));
    EXPECT_TRUE(recipe) << (recipe ? "" : sentence(recipe.error()));
    const auto text = face_text_from_recipe(*recipe);
    EXPECT_TRUE(text) << (text ? "" : sentence(text.error()));
    all.emplace_back(name, *text);
  }
  return all;
}

/// Other numbers, with which a face is still one: what must not be larger or smaller than something else stays so.
std::vector<double> other_numbers(const Slice& slice, std::vector<double> values, int salt) {
  for (double& value : values) {
    switch (slice.kind) {
      case SliceKind::length:
        value *= 1.01;
        break;
      case SliceKind::ratio:
        value *= 0.99;
        break;
      case SliceKind::angle:
        value = value > 0 ? value - 1.5 : value + 1.5;
        break;
      case SliceKind::color:
        value *= 0.9;
        break;
      default:
        value += 0.0137 + 0.0001 * (salt % 7);
    }
  }
  return values;
}

std::string setting(std::string_view name, const std::vector<double>& values) {
  return fmt::format("{}={}", name, fmt::join(values, ","));
}

struct Edit {
  int slice;
  std::vector<double> values;
};

/// Edits a sample, and looks whether the new text says exactly what it should.
void expect_edited(const std::string& text, const Face& face, const std::vector<Edit>& edits) {
  const Layout& layout = face.model->layout;
  std::vector<std::string> settings;
  FaceVector wanted = face.vector;
  for (const Edit& edit : edits) {
    settings.push_back(setting(layout[edit.slice].name, edit.values));
    std::copy(edit.values.begin(), edit.values.end(), wanted.begin() + layout[edit.slice].begin);
  }
  const auto edited = edit_face_text(text, settings);
  ASSERT_TRUE(edited) << sentence(edited.error());
  EXPECT_TRUE(edited->left.empty()) << edited->left[0];
  const auto again = read_face_text(edited->text);
  ASSERT_TRUE(again) << sentence(again.error());
  ASSERT_EQ(again->vector.size(), wanted.size());
  for (const Slice& slice : layout.slices()) {
    if (slice.name.find("/dome/") != std::string::npos) continue;  // follow the eye
    for (int i = slice.begin; i < slice.begin + slice.size; ++i) {
      const double read = again->vector[std::size_t(i)], asked = wanted[std::size_t(i)];
      if (slice.kind == SliceKind::color)
        EXPECT_NEAR(read, asked, 1e-15) << slice.name;
      else
        EXPECT_EQ(read, asked) << slice.name;
    }
  }
}

/// Every value that the file holds, with other numbers.
std::vector<Edit> all_edits(const std::string& text, const Face& face) {
  const auto pointers = face_pointers(text);
  EXPECT_TRUE(pointers);
  std::vector<Edit> edits;
  const std::size_t controls = face.model->controls.size();
  for (int i = 0; i < int(face.model->layout.slices().size()); ++i) {
    const Slice& slice = face.model->layout[i];
    if ((*pointers)[controls + std::size_t(i)].empty()) continue;
    const auto begin = face.vector.begin() + slice.begin;
    edits.push_back({i, other_numbers(slice, {begin, begin + slice.size}, i)});
  }
  return edits;
}

TEST(FaceEdit, HoldsEveryValueOfEverySampleAtOnce) {
  for (const auto& [name, text] : samples()) {
    SCOPED_TRACE(name);
    const auto face = read_face_text(text);
    ASSERT_TRUE(face);
    const std::vector<Edit> edits = all_edits(text, *face);
    EXPECT_GT(edits.size(), 30u);
    expect_edited(text, *face, edits);
  }
}

TEST(FaceEdit, HoldsOneValueAtATime) {
  for (const auto& [name, text] : samples()) {
    SCOPED_TRACE(name);
    const auto face = read_face_text(text);
    ASSERT_TRUE(face);
    const std::vector<Edit> edits = all_edits(text, *face);
    for (std::size_t i = 0; i < edits.size(); i += 1 + edits.size() / 25)
      expect_edited(text, *face, {edits[i]});
  }
}

TEST(FaceEdit, HoldsAnyHandful) {
  test::Random random(7);
  for (const auto& [name, text] : samples()) {
    SCOPED_TRACE(name);
    const auto face = read_face_text(text);
    ASSERT_TRUE(face);
    const std::vector<Edit> edits = all_edits(text, *face);
    for (int round = 0; round < 6; ++round) {
      std::vector<Edit> some;
      for (const Edit& edit : edits)
        if (random.chance(0.05)) some.push_back(edit);
      expect_edited(text, *face, some);
    }
  }
}

TEST(FaceEdit, WithoutSettingsKeepsEveryByte) {
  for (const auto& [name, text] : samples()) {
    const auto edited = edit_face_text(text, {});
    ASSERT_TRUE(edited) << name;
    EXPECT_EQ(edited->text, text) << name;
  }
  const auto recipe = edit_face(test::face_path("faces/toon"), {});
  ASSERT_TRUE(recipe) << sentence(recipe.error());
  EXPECT_EQ(recipe->text, file_text(test::face_path("faces/toon")));
}

// What the face is already needs no change, even where the file writes it in another way.
TEST(FaceEdit, WithTheSameValuesKeepsEveryByte) {
  for (const auto& [name, text] : samples()) {
    const auto face = read_face_text(text);
    ASSERT_TRUE(face);
    std::vector<std::string> settings;
    for (const SettableName& one : settable_names(*face))
      if (!one.control) settings.push_back(setting(one.name, one.value));
    const auto edited = edit_face_text(text, settings);
    ASSERT_TRUE(edited) << name << sentence(edited.error());
    EXPECT_EQ(edited->text, text) << name;
  }
}

const std::string kBrow =
    R"({"comment": "mine",  "name": "brow", "kind": "stroke", "side": "left",
  "spine": [[-0.50, 0.1], [-0.3, 0.20],  [-0.1, 0.1]],
  "half_width": 0.05})";

std::string edited_features(const std::string& features, const std::vector<std::string>& settings) {
  const std::string text = face_with(features);
  const auto edited = edit_face_text(text, settings, "f");
  if (!edited) return sentence(edited.error());
  const std::string begin = "\"features\": [";
  const std::size_t at = edited->text.find(begin) + begin.size();
  return edited->text.substr(at, edited->text.size() - at - 2);
}

TEST(FaceEdit, ASideThatIsSetGetsAnObjectOfItsOwn) {
  EXPECT_EQ(edited_features(kBrow, {"brow.right/spine/1=0.35,0.25"}),
            kBrow.substr(0, kBrow.size() - 1) + R"(,
  "right": {"spine": [[0.5, 0.1], [0.35, 0.25],  [0.1, 0.1]]}})");
  EXPECT_EQ(edited_features(kBrow, {"brow.left/spine/1/y=0.25"}),
            kBrow.substr(0, kBrow.size() - 1) + R"(,
  "left": {"spine": [[-0.50, 0.1], [-0.3, 0.25],  [-0.1, 0.1]]}})");
  EXPECT_EQ(edited_features(kBrow, {"brow.right/spine/1/y=0.25", "brow.right/half_width=0.1"}),
            kBrow.substr(0, kBrow.size() - 1) + R"(,
  "right": {"spine": [[0.5, 0.1], [0.3, 0.25],  [0.1, 0.1]], "half_width": 0.1}})");
}

TEST(FaceEdit, AnObjectOfASideThatIsThereIsUsed) {
  const std::string with =
      kBrow.substr(0, kBrow.size() - 1) + R"(, "right": {"half_width": 0.06}})";
  std::string wanted = with;
  wanted.insert(wanted.size() - 2, R"(, "spine": [[0.5, 0.1], [0.3, 0.25],  [0.1, 0.1]])");
  wanted.replace(wanted.find("0.06"), 4, "0.07");
  EXPECT_EQ(edited_features(with, {"brow.right/spine/1/y=0.25", "brow.right/half_width=0.07"}),
            wanted);
  const std::string empty = kBrow.substr(0, kBrow.size() - 1) + R"(, "right": {}})";
  std::string filled = empty;
  filled.insert(filled.size() - 2, R"("half_width": 0.07)");
  EXPECT_EQ(edited_features(empty, {"brow.right/half_width=0.07"}), filled);
}

// Both sides in each other's image stay written once; the numbers are those of the file's side.
TEST(FaceEdit, BothSidesAlikeStayOne) {
  std::string wanted = kBrow;
  wanted.replace(wanted.find("-0.3, 0.20"), 10, "-0.35, 0.25");
  EXPECT_EQ(
      edited_features(kBrow, {"brow.left/spine/1=-0.35,0.25", "brow.right/spine/1=0.35,0.25"}),
      wanted);
}

TEST(FaceEdit, BothSidesUnlikeAreTheFilesSideAndAnObject) {
  std::string wanted = kBrow.substr(0, kBrow.size() - 1) + R"(,
  "right": {"spine": [[0.5, 0.1], [0.4, 0.20],  [0.1, 0.1]]}})";
  wanted.replace(wanted.find("-0.3, 0.20"), 10, "-0.35, 0.25");
  EXPECT_EQ(edited_features(kBrow, {"brow.left/spine/1=-0.35,0.25", "brow.right/spine/1/x=0.4"}),
            wanted);
}

TEST(FaceEdit, SaysWhatNoFileHolds) {
  const std::string text =
      face_with(kBrow, R"(, "controls": [{"name": "look", "range": [0, 1], "rest": 0}])");
  const auto edited = edit_face_text(text, {"look=0.5", "palette/skin=#102030", "look=0.6"});
  ASSERT_TRUE(edited) << sentence(edited.error());
  EXPECT_EQ(edited->left, std::vector<std::string>{"look"});
  EXPECT_NE(edited->text.find(R"("skin": "#102030")"), std::string::npos);
  const auto recipe = edit_face(test::face_path("faces/toon"), {"palette/skin=#102030"});
  ASSERT_TRUE(recipe) << sentence(recipe.error());
  EXPECT_EQ(recipe->left, std::vector<std::string>{"palette/skin"});
  EXPECT_EQ(recipe->text, file_text(test::face_path("faces/toon")));
}

TEST(FaceEdit, RefusesWithAnAddress) {
  const auto said = [](const std::string& text, const std::vector<std::string>& settings) {
    const auto edited = edit_face_text(text, settings, "f");
    return edited ? "a face" : sentence(edited.error());
  };
  const std::string eye =
      face_with(R"({"name": "spot", "kind": "disc", "center": [0, 0], "radius": 1})",
                R"(, "eyes": [{"name": "ball", "center": [0, 0], "radius": 1}])");
  EXPECT_EQ(
      said(eye, {"spit/radius=1"}),
      "spit/radius=1: no control or number named \"spit/radius\"; did you mean \"spot/radius\"?");
  EXPECT_EQ(said(eye, {"spot/radius=-1"}),
            "spot/radius=-1: \"spot/radius\" goes from 0 to 1000000000, got -1");
  EXPECT_EQ(said(eye, {"ball/radius=0"}).substr(0, 4), "f:3:");  // in the text that it would be
  EXPECT_EQ(said("{", {}).substr(0, 4), "f:1:");
  EXPECT_EQ(edit_face("no.such.file", {}).error().where, "no.such.file");
}

}  // namespace
}  // namespace mien
