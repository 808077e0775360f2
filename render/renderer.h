#pragma once
// A renderer for programs that draw frame after frame: it keeps memory and finished rows.
//
//   mien::Renderer renderer;                                      // once
//   renderer.render_into(buffer, scene, view, {.threads = {1}});  // every frame
//
// It gives the same pixels and keeps the same promises as render_into, whatever was drawn before. Scratch
// memory is kept: on one thread, after the first frames of a kind, a frame allocates nothing. Finished rows
// are kept too, once two consecutive frames have something in common. Rows that nothing different since the
// frame before can reach are copied; all others are drawn. Pictures of more than 16 MiB and pictures of
// thousands of layers are always drawn whole. Every call writes every row, so the buffer's previous
// contents do not matter. Besides those rows, what was made of the scene before is held once more.

#include <mien/render.h>

#include <memory>

namespace mien {

/// Draws one picture at a time. Threads that draw at the same time need a renderer each.
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
