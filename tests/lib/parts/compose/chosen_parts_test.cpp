#include "lib/parts/compose/chosen_parts.h"
#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/face_model.h>
#include "lib/parts/code/code_fields.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace mien {
namespace {

/// A hat, with something in place of something else.
std::string hat(std::string_view instead_of = {}, std::string_view there = {}) {
  std::string text = R"({"format": "mien-part", "format_version": 1,
 "family": "headwear", "name": "fez",
 "in": "scalp",
 "points": {"hairline": [0.24, 0.45]},
 "features": [
  {"name": "hair_room", "slot": "background", "role": "none", "in": "scalp", "turn": 0, "kind": "path", "half": true,
   "points": [[0, 0.5], [0.46, 0.56], [0.8, 0.6], [1.6, -0.5], [1.6, -2], [0, -2]]},
  {"name": "fez", "slot": "hat", "role": "accent", "in": "scalp", "turn": 0.02, "kind": "path", "half": true,
   "points": [[0, 0.98], [0.34, 0.96], [0.46, 0.56], [0.3, 0.5, "bend"], [0, 0.49]]}]})";
  if (!instead_of.empty()) {
    const std::size_t at = text.find(instead_of);
    EXPECT_NE(at, std::string::npos) << instead_of;
    text.replace(at, instead_of.size(), there);
  }
  return text;
}

Recipe wearing(std::string text, const std::string& family = "headwear") {
  Recipe recipe;
  recipe.parts[family] = "fez.part.json";
  recipe.own_parts["fez.part.json"] = {"hats/fez.part.json", std::move(text)};
  return recipe;
}

std::string said_of(const Recipe& recipe) {
  const auto face = face_from_recipe(recipe);
  return face ? "a face" : sentence(face.error());
}

bool has_fez(const Face& face) {
  return std::ranges::any_of(face.model->features,
                             [](const Feature& one) { return one.name == "fez"; });
}

TEST(OwnParts, AreDrawn) {
  const auto face = face_from_recipe(wearing(hat()));
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(has_fez(*face));
  for (const char* style : {"flat", "vinyl", "clay", "ink", "pictogram", "peep", "sticker"}) {
    Recipe styled = wearing(hat());
    styled.style = style;
    EXPECT_EQ(said_of(styled), "a face") << style;
  }
}

TEST(OwnParts, AreRefusedAtTheirPlace) {
  const std::pair<std::pair<const char*, const char*>, const char*> wrongs[] = {
      {{"mien-part", "mien-prat"}, "hats/fez.part.json:1:12: /format: expected \"mien-part\""},
      {{"\"format_version\": 1", "\"format_version\": 2"}, "1:43: /format_version: expected the"},
      {{"headwear", "hair"}, "2:12: /family: the recipe takes this as \"headwear\""},
      {{"scalp", "skalp"}, "3:8: /in: no frame named \"skalp\"; did you mean \"scalp\"?"},
      {{"\"points\": {", "\"pints\": {"},
       "4:11: /pints: no key of a part named \"pints\"; did you"},
      {{"\"points\": {\"hairline\": [0.24, 0.45]}", "\"points\": []"}, "4:12: /points: expected"},
      {{"\"points\": {", "\"numbers\": {"}, "4:13: /numbers: a part of one's own has no numbers"},
      {{"\"slot\": \"hat\"", "\"slot\": \"hatt\""},
       "8:27: /features/1/slot: no slot named \"hatt\""},
      {{"\"accent\"", "\"acent\""}, "8:3: /features/1: no palette colour named"},
      {{"[0.34, 0.96]", "[0.34]"}, "9:26: /features/1/points/1: expected 2 numbers, got 1"},
      {{"[0.34, 0.96]", "{\"at\": \"mouth.conrer\"}"}, "did you mean \"mouth.corner\"?"},
      {{"[0.34, 0.96]", "[0.34, 0.96, \"bent\"]"},
       "no mark of a point named \"bent\"; did you mean \"bend\"?"},
      {{"[0.34, 0.96]", "{\"xy\": [0, 0], \"plsu\": [0, 0]}"}, "did you mean \"plus\"?"},
      {{"[0.34, 0.96]", "{\"xy\": [0, 0], \"adds\": 5}"},
       "9:49: /features/1/points/1/adds: expect"},
      {{"[0.34, 0.96]", "{\"xy\": [0, 0], \"adds\": {\"jaaw\": [0, 0]}}"}, "did you mean \"jaw\"?"},
      {{"[0.34, 0.96]", "[0.34, 1e99]"}, "9:33: /features/1/points/1/1: 1e+99 is too large"},
      {{"\"half\": true", "\"half\": 1"}, "/features/0/half: expected"},
      {{"\"name\": \"fez\", \"slot\"", "\"name\": \"head\", \"slot\""},
       "another part has a feature"},
      {{"\"kind\": \"path\"", "\"kind\": \"paht\""}, "6:97: /features/0/kind: no kind of feature"},
      {{"\"features\": [", "\"covers\": [\"hiar\"], \"features\": ["}, "did you mean \"hair\"?"},
      {{"\"features\": [", "\"covers\": [\"hair/bobb\"], \"features\": ["},
       "did you mean \"bob\"?"},
      {{"\"features\": [", "\"gone\": [\"lip_uper\"], \"features\": ["},
       "/gone/0: no feature that all faces share named \"lip_uper\"; did you mean \"lip_upper\"?"},
      {{"[0, 0.98]", "[0, 0.98"}, "hats/fez.part.json:9:"},
  };
  for (const auto& [change, said] : wrongs) {
    const std::string got = said_of(wearing(hat(change.first, change.second)));
    EXPECT_NE(got.find(said), std::string::npos) << change.second << "\n  " << got;
    EXPECT_EQ(got.find('\n'), std::string::npos) << got;
  }
}

