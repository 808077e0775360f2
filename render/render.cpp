#include <mien/render.h>
#include <mien/renderer.h>

#include <new>

namespace mien {
namespace {

/// The empty image, where no other can be given.
Image no_image(Depth depth) {
  return {.depth = depth};
}

bool drawable(const View& view) {
  const auto valid = [](int side) { return side >= 1 && side <= View::kMaxSide; };
  return valid(view.width) && valid(view.height);
}

bool opaque(const Scene& scene, const View& view) {
  return view.background.value_or(scene.background()).a >= 1.0;
}

}  // namespace

Image render(const Scene& scene, const View& view, const RenderOptions& how, RenderStats* stats) {
  if (!drawable(view)) return no_image(how.depth);
  try {
    const PixelRect rect = drawn_rect(view);
    Image image{.width = rect.width, .height = rect.height, .depth = how.depth};
    image.opaque = opaque(scene, view);
    image.bytes.resize(image.stride() * std::size_t(rect.height));  // at most 2^44 bytes
    RenderStats took;
    Renderer renderer;
    const bool done = renderer.render_into({image.bytes.data(), image.stride(), how.depth}, scene,
                                           view, how, &took);
    if (!done && !took.cancelled) return no_image(how.depth);
    if (stats) *stats = took;
    return image;
  } catch (const std::bad_alloc&) {
    return no_image(how.depth);
  }
}

bool render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                 const RenderOptions& how, RenderStats* stats) {
  return Renderer().render_into(out, scene, view, how, stats);
}

}  // namespace mien
