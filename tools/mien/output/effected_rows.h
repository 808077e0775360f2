#pragma once
// A picture with effects, from the top down. Effects see the whole picture, even where only a region
// of it is kept: it is drawn in strips of all its width, from its top to where the region's last row
// is known.

#include <mien/effect_chain.h>
#include <mien/renderer.h>

#include <vector>

namespace mien::command {

class EffectedRows {
 public:
  /// `strip`: rows drawn at once. Scene and view outlive it.
  EffectedRows(const Scene& scene, const View& view, const RenderOptions& how,
               const std::vector<Effect>& effects, int strip);
  EffectedRows(const EffectedRows&) = delete;  // its chain asks it for rows

  /// The region's next rows, at how.depth. Errors as for render_into. Throws std::bad_alloc.
  Expected<Image> next(int rows, const Progress& progress);

  const RenderStats& stats() const { return stats_; }

  /// Memory for each row of a strip.
  static std::uint64_t row_bytes(const View& view, Depth depth);

 private:
  bool draw_row(float* row);
  bool draw_strip();

  const Scene& scene_;
  const View& view_;
  RenderOptions how_;
  const Depth depth_;
  const int strip_;
  EffectChain chain_;
  Renderer renderer_;
  RenderStats stats_;
  Error error_;                            ///< why a strip was not drawn
  int drawn_ = 0, taken_ = 0, given_ = 0;  ///< rows of the whole picture
  std::vector<float> drawn_rows_, row_;
};

}  // namespace mien::command
