#include "tools/mien/import/facemotion.h"

#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>
#include <sstream>

#include "tests/support/faces/face_path.h"
#include "tests/support/faces/faces.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

/// A face in the syntax that morphologies are published in.
const std::string kSample = R"js(// A sample.
var tiny = {
    'version': 1.0,
    'stiffness': 20,  /* of springs */
    'damping': 8,
    'features': {
        'brow': {
            'points': [
                {x: 40, y: -34},
                {x: 112.5, y: -45},
            ],
            'weight': 1
        },
        mouth: {points: [{x: 0, y: 170}, {x: 60, y: 170}], weight: .5},
        'eyeball': {
            'type': 'circle', 'center': {x: 82, y: 0}, 'radius': 13, 'weight': 0.2,
            'upperChord': 0.7, "lowerChord": 0.94,
        }
    },
    'muscleGroups': {
        'zygomaticus': {
            'strength': 30, 'stroke': 50, 'origin': {x: 180, y: 50},
            'muscles': {
                'mouth:1': 1
                // 'mouth:0':0.1
            }
        },
        'orbicularis-oculi': {
            'strength': 20, 'stroke': 10, 'origin': {x: 80, y: +5},
            'muscles': {'eyeball:scale': 0.5, 'brow:0': 1e-1,}
        },
    },
    'recipes': {
        'joy': {'zygomaticus': 1, 'orbicularis-oculi': 0.8},
    }

};
)js";

std::string said(const std::string& text, const FacemotionOptions& options = {}) {
  const auto made = face_text_from_facemotion(text, "m.js", options);
  return made ? "a face" : sentence(made.error());
}

std::string with(std::string from, const std::string& to) {
  std::string text = kSample;
  const std::size_t found = text.find(from);
  if (found == std::string::npos) throw std::runtime_error("no " + from);
  return text.replace(found, from.size(), to);
}

Face imported(const std::string& text) {
  const auto made = face_text_from_facemotion(text, "m.js");
  if (!made) throw std::runtime_error(sentence(made.error()));
  std::vector<Error> warnings;
  const auto face = read_face_text(*made, "made", {}, &warnings);
  if (!face) throw std::runtime_error(sentence(face.error()));
  if (!warnings.empty()) throw std::runtime_error(sentence(warnings[0]));
  return *face;
}

std::vector<double> numbers(const Face& face, const std::string& slice) {
  const Slice& s = face.model->layout[face.model->layout.find(slice)];
  return {face.vector.begin() + s.begin, face.vector.begin() + s.begin + s.size};
}

TEST(Facemotion, ReadsTheSyntaxThatMorphologiesArePublishedIn) {  // M1, M2, M3
  const Face face = imported(kSample);
  EXPECT_EQ(face.model->name, "tiny");
  EXPECT_EQ(numbers(face, "brow.left/points/1"), (std::vector<double>{112.5, -45}));
  EXPECT_EQ(numbers(face, "brow.right/points/1"), (std::vector<double>{-112.5, -45}));
  EXPECT_EQ(numbers(face, "brow.left/half_width"), std::vector<double>{2.5});
  EXPECT_EQ(numbers(face, "mouth.left/half_width"), std::vector<double>{1.25});
  EXPECT_EQ(numbers(face, "eyeball.left/chords"), (std::vector<double>{0.7, 0.94}));
  EXPECT_FALSE(face.model->canvas.y_up);
  const MuscleSystem& system = face.model->muscles;
  EXPECT_EQ(system.stiffness, 20);
  EXPECT_EQ(system.damping, 8);
  ASSERT_EQ(system.muscles.size(), 4u);
  EXPECT_EQ(system.muscles[0].name, "zygomaticus");
  EXPECT_EQ(system.muscles[0].origin, (glm::dvec2{180, 50}));
  EXPECT_EQ(system.muscles[1].origin, (glm::dvec2{-180, 50}));  // M5
  EXPECT_EQ(system.numbers.size(), 2u);                         // M4
}

