#include <mien/composed_face.h>
#include <mien/recipe.h>

#include <gtest/gtest.h>

#include <set>

namespace mien {
namespace {

TEST(Recipe, ASeedIsAlwaysTheSamePerson) {
  for (const std::uint64_t seed : {std::uint64_t{0}, seed_from_word("hello")}) {
    const Recipe a = recipe_from_seed(seed), b = recipe_from_seed(seed);
    EXPECT_EQ(a.parts, b.parts);
    EXPECT_EQ(a.numbers, b.numbers);
    EXPECT_EQ(read_face_code(a.code).value().seed, seed);
  }
}

TEST(Recipe, CodesHoldPartsAndNumbers) {
  FaceCode code{.seed = seed_from_word("hello")};
  for (const char* text : {"hair=bob", "glasses=none", "eye.size=1.1", "age=70"})
    code.held.push_back(read_held_value(text).value());
  const auto recipe = recipe_from_code(read_face_code(face_code_text(code)).value());
  ASSERT_TRUE(recipe);
  EXPECT_EQ(recipe->parts.at("hair"), "bob");
  EXPECT_FALSE(recipe->parts.contains("glasses"));
  EXPECT_NEAR(recipe->numbers.at("eye.size"), 1.1, 0.4 / 2046 + 1e-12);  // half a step of its range
  EXPECT_NEAR(recipe->numbers.at("age"), 70, 83 / 2046.0 + 1e-12);
}

TEST(Recipe, HoldingOnePartChangesNoOther) {
  const Recipe plain = recipe_from_seed(99);
  FaceCode code{.seed = 99, .held = {read_held_value("hair=afro").value()}};
  Recipe held = recipe_from_code(code).value();
  held.parts["hair"] = plain.parts.at("hair");
  EXPECT_EQ(held.parts, plain.parts);
  EXPECT_EQ(held.numbers, plain.numbers);
}

TEST(Recipe, WithoutAnExpressionTheRestStays) {
  const FaceCode code{.seed = 99, .held = {read_held_value("mouth=grin").value()}};
  const Recipe grins = recipe_from_code(code).value();
  Recipe neutral = neutral_recipe(grins);
  EXPECT_EQ(neutral.parts.at("mouth"), "wide");
  EXPECT_EQ(neutral.numbers.at("smile"), 0);
  EXPECT_EQ(neutral.numbers.at("mood"), 0);
  neutral.parts["mouth"] = "grin";
  EXPECT_EQ(neutral.parts, grins.parts);
}

TEST(Recipe, ValuesThatAreWrongAreNamed) {
  const auto what = [](std::string_view text) { return read_held_value(text).error().what; };
  EXPECT_NE(what("hair=bbo").find("did you mean \"bob\""), std::string::npos);
  EXPECT_NE(what("hiar=bob").find("did you mean \"hair\""), std::string::npos);
  EXPECT_NE(what("eye.size=9").find("0.7 to 1.3"), std::string::npos);
  EXPECT_NE(what("eye.size=nan").find("a number"), std::string::npos);
  EXPECT_NE(what("hair").find("NAME=VALUE"), std::string::npos);
  EXPECT_EQ(read_held_value("eye.size=9", true).value().value, 1023);
  EXPECT_FALSE(recipe_from_code({.held = {{999, 0}}}));
  EXPECT_FALSE(recipe_from_code({.held = {{6, 900}}}));
  Recipe recipe = recipe_from_seed(1);
  recipe.numbers["chin"] = 5;
  EXPECT_NE(face_text_from_recipe(recipe).error().what.find("chin goes from"), std::string::npos);
  recipe.numbers.clear(), recipe.style = "inc";
  EXPECT_NE(face_text_from_recipe(recipe).error().what.find("did you mean \"ink\""),
            std::string::npos);
}

TEST(Recipe, PeopleAreMany) {
  std::map<std::string, std::set<std::string>> seen;
  int children = 0, elders = 0, dark = 0;
  constexpr int kPeople = 2000;
  for (int i = 0; i < kPeople; ++i) {
    const Recipe recipe = recipe_from_seed(seed_from_word(std::to_string(i)));
    for (const auto& [family, part] : recipe.parts) seen[family].insert(part);
    children += recipe.numbers.at("age") < 13, elders += recipe.numbers.at("age") >= 65;
    dark += recipe.numbers.at("skin.tone") > 5.5;
  }
  for (const PartFamily& family : part_families())
    for (const std::string& part : family.parts)
      EXPECT_EQ(seen[family.name].contains(part), part != "pointed")  // ears of fairy tales
          << family.name << "/" << part;
  EXPECT_NEAR(children / double(kPeople), 0.13, 0.03);
  EXPECT_NEAR(elders / double(kPeople), 0.13, 0.03);
  EXPECT_NEAR(dark / double(kPeople), 0.5, 0.05);
}

/// What nobody should have by chance.
TEST(Recipe, PeopleAreDressedAndGroomedAsPeopleAre) {
  const auto part = [](const Recipe& recipe, const char* family) -> std::string {
    const auto own = recipe.parts.find(family);
    return own == recipe.parts.end() ? "none" : own->second;
  };
  int smiling = 0, moody = 0, downturned = 0;
  constexpr int kPeople = 4000;
  for (int i = 0; i < kPeople; ++i) {
    const Recipe recipe = recipe_from_seed(seed_from_word(std::to_string(i)));
    const auto is = [&](const char* family, std::string_view name) {
      return part(recipe, family) == name;
    };
    const bool bearded = !is("beard", "none") || !is("moustache", "none");
    if (recipe.numbers.at("age") < 18) {
      EXPECT_FALSE(bearded) << recipe.code;
      EXPECT_EQ(recipe.numbers.at("make_up"), 0) << recipe.code;
      EXPECT_FALSE(is("lashes", "wing")) << recipe.code;
    }
    EXPECT_FALSE(is("aid", "eye_patch") && !is("glasses", "none")) << recipe.code;
    EXPECT_FALSE(bearded && (is("lashes", "wing") || is("lashes", "long"))) << recipe.code;
    const bool is_costume =
        is("clothes", "kurta") || is("clothes", "hanfu") || is("clothes", "sari_edge");
    EXPECT_FALSE(is_costume && (is("headwear", "cap") || is("headwear", "beanie"))) << recipe.code;
    smiling += recipe.numbers.at("smile") >= 0.3;
    moody += recipe.numbers.at("mood") > 0.1;
    downturned += is("mouth", "downturned");
  }
  EXPECT_NEAR(smiling / double(kPeople), 0.95, 0.03);
  EXPECT_NEAR(moody / double(kPeople), 1 / 3.0, 0.04);
  EXPECT_NEAR(downturned / double(kPeople), 0.01, 0.005);
}

/// Every part with every style, each on some head, reads without an error.
TEST(Recipe, EveryPartIsAFace) {
  for (const PartFamily& family : part_families())
    for (const std::string& part : family.parts)
      for (const std::string& style : part_styles()) {
        Recipe recipe = recipe_from_seed(seed_from_word(part));
        recipe.parts[family.name] = part, recipe.style = style;
        const auto face = face_from_recipe(recipe);
        ASSERT_TRUE(face) << family.name << "=" << part << " " << style << ": "
                          << face.error().where << ": " << face.error().what;
      }
}

}  // namespace
}  // namespace mien
