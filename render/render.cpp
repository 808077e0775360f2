#include <mien/render.h>
#include <mien/renderer.h>
#include "lib/base/memory_ran_out.h"
#include "render/render_error.h"

#include <new>

namespace mien {

Expected<Image> render(const Scene& scene, const View& view, const RenderOptions& how,
                       RenderStats* stats) try {
  Image image{.depth = how.depth};
  if (drawable(view)) {  // else the renderer says what is wrong
    const PixelRect rect = drawn_rect(view);
    image.width = rect.width, image.height = rect.height;
    image.opaque = view.background.value_or(scene.background()).a >= 1.0;
    try {
      image.bytes.resize(image.stride() * std::size_t(rect.height));  // at most 2^44 bytes
    } catch (const std::bad_alloc&) {
      return out_of_memory(rect);
    }
  }
  const PixelBuffer out{image.bytes.data(), image.stride(), how.depth};
  if (auto done = Renderer().render_into(out, scene, view, how, stats); !done) return done.error();
  return image;
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

Expected<Done> render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                           const RenderOptions& how, RenderStats* stats) try {
  return Renderer().render_into(out, scene, view, how, stats);
} catch (const std::bad_alloc&) {
  return memory_ran_out();
}

}  // namespace mien
