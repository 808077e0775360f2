// Text made to hurt: huge, deep, cut short and damaged, through the reader that all of it goes into.
#include "lib/file/json/json_tree.h"

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "tests/support/faces/face_text.h"
#include "tests/support/faces/posing.h"
#include "tests/support/process/effort.h"

namespace mien {
namespace {

using test::face_with;
using test::said;

TEST(JsonTree, RefusesAMillionPointsAndDeepNestingAtOnce) {
  std::string points = "[0, 0]";
  for (int i = 1; i < 1'000'000; ++i) points += ",[0,0]";
  EXPECT_NE(said(face_with(R"({"name": "a", "kind": "polyline", "half_width": 1, "points": [)" +
                           points + "]}"))
                .find("(limit: "),
            std::string::npos);
  EXPECT_NE(said(std::string(10'000, '[')).find("(limit: nesting)"), std::string::npos);
  EXPECT_NE(said(std::string(10'000'000, '[')).find("(limit: nesting)"), std::string::npos);
  std::string objects;
  for (int i = 0; i < 10'000; ++i) objects += "{\"a\":";
  EXPECT_NE(said(objects).find("(limit: nesting)"), std::string::npos);
}

/// What grows with the square of the text would run into the suite's time limit here.
TEST(JsonTree, StaysFastOnHostileText) {
  std::string keys = "{\"format\": \"mien-face\"";
  for (int i = 0; i < test::times(200'000); ++i) keys += ", \"k" + std::to_string(i) + "\": 0";
  std::vector<Error> warnings;
  EXPECT_FALSE(read_face_text(keys + "}", "f", {}, &warnings));
  EXPECT_EQ(warnings.size(), 100u);
  std::string many;
  for (int i = 0; i < test::times(20'000); ++i)
    many += (i ? ",{\"name\":\"n" : "{\"name\":\"n") + std::to_string(i) +
            R"(","kind":"disc","side":"left","center":[0,0],"radius":1})";
  EXPECT_EQ(said(face_with(many)), "a face");
  EXPECT_NE(
      said(face_with(many + R"(,{"name":"x","kind":"disc","center":"@n9/centre","radius":1})"))
          .find("did you mean"),
      std::string::npos);
  std::string controls = R"({"name": "c", "range": [0, 1], "rest": 0})",
              tracks = R"("c": {"keys": [[0, 0]]})";
  for (int i = 0; i < test::times(50'000); ++i) {
    controls += R"(, {"name": "c)" + std::to_string(i) + R"(", "range": [0, 1], "rest": 0})";
    tracks += ", \"c" + std::to_string(i) + R"(": {"keys": [[0, 0]]})";
  }
  EXPECT_EQ(said(face_with(
                "", ", \"controls\": [" + controls + "], \"clips\": {\"idle\": {" + tracks + "}}")),
            "a face");
}

/// C would end such a name early, and no file or picture could show it.
TEST(JsonTree, RefusesTextsAndKeysWithANul) {
  EXPECT_EQ(said("{\"name\": \"a\\u0000b\"}"), "f:1:10: /name: a NUL character, which no text has");
  EXPECT_EQ(said("{\n  \"na\\u0000me\": 1}"), "f:2:3: a NUL character, which no text has");
}

/// What every text must give: a face whose numbers can all be posed, or one line about it.
void expect_face_or_sentence(const std::string& text, long& faces) {
  const Expected<Face> face = read_face_text(text, "f");
  if (face) {
    ++faces;
    ASSERT_EQ(pose_face(*face, {.time = 0.3}).vector.size(), face->model->layout.size());
  } else {
    const std::string line = sentence(face.error());
    ASSERT_TRUE(line.starts_with("f:")) << line;
    ASSERT_EQ(line.find('\n'), std::string::npos) << line;
    ASSERT_LT(line.size(), 600u) << line;
  }
}

// Damage. The suite tries the smaller faces, a value or so per byte. The long form tries all faces:
// MIEN_EVERY_BYTE=1 every truncation, and at every byte each of its bits turned and each of kBytes;
// MIEN_EVERY_BYTE=255 every other value instead (hours).
// With -DMIEN_LONG_TESTS=ON `ctest -L long` runs the first.

constexpr char kBytes[] = {'\0', '"', '[', '}', '-', '9', 'e', ',', ' ', '\\', '\x80', '\xFF'};

std::vector<std::string> damaged_faces() {
  if (!std::getenv("MIEN_EVERY_BYTE")) return {"seed0", "toon", "male"};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_SOURCE_DIR "/faces/compat")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".face.json")) names.push_back(name.substr(0, name.find('.')));
  }
  std::ranges::sort(names);
  return names;
}

/// Reads damaged texts, and counts what became of them.
class Damage {
 public:
  void read(const std::string& text) {
    expect_face_or_sentence(text, faces_);
    ++texts_;
  }
  void report(const std::string& name, const char* what) const {
    if (std::getenv("MIEN_EVERY_BYTE"))
      fmt::print("{}: {} {}, {} still faces, the others one line each\n", name, texts_, what,
                 faces_);
  }

 private:
  long texts_ = 0, faces_ = 0;
};

TEST(JsonTree, SurvivesEveryTruncation) {
  const bool every = std::getenv("MIEN_EVERY_BYTE");
  for (const std::string& name : damaged_faces()) {
    const std::string text = test::text_of_face(name);
    Damage damage;
    for (std::size_t length = 0; length < text.size(); length += every ? 1 : test::kThinning)
      damage.read(text.substr(0, length));
    damage.report(name, "truncations");
  }
}

TEST(JsonTree, FindsMembersInOneGo) {
  constexpr KnownKeys<3> kKeys({"x", "y", "xy"});
  const std::string text = R"({"xy": 1, "w": 2, "x": 3, "v": 4})";
  const auto tree = JsonTree::read(text, "t", {});
  const JsonNode* other = nullptr;
  const auto has = tree->members(tree->root(), kKeys, &other);
  ASSERT_TRUE(has[0] && has[2]);
  EXPECT_EQ(has[0]->number, 3);
  EXPECT_EQ(has[1], nullptr);
  EXPECT_EQ(has[2]->number, 1);
  ASSERT_TRUE(other);
  EXPECT_EQ(tree->key(*other), "w") << "the first";
  EXPECT_EQ(tree->members(*has[0], kKeys)[0], nullptr) << "a number has none";
}

TEST(JsonTree, SurvivesSingleByteChanges) {
  const char* asked = std::getenv("MIEN_EVERY_BYTE");
  const bool all = asked && std::atoi(asked) == 255;
  for (const std::string& name : damaged_faces()) {
    std::string text = test::text_of_face(name);
    Damage damage;
    std::size_t turn = 0;
    for (std::size_t at = 0; at < text.size(); at += asked ? 1 : 3 * test::kThinning) {
      const char was = text[at];
      std::set<char> values;
      if (!asked) values.insert(kBytes[turn++ % sizeof kBytes]);
      for (int bit = 0; asked && bit < 8; ++bit) values.insert(char(was ^ (1 << bit)));
      if (asked) values.insert(std::begin(kBytes), std::end(kBytes));
      for (int value = 0; all && value < 256; ++value) values.insert(char(value));
      values.erase(was);
      for (const char value : values) {
        text[at] = value;
        damage.read(text);
      }
      text[at] = was;
    }
    damage.report(name, "changed bytes");
  }
}

}  // namespace
}  // namespace mien
