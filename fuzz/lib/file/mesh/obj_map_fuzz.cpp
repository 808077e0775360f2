// Any bytes as a map from a mesh to a face, used at once on a mesh of three points.

#include <mien/morph_file.h>
#include <mien/obj_map.h>

#include <cstdint>

#include "fuzz/support/require.h"
#include "fuzz/support/small_face.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const Face& face = fuzz::small_face();
  const auto map = read_obj_map_text(face, {reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!map) {
    fuzz::require_sentence(map.error());
    return 0;
  }
  const Mesh neutral{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  const Mesh moved{{{0, 0, 1}, {1, 0.5, 0}, {0, -1, 0}}, {}};
  const auto text = morph_text_from_meshes(face, *map, neutral, {{"moved", moved}});
  if (!text)
    fuzz::require_sentence(text.error());
  else if (const auto made = read_morphs_text(face, *text); !made)
    fuzz::require_sentence(made.error());
  return 0;
}
