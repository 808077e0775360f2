// Any bytes as morph targets of a face, which are then laid on it.

#include <mien/face_model.h>
#include <mien/morph_file.h>
#include <mien/pose.h>

#include <cmath>
#include <cstdint>

#include "fuzz/support/require.h"
#include "fuzz/support/small_face.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const auto face =
      read_morphs_text(fuzz::small_face(), {reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!face) {
    fuzz::require_sentence(face.error());
    return 0;
  }
  Pose all;
  for (std::size_t c = 0; c < face->model->controls.size(); ++c)
    if (face->model->controls[c].pose) all.settings.push_back({true, int(c), {1}});
  for (const double number : pose_face(*face, all).vector) fuzz::require(std::isfinite(number));
  return 0;
}
