#pragma once
// A renderer that remembers: for programs that draw frame after frame.
//
//   mien::Renderer renderer;                                      // once
//   renderer.render_into(buffer, scene, view, {.threads = {1}});  // every frame
//
// The same pixels as render_into, and the same promises: whatever was drawn before. It keeps its
// scratch: on one thread a frame allocates nothing after the first ones of its kind. And it keeps
// finished rows, once two frames in a row have something in common: rows made from the same as in the
// frame before are copied, the others drawn. Pictures of more than 16 MiB, and those
// of thousands of layers, are always drawn whole. Every row is written in every call: what the buffer
// held does not matter.

#include <mien/render.h>

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
  Expected<Done> render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                             const RenderOptions& how = {}, RenderStats* stats = nullptr);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace mien
