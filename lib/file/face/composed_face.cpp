#include <mien/composed_face.h>
#include "lib/base/memory_ran_out.h"

namespace mien {

Expected<Face> face_from_code(std::string_view code) try {
  const auto read = read_face_code(code);
  if (!read) return read.error();
  const auto recipe = recipe_from_code(*read);
  if (!recipe) return recipe.error();
  return face_from_recipe(*recipe);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
