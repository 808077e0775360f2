#include <mien/face_model.h>
#include <mien/face_pointers.h>
#include "lib/base/memory_ran_out.h"

#include "lib/file/face/placed_face_private.h"

namespace mien {

Expected<std::vector<std::string>> face_pointers(std::string_view text, std::string_view name,
                                                 const FaceLimits& limits,
                                                 const Letters& letters) try {
  const auto read = read_placed_face(text, name, nullptr, limits, letters);
  if (!read) return read.error();
  std::vector<std::string> pointers(read->face.model->controls.size());
  for (const SlicePlace& place : read->places) {
    const JsonNode* node = read->tree.at(place.node);
    pointers.push_back(node ? read->tree.pointer(*node) : std::string{});
  }
  return pointers;
} catch (const std::bad_alloc&) {
  return memory_ran_out(name);
}

}  // namespace mien