bool draws(const Face& face, std::string_view feature) {
  const auto found = std::ranges::find(face.model->features, feature, &Feature::name);
  if (found == face.model->features.end() || !found->painted()) return false;
  return found->opacity < 0 ||
         face.vector[std::size_t(face.model->layout[found->opacity].begin)] > 0;
}

TEST(OwnParts, LeaveOutWhatAllFacesShare) {
  const std::string text = hat("\"features\": [", "\"gone\": [\"teeth\"], \"features\": [");
  const auto face = face_from_recipe(wearing(text)), other = face_from_recipe(wearing(hat()));
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_FALSE(draws(*face, "teeth"));
  EXPECT_TRUE(draws(*face, "tongue"));
  EXPECT_TRUE(draws(*other, "teeth"));
}

/// Long hair hides an aid behind the ear, not a mask.
TEST(OwnParts, AreCoveredOneByOne) {
  const auto draws_aid = [](const char* hair, const char* aid, const char* feature) {
    Recipe recipe;
    recipe.parts["hair"] = hair, recipe.parts["aid"] = aid;
    return draws(face_from_recipe(recipe).value(), feature);
  };
  EXPECT_TRUE(draws_aid("crop", "hearing_aid", "hearing_tube.left"));
  EXPECT_FALSE(draws_aid("bob", "hearing_aid", "hearing_tube.left"));
  EXPECT_TRUE(draws_aid("bob", "face_mask", "mask"));
}

/// The line between the lips, or beneath open teeth the gap: what a mouth's part says is how it rests.
TEST(OwnParts, MouthsMayRestOpen) {
  const auto gap = [](const char* mouth) {
    Recipe recipe;
    recipe.parts["mouth"] = mouth;
    const Face face = face_from_recipe(recipe).value();
    const Mouth& rig = *face.model->mouth;
    const auto height = [&](int slice) {
      return face.vector[std::size_t(face.model->layout[slice].begin) + 1];
    };
    return height(rig.upper[1].slice) - height(rig.lower[1].slice);
  };
  EXPECT_EQ(gap("soft"), 0);
  EXPECT_EQ(gap("line"), 0);
  EXPECT_GT(gap("grin"), 0.1);
  EXPECT_GT(gap("dot"), 0.05);
}

const char* const kGrouped =
    R"("groups": {"wool": {"mix": "multiply", "opacity": 0.5, "clip": "head"}}, "features": [)";