/// The shipped face, read back, says what its source says: its muscles and recipes number for number.
TEST(Facemotion, TheMaleFaceHasThirteenMusclesAndSixRecipes) {  // M1, M4, M10
  const auto face = nlohmann::json::parse(std::ifstream(test::face_path("male")));
  EXPECT_EQ(face["muscles"]["groups"].size(), 13u);
  EXPECT_EQ(face["emotions"].size(), 6u);
  EXPECT_EQ(face["emotions"]["fear"]["jaw"], 0.8);
  EXPECT_EQ(face["muscles"]["groups"][0]["attach"]["eyebrow/points/1"], 0.3);
  EXPECT_EQ(face["expressions"]["arkit"].size(), 52u);
  EXPECT_EQ(face["expressions"]["viseme"].size(), 15u);
}

std::string published_text() {
  std::ifstream file(MIEN_SOURCE_DIR "/tests/support/faces/facemotion_male.js");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The published face by another way than the importer's: rewritten as JSON, and a JSON library's.
nlohmann::json published_values() {
  std::string text = published_text();
  text = std::regex_replace(text, std::regex("//[^\n]*|/\\*.*?\\*/"), "");
  text = text.substr(text.find('{'), text.rfind('}') - text.find('{') + 1);
  text = std::regex_replace(text, std::regex("'"), "\"");
  text = std::regex_replace(text, std::regex("([{,]\\s*)([A-Za-z]+):"), "$1\"$2\":");
  text = std::regex_replace(text, std::regex(",(\\s*[}\\]])"), "$1");
  return nlohmann::json::parse(text);
}

TEST(Facemotion, TheShippedFaceIsTheImportersToTheByte) {  // M1
  const auto made = face_text_from_facemotion(published_text(), "facemotion_male.js");
  ASSERT_TRUE(made) << sentence(made.error());
  std::ifstream file(test::face_path("male"));
  std::stringstream shipped;
  shipped << file.rdbuf();
  const std::regex schema(
      "\\.\\./\\.\\./docs");  // it lies a folder deeper than the importer writes for
  EXPECT_EQ(*made, std::regex_replace(shipped.str(), schema, "../docs"));
}

TEST(Facemotion, RestGeometryIsTheSourcesPointForPoint) {  // M1, M2, M3, M5
  const nlohmann::json source = published_values();
  const Face face = test::face_named("male");
  int points = 0;
  for (const auto& [name, feature] : source["features"].items())
    for (const auto& [side, sign] : {std::pair{".left", 1.0}, {".right", -1.0}}) {
      const std::string full = name + side;
      if (feature.contains("radius")) {
        const double x = feature["center"]["x"], y = feature["center"]["y"];
        EXPECT_EQ(numbers(face, full + "/center"), (std::vector{sign * x, y}));
        EXPECT_EQ(numbers(face, full + "/radius"), std::vector<double>{feature["radius"]});
        EXPECT_EQ(numbers(face, full + "/chords"),
                  (std::vector<double>{feature["upperChord"], feature["lowerChord"]}));
        continue;
      }
      EXPECT_EQ(numbers(face, full + "/half_width")[0], 2.5 * double(feature["weight"])) << full;
      for (std::size_t i = 0; i < feature["points"].size(); ++i, ++points) {
        const double x = feature["points"][i]["x"], y = feature["points"][i]["y"];
        EXPECT_EQ(numbers(face, fmt::format("{}/points/{}", full, i)), (std::vector{sign * x, y}));
      }
    }
  EXPECT_EQ(points, 32);
}

TEST(Facemotion, MusclesAreTheSourcesNumberForNumber) {  // M4, M5
  const nlohmann::json source = published_values();
  const Face face = test::face_named("male");
  const MuscleSystem& system = face.model->muscles;
  EXPECT_EQ(system.muscles.size(), 2 * source["muscleGroups"].size());
  for (const Muscle& muscle : system.muscles) {
    const auto& group = source["muscleGroups"][muscle.name];
    const double sign = muscle.side == Side::left ? 1 : -1;
    EXPECT_EQ(muscle.strength, double(group["strength"])) << muscle.name;
    EXPECT_EQ(muscle.stroke, double(group["stroke"])) << muscle.name;
    EXPECT_EQ(muscle.origin.x, sign * double(group["origin"]["x"])) << muscle.name;
    EXPECT_EQ(muscle.origin.y, double(group["origin"]["y"])) << muscle.name;
  }
}

TEST(Facemotion, SmoothsPolylinesIfAsked) {  // M2
  const auto made = face_text_from_facemotion(kSample, "m.js", {.smooth = true});
  ASSERT_TRUE(made) << sentence(made.error());
  std::vector<Error> warnings;
  const auto face = read_face_text(*made, "made", {}, &warnings);
  ASSERT_TRUE(face) << sentence(face.error());
  EXPECT_TRUE(warnings.empty());
  EXPECT_TRUE(std::get<PolylineFigure>(face->model->features[0].figure).smooth);
}

TEST(Facemotion, ChoosesOneOfSeveral) {
  const std::string two = kSample + "const other = {version: 1};\n";
  EXPECT_EQ(said(two), "m.js:1:1: it has 2 morphologies, tiny, other: say which");
  EXPECT_EQ(said(two, {.morphology = "tiny"}), "a face");
  EXPECT_EQ(said(two, {.morphology = "tini"}),
            "m.js:1:1: no morphology named \"tini\"; did you mean \"tiny\"?");
}

TEST(Facemotion, IsStrictAboutNames) {  // M4
  EXPECT_EQ(said(with("'mouth:1': 1", "'mouth:2': 1")),
            "m.js:24:28: /tiny/muscleGroups/zygomaticus/muscles/mouth:2: no attachment named "
            "\"mouth:2\"; there are \"brow:0\", \"brow:1\", \"mouth:0\", \"mouth:1\" and "
            "\"eyeball:scale\"");
  EXPECT_NE(said(with("'eyeball:scale'", "'eyeball:size'")).find("did you mean \"eyeball:scale\"?"),
            std::string::npos);
  EXPECT_NE(said(with("{'zygomaticus': 1", "{'zigomaticus': 1"))
                .find("no muscle named \"zigomaticus\"; did you mean \"zygomaticus\"?"),
            std::string::npos);
  EXPECT_NE(said(with("'damping': 8", "'dampening': 8"))
                .find("no key of a morphology named \"dampening\"; did you mean \"damping\"?"),
            std::string::npos);
  EXPECT_NE(said(with("'circle'", "'square'")).find("no type of feature named \"square\""),
            std::string::npos);
  EXPECT_NE(said(with("'version': 1.0", "'version': 2")).find("expected version 1, got 2"),
            std::string::npos);
  EXPECT_NE(said(with("'mouth:1': 1", "'mouth:1': 1.5")).find("a weight goes from 0 to 1, got 1.5"),
            std::string::npos);
}

/// Modules, types and other code beside a morphology: the same face.
TEST(Facemotion, ReadsModulesAndPassesOverOtherCode) {
  const std::size_t begin = kSample.find('{');
  const std::string body = kSample.substr(begin, kSample.rfind('}') + 1 - begin);
  const auto face = [](const std::string& text) {
    const auto made = face_text_from_facemotion(text, "tiny.js", {});
    return made ? *made : sentence(made.error());
  };
  const std::string wanted = face("var tiny = " + body + ";\n");
  EXPECT_NE(wanted.find("mien-face"), std::string::npos) << wanted;
  for (const std::string& text : std::vector<std::string>{
           "export const tiny = " + body + ";\n", "export let tiny = " + body,
           "module.exports.tiny = " + body + ";", "'use strict';\nvar tiny = " + body + ";\n",
           "var tiny = (" + body + ");\n", "{\"tiny\": " + body + "}",
           "const tiny = " + body + " as const;\n", "const tiny: Morphology = " + body + ";\n",
           "const tiny = " + body + " satisfies Morphology;\n",
           "var tiny = " + body + "\nif (typeof module !== 'undefined') module.exports = tiny;\n",
           "import x from './x.js'; // {it's}\nvar tiny = " + body +
               ";\nvar f = new Face(tiny); // ;\nf.draw();\n",
           "function a() { return {b: '}'}; }\nvar tiny = " + body + ";\nexport { tiny };\n"})
    EXPECT_EQ(face(text), wanted) << text;
  const std::string two = said("var a = " + body + "\nf() // x\nvar b = " + body);
  EXPECT_NE(two.find("it has 2 morphologies"), std::string::npos) << two;
}

TEST(Facemotion, RunsNothing) {
  EXPECT_EQ(said("var a = b;"), "m.js:1:1: there is no object literal in it");
  EXPECT_EQ(said("var a = {b: f()};"), "m.js:1:13: expected a value, got \"f\": no code is run");
  EXPECT_EQ(said("alert(1)"), "m.js:1:1: there is no object literal in it");
  EXPECT_EQ(said("var a = {b: `${1}`};"), "m.js:1:14: a template with ${…}: no code is run");
  EXPECT_EQ(said("alert(1))"), "m.js:1:9: a ) that nothing opens");
  EXPECT_EQ(said("var a = {b: 1 + 1};"), "m.js:1:15: expected , or }");
  EXPECT_EQ(said("var a = {b: 1, b: 2};"), "m.js:1:16: the key \"b\" stands here twice");
  EXPECT_EQ(said(""), "m.js:1:1: there is no object literal in it");
  EXPECT_EQ(said("var a = {'b"), "m.js:1:10: this string does not end");
  EXPECT_EQ(said("/* a"), "m.js:1:1: this comment does not end");
  EXPECT_EQ(said(std::string(100000, '[')), "m.js:1:100001: the text ends too early");
  EXPECT_NE(said("var a = {b: " + std::string(100000, '[')).find("nested more than 64 deep"),
            std::string::npos);
}

TEST(Facemotion, TakesWhatJavaScriptTakes) {
  const std::string odd = "\xEF\xBB\xBF" + with("'zygomaticus': {", "'zygo\\u006daticus': {\n");
  EXPECT_EQ(said(odd), "a face");
  EXPECT_EQ(said(with("var tiny", "export const tiny")), "a face");
  EXPECT_EQ(said(with("var tiny", "module.exports.tiny")), "a face");
  EXPECT_EQ(said(with("var tiny = ", "")), "a face");
  EXPECT_EQ(said(with("'stiffness': 20", "stiffness: 0x14")), "a face");
  EXPECT_EQ(imported(with("'stiffness': 20", "stiffness: 0x14")).model->muscles.stiffness, 20);
}

/// Every truncation and every change of a byte: a face or an error, never a crash or a hang.
TEST(Facemotion, SurvivesDamage) {
  int faces = 0;
  for (std::size_t length = 0; length < kSample.size(); length += test::kThinning) {
    const auto made = face_text_from_facemotion(kSample.substr(0, length), "m.js");
    if (made)
      ++faces;
    else
      EXPECT_FALSE(made.error().what.empty());
  }
  EXPECT_LT(faces, 5);  // without what follows the last brace
  std::string text = kSample;
  for (std::size_t at = 0; at < text.size(); at += 3 * test::kThinning)
    for (const char c : {'\0', '\n', '"', '\'', '{', '}', ',', '0', 'x', '\\', '\xFF'}) {
      const char was = std::exchange(text[at], c);
      const auto made = face_text_from_facemotion(text, "m.js");
      if (!made) {
        EXPECT_FALSE(made.error().what.empty());
      }
      text[at] = was;
    }
}

/// The published face too, thinned: each third truncation, each fifth byte changed.
/// What the importer makes is always a face.
TEST(Facemotion, SurvivesDamageToThePublishedFace) {
  std::string text = published_text();
  const auto survives = [](const std::string& damaged) {
    const auto made = face_text_from_facemotion(damaged, "m.js");
    if (!made) {
      EXPECT_FALSE(made.error().what.empty());
    } else if (const auto face = read_face_text(*made); !face) {
      ADD_FAILURE() << sentence(face.error());
    }
  };
  for (std::size_t length = 0; length < text.size(); length += 3) survives(text.substr(0, length));
  for (std::size_t at = 0; at < text.size(); at += 5) {
    const char was = std::exchange(text[at], char(at * 37 + 11));
    survives(text);
    text[at] = was;
  }
}

}  // namespace
}  // namespace mien
