// Parts of one's own: begun, found, worn.

#include "lib/parts/recipe/own_part.h"

#include <mien/composed_face.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "lib/parts/recipe/part_guide.h"
#include "tests/support/process/scratch_folder.h"

namespace mien {
namespace {

using test::ScratchFolder;

bool draws(const PartFamily& family) {
  const std::vector<std::string> colors{"hair_color", "iris",   "cloth_color",
                                        "backdrop",   "accent", "frame_color"};
  return std::ranges::find(colors, family.name) == colors.end();
}

TEST(OwnPart, BegunOnesAreWornAsTheyAre) {
  const ScratchFolder folder;
  int families = 0;
  for (const PartFamily& family : part_families()) {
    const auto text = part_skeleton(family.name, "mine");
    EXPECT_EQ(text.has_value(), draws(family)) << family.name;
    if (!text) continue;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
    EXPECT_EQ(text->find(",\n    \"adds\""), std::string::npos) << "a point is in one piece";
    const auto path = folder / (family.name + ".part.json");
    std::ofstream(path) << *text;
    const auto part = read_part_file(path);
    ASSERT_TRUE(part) << sentence(part.error());
    EXPECT_EQ(part->family, family.name);
    Recipe recipe;
    wear(recipe, *part);
    const auto face = face_from_recipe(recipe);
    EXPECT_TRUE(face) << sentence(face.error());
    ++families;
  }
  EXPECT_GE(families, 14);
  const auto all = read_part_folder(folder / "");
  ASSERT_TRUE(all);
  EXPECT_EQ(int(all->size()), families);
  EXPECT_TRUE(std::ranges::is_sorted(*all, {}, [](const FoundPart& one) { return one.part.path; }));
}

/// They begin with the plainest part and with what its names mean.
TEST(OwnPart, BegunOnesAreExplained) {
  const std::vector<std::pair<std::string, std::string>> wanted{
      {"head", "oval"}, {"eyes", "almond"}, {"mouth", "soft"}, {"nose", "soft"}};
  for (const auto& [family, part] : wanted) {
    const auto text = part_skeleton(family, "mine");
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("Begun as the family's \\\"" + part), std::string::npos) << *text;
    std::istringstream lines{std::string(part_guide(family))};
    for (std::string line; std::getline(lines, line);) {
      for (std::size_t at = 0; (at = line.find('"', at)) != std::string::npos; at += 2)
        line.insert(at, 1, '\\');
      EXPECT_NE(text->find("\"" + line + "\""), std::string::npos) << line;
    }
  }
}

TEST(OwnPart, WrongOnesAreToldAtTheirPlace) {
  const ScratchFolder folder;
  const auto error_of = [&](const std::string& text) {
    const auto path = folder / "a.part.json";
    std::ofstream(path) << text;
    const auto part = read_part_file(path);
    return part ? std::string() : sentence(part.error());
  };
  EXPECT_NE(error_of("{").find("a.part.json:1:"), std::string::npos);
  EXPECT_NE(error_of("[]").find("a.part.json:1:1"), std::string::npos);
  EXPECT_NE(error_of(R"({"format": "mien-face"})").find("expected \"mien-part\""),
            std::string::npos);
  EXPECT_NE(error_of("{\"format\": \"mien-part\",\n \"family\": \"hiar\"}")
                .find("a.part.json:2:12: /family: no family of parts named \"hiar\"; did you mean"),
            std::string::npos);
}

TEST(OwnPart, FoldersWithoutPartsAndUnknownNamesAreErrors) {
  const ScratchFolder folder;
  EXPECT_FALSE(read_part_folder(folder / ""));
  EXPECT_FALSE(read_part_folder(folder / "nowhere"));
  EXPECT_FALSE(read_part_file(folder / "nothing.part.json"));
  EXPECT_FALSE(part_skeleton("hiar", "mine"));
  for (const char* name : {"", "A", "a b", "a/b", "../a", "ä"})
    EXPECT_FALSE(part_skeleton("hair", name)) << name;
}

}  // namespace
}  // namespace mien
