#include "lib/parts/recipe/recipe_file.h"
#include <mien/composed_face.h>
#include <mien/face_file.h>
#include <mien/face_model.h>

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(RecipeFile, IsTheSameFaceAsItsCode) {
  const Recipe recipe = recipe_from_seed(seed_from_word("hello"));
  const auto file = read_face_text(recipe_text(recipe), "hello");
  ASSERT_TRUE(file) << file.error().where << ": " << file.error().what;
  const Face code = face_from_code(recipe.code).value();
  EXPECT_EQ(file->vector, code.vector);
  EXPECT_EQ(file->model->features.size(), code.model->features.size());
}

std::string refusal(const std::string& members) {
  const auto face =
      read_face_text(R"({"format": "mien-face", "format_version": 2, )" + members + "}", "f");
  return face ? "read" : face.error().where + ": " + face.error().what;
}

TEST(RecipeFile, TenLinesAreAFace) {
  EXPECT_EQ(
      refusal(
          R"("name": "otto", "parts": {"hair": "fringe_of_hair", "beard": {"part": "full"}, "glasses": null, "headwear": null},
                       "numbers": {"age": 76, "eye.size": 0.86}, "style": "soft")"),
      "read");
}

TEST(RecipeFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(refusal(R"("parts": {"hair": "bbo"})"),
            "f:1:64: /parts/hair: no hair named \"bbo\"; did you mean \"bob\"?");
  EXPECT_NE(refusal(R"("parts": {"hiar": "bob"})").find("did you mean \"hair\""),
            std::string::npos);
  EXPECT_NE(refusal(R"("parts": {"head": null})").find("always"), std::string::npos);
  EXPECT_NE(refusal(R"("numbers": {"chin": 3})").find("/numbers/chin: chin goes from"),
            std::string::npos);
  EXPECT_NE(refusal(R"("numbers": {"chni": 0})").find("did you mean \"chin\""), std::string::npos);
  EXPECT_NE(refusal(R"("style": "inc")").find("/style"), std::string::npos);
  EXPECT_NE(refusal(R"("code": "Z0000-00000-01")").find("/code: a sign is wrong"),
            std::string::npos);
  EXPECT_NE(refusal(R"("edition": "Q")")
                .find("/edition: edition Q is not known to this version, which has A"),
            std::string::npos);
  EXPECT_NE(refusal(R"("code": "Z66CB-AA5S0-1B")").find("/code: edition Z is not known"),
            std::string::npos);
  EXPECT_NE(refusal(R"("edition": "ZZ")").find("which has"), std::string::npos);
  EXPECT_NE(refusal(R"("edition": 3)").find("/edition"), std::string::npos);
  EXPECT_NE(refusal(R"("parts": [])").find("/parts"), std::string::npos);
}

TEST(RecipeFile, IsReadFromItsText) {
  const Recipe recipe = recipe_from_seed(seed_from_word("hello"));
  const auto read = read_recipe_text(recipe_text(recipe), "hello");
  ASSERT_TRUE(read) << read.error().what;
  EXPECT_EQ(read->code, recipe.code);
  EXPECT_EQ(read->parts, recipe.parts);
  const auto in_full = read_recipe_text(face_text_from_recipe(recipe).value(), "full");
  ASSERT_FALSE(in_full);
  EXPECT_NE(in_full.error().what.find("in full"), std::string::npos);
  EXPECT_EQ(in_full.error().where.substr(0, 5), "full:");
  EXPECT_FALSE(read_recipe_text("{", "half"));
  EXPECT_FALSE(read_recipe_text(R"({"format": "mien-face", "format_version": 2,
                                    "parts": {"hair": "mine.part.json"}})",
                                "own"));
}

}  // namespace
}  // namespace mien
