// Any bytes as a part of one's own: refused in a sentence, or a face.

#include <mien/composed_face.h>
#include <mien/pose.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const std::string text(reinterpret_cast<const char*>(data), size);
  // The family that the part says it is of, if any does.
  for (const PartFamily& family : part_families()) {
    if (text.find('"' + family.name + '"') == std::string::npos) continue;
    Recipe recipe;
    recipe.parts[family.name] = "own.part.json";
    recipe.own_parts["own.part.json"] = {"own.part.json", text};
    const auto face = face_from_recipe(recipe);
    if (!face) {
      fuzz::require_sentence(face.error());
      continue;
    }
    for (const double number : pose_face(*face, {.time = 1.25}).vector)
      fuzz::require(std::isfinite(number));
  }
  return 0;
}
