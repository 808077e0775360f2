// Pictures of what moves a face, and of how it is drawn.

#include <mien/debug_picture.h>
#include <mien/face_model.h>
#include <mien/morph_heat.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "bind/c/view_private.h"
#include "sdf/from_face/debug_view.h"

#include <cstring>

namespace mien::c {
namespace {

/// Without letters: the C interface has no fonts.
Scene debug_scene(mien_pose& pose, int32_t which) {
  const Face& posed = pose.posed();
  switch (which) {
    case MIEN_DEBUG_MUSCLES:
      if (posed.model->muscles.muscles.empty()) refuse("muscles", "this face has no muscles");
      return debug_muscles(posed, pose.pulls(), {});
    case MIEN_DEBUG_POINTS:
      return debug_points(posed, {});
    case MIEN_DEBUG_MORPH:
      return morph_heat(pose.face, posed).scene;
    default:
      misuse("which", "is " + std::to_string(which) + ", not 0 to 2");
  }
}

}  // namespace
}  // namespace mien::c

using namespace mien::c;

extern "C" {

mien_status mien_scene_debug(mien_pose* pose, int32_t which, mien_scene** out, mien_error** error) {
  return pass("mien_scene_debug", error, [&] {
    mien_scene*& made = place(out);
    made = new mien_scene{debug_scene(need(pose, "pose"), which)};
  });
}

mien_status mien_debug_picture(const mien_scene* scene, const mien_view* view, int32_t which,
                               const mien_pixels* pixels, const mien_render_options* options,
                               mien_error** error) {
  return pass("mien_debug_picture", error, [&] {
    const mien::Scene& seen = need(scene, "scene").scene;
    const mien::View how = view_of(view);
    if (which < MIEN_DEBUG_OUTLINES || which > MIEN_DEBUG_NORMALS)
      misuse("which", "is " + std::to_string(which) + ", not 0 to 5");
    const mien::PixelRect rect = mien::drawn_rect(how);
    const mien::PixelBuffer buffer = buffer_of(pixels, rect.width, rect.height);
    if (buffer.depth != mien::Depth::u8) misuse("pixels.depth", "is not MIEN_U8");
    mien::RenderOptions drawn = options_of(options);
    bool cancelled = false;
    if (drawn.progress)
      drawn.progress = [&, asked = drawn.progress](double done) {
        return !(cancelled = !asked(done));
      };
    const auto made = mien::debug_picture(seen, how, mien::DebugPicture(which), drawn);
    if (!made) fail(made.error(), cancelled);
    const mien::Image& image = *made;
    for (int y = 0; y < rect.height; ++y)
      std::memcpy(static_cast<std::byte*>(buffer.data) + std::size_t(y) * buffer.stride,
                  image.bytes.data() + std::size_t(y) * image.stride(), image.stride());
  });
}
}
