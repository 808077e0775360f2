#pragma once
// A renderer that remembers: for programs that draw frame after frame.
//
//   mien::Renderer renderer;                                      // once
//   renderer.render_into(buffer, scene, view, {.threads = {1}});  // every frame
//
// The same pixels as render_into, and the same promises; only the scratch is kept. On one thread a
// frame allocates nothing after the first one of its kind, paths, strokes of varying width and paints
// that vary aside, which are made ready anew.

#include <mien/render/render.h>

#include <memory>

namespace mien {

/// Draws one picture at a time; threads that draw at the same time need one each.
class MIEN_API Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// See render_into (render.h).
  bool render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                   const RenderOptions& how = {}, RenderStats* stats = nullptr);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace mien
