#include "lib/parts/recipe/person_seed.h"

namespace mien {

std::uint64_t person_seed(const Recipe& recipe) {
  if (recipe.code.empty()) {
    Recipe unstyled = recipe;
    unstyled.style.clear();
    return seed_from_word(recipe_text(unstyled));
  }
  const auto code = read_face_code(recipe.code);
  return seed_from_word(code ? face_code_text(*code) : recipe.code);
}

}  // namespace mien