TEST(OwnParts, HaveGroupsOfTheirOwn) {
  std::string text = hat("\"features\": [", kGrouped);
  text.replace(text.find("\"slot\": \"hat\""), 0, "\"group\": \"wool\", ");
  const auto face = face_from_recipe(wearing(text));
  ASSERT_TRUE(face) << sentence(face.error());
  ASSERT_EQ(face->model->groups.size(), 1u);
  EXPECT_EQ(face->model->groups[0].mix, MixMode::multiply);
  const auto fez = std::ranges::find(face->model->features, "fez", &Feature::name);
  EXPECT_EQ(fez->group.at, 0);
  const std::string wrong = said_of(wearing(
      hat("\"features\": [", R"("groups": {"wool": {"mix": "multiplies"}}, "features": [)")));
  EXPECT_NE(wrong.find("hats/fez.part.json:5:"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("did you mean \"multiply\"?"), std::string::npos) << wrong;
  Recipe two = wearing(text);
  two.parts["glasses"] = "other.part.json";
  two.own_parts["other.part.json"] = {
      "other.part.json",
      R"({"format": "mien-part", "format_version": 1, "family": "glasses", "name": "other",
      "groups": {"wool": {}}, "features": []})"};
  EXPECT_NE(said_of(two).find("another part has a group named \"wool\", too"), std::string::npos)
      << said_of(two);
}

TEST(OwnParts, HaveWhatOthersBuildOn) {
  const std::string nose =
      R"({"format": "mien-part", "format_version": 1, "family": "nose", "name": "a", "features": []})";
  EXPECT_EQ(said_of(wearing(nose, "nose")),
            "hats/fez.part.json:1:1: every part of family \"nose\" has a feature named \"nose\", "
            "on which others build");
}

TEST(OwnParts, AreInNoCode) {
  Recipe recipe = wearing(hat());
  const auto& library = PartLibrary::shipped();
  const ChosenParts chosen = ChosenParts::read(library, recipe).value();
  EXPECT_EQ(chosen.of("headwear")->name, "fez");
  EXPECT_EQ(chosen_part(library, recipe, "headwear"), nullptr);
  EXPECT_EQ(code_of_recipe(recipe).value(), code_of_recipe({}).value());
  EXPECT_EQ(chosen.of("head"), library.find_family("head")->find("oval"));
}

/// Any value of any shipped part in place of any kind of other: a face or a sentence, never worse.
TEST(OwnParts, OfNonsenseAreRefused) {
  const PartLibrary& library = PartLibrary::shipped();
  int faces = 0, refused = 0;
  for (const char* name : {"headwear/cap", "mouth/wide", "eyes/almond", "beard/stubble", "hair/bob",
                           "clothes/hoodie"}) {
    const std::string_view path = name;
    const Family& family = *library.find_family(path.substr(0, path.find('/')));
    const Part* part = family.find(path.substr(path.find('/') + 1));
    if (!part) part = &family.parts.back();
    JsonTree tree = JsonTree::read(part->at.file->text, part->name, {}).value();
    const std::string text(part->at.file->text);
    for (std::size_t i = 1; i < tree.nodes.size(); i += 7) {
      const JsonNode& node = tree.nodes[i];
      // Where the value ends in the text: behind its brackets or its quotes.
      std::size_t end = node.offset;
      int open = 0;
      bool quoted = false;
      do {
        const char c = text[end++];
        if (c == '"') quoted = !quoted;
        if (!quoted) open += (c == '[' || c == '{') - (c == ']' || c == '}');
      } while (quoted || open > 0 ||
               (node.kind != JsonKind::array && node.kind != JsonKind::object &&
                node.kind != JsonKind::string &&
                std::string_view(",]}\n ").find(text[end]) == std::string_view::npos));
      for (const char* other : {"null", "true", "1e8", "-7", "\"x\"", "\"@x\"", "[]", "{}", "[[]]",
                                "[\"bend\"]", "[1, 2]", "{\"at\": {}}", "{\"of\": \"lid.in\"}"}) {
        Recipe recipe;
        recipe.parts[family.name] = "own.part.json";
        recipe.own_parts["own.part.json"] = {
            "own.part.json", text.substr(0, node.offset) + other + text.substr(end)};
        const std::string said = said_of(recipe);
        ++(said == "a face" ? faces : refused);
        ASSERT_EQ(said.find('\n'), std::string::npos) << said;
      }
    }
  }
  EXPECT_GT(faces, 100);
  EXPECT_GT(refused, 1000);
}

class OwnPartFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string face_with(const std::string& part) const {
    write(
        "mina.face.json",
        R"({"format": "mien-face", "format_version": 2, "parts": {"headwear": ")" + part + "\"}}");
    std::vector<Error> warnings;
    const auto face = read_face(folder_ / "mina.face.json", {}, &warnings);
    if (!face) return sentence(face.error());
    return warnings.empty() ? (has_fez(*face) ? "a fez" : "none") : sentence(warnings[0]);
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      ("own_parts_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(OwnPartFiles, LieBesideTheirRecipe) {
  write("fez.part.json", hat());
  EXPECT_EQ(face_with("fez.part.json"), "a fez");
  const std::string none = face_with("fes.part.json");
  EXPECT_NE(none.find("/parts/headwear: \""), std::string::npos) << none;
  EXPECT_TRUE(none.ends_with("fes.part.json\" is not there")) << none;
  for (const char* outside : {"../fez.part.json", "/tmp/fez.part.json", "hats/fez.part.json"})
    EXPECT_NE(face_with(outside).find("without slashes"), std::string::npos) << outside;
  std::filesystem::create_directory(folder_ / "folder.part.json");
  EXPECT_TRUE(face_with("folder.part.json").ends_with("is a folder, no file"));
  ASSERT_EQ(mkfifo((folder_ / "pipe.part.json").c_str(), 0600), 0);
  EXPECT_TRUE(face_with("pipe.part.json").ends_with("is a pipe or a device, no file"));
  namespace fs = std::filesystem;
  fs::create_symlink("b.part.json", folder_ / "a.part.json");
  fs::create_symlink("a.part.json", folder_ / "b.part.json");
  const std::string loop = face_with("a.part.json");
  EXPECT_NE(loop.find("cannot be read: Too many levels of symbolic links"), std::string::npos)
      << loop;
  fs::create_directory(folder_ / "hats");
  write("hats/fez.part.json", hat());
  fs::create_symlink("fez.part.json", folder_ / "near.part.json");
  fs::create_symlink("hats/fez.part.json", folder_ / "far.part.json");
  EXPECT_EQ(face_with("near.part.json"), "a fez");
  EXPECT_TRUE(face_with("far.part.json").ends_with("leads out of the recipe's folder"));
}

TEST_F(OwnPartFiles, AreWarnedOfAtTheirPlace) {
  write("fez.part.json", hat("\"half\": true", "\"half\": true, \"colour\": 1"));
  const std::string said = face_with("fez.part.json");
  EXPECT_NE(said.find("fez.part.json:6:"), std::string::npos) << said;
  EXPECT_NE(said.find("unknown key \"colour\""), std::string::npos) << said;
}

TEST(OwnPartExample, IsAFaceAndWhatThePageShows) {
  const std::filesystem::path root = MIEN_SOURCE_DIR;
  const auto text = [](const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  const std::string page = text(root / "docs/parts.md");
  for (const char* name : {"fez.part.json", "mina.face.json"})
    EXPECT_NE(page.find("```json\n" + text(root / "examples/own_part" / name) + "```"),
              std::string::npos)
        << name;
  std::vector<Error> warnings;
  const auto face = read_face(root / "examples/own_part/mina.face.json", {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(has_fez(*face));
  EXPECT_TRUE(warnings.empty());
}

TEST(TintedGlassesExample, MultiplyAndScreen) {
  std::vector<Error> warnings;
  const auto face =
      read_face(std::filesystem::path(MIEN_SOURCE_DIR) / "examples/tinted_glasses/ada.face.json",
                {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(face->model->groups.size(), 2u);
  EXPECT_EQ(face->model->groups[0].mix, MixMode::multiply);
  EXPECT_EQ(face->model->groups[1].mix, MixMode::screen);
}

TEST_F(OwnPartFiles, AreNotOfATextAlone) {
  const auto face = read_face_text(
      R"({"format": "mien-face", "format_version": 2, "parts": {"headwear": "fez.part.json"}})",
      "f");
  ASSERT_FALSE(face);
  EXPECT_NE(sentence(face.error()).find("this recipe is of no file"), std::string::npos);
}

}  // namespace
}  // namespace mien
