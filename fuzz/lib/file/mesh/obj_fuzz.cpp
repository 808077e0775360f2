// Any bytes as an OBJ mesh, and what is accepted as a scene.

#include <mien/obj.h>

#include <cmath>
#include <cstdint>

#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const auto mesh = read_obj_text({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!mesh) {
    fuzz::require_sentence(mesh.error());
    return 0;
  }
  for (const glm::dvec3& p : mesh->points)
    fuzz::require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  for (const auto& triangle : mesh->triangles)
    for (const int corner : triangle)
      fuzz::require(corner >= 0 && std::size_t(corner) < mesh->points.size());
  return 0;
}
