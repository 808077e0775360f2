#pragma once

#include <mien/mien.h>

#include "bench/whole/frame_case.h"
#include "bench/whole/timing.h"

namespace mien::bench {

/// Draws frames of one case into memory that is there already, and times them [ms].
class FrameDrawer {
 public:
  FrameDrawer(const FrameCase& c, const Subject& subject, int threads, Blend blend = Blend::srgb,
              Depth depth = Depth::u8);

  /// Pose to pixels.
  double frame(const Face& face, const Pose& pose);
  /// Scene to pixels.
  double draw(const Scene& scene);

  const View& view() const { return view_; }
  std::size_t pixel_count() const { return pixel_count_; }
  const std::uint32_t* pixels() const { return pixels_.data(); }

 private:
  const Subject& subject_;
  View view_;
  std::size_t pixel_count_;
  Pixels pixels_;
  PixelBuffer buffer_;
  RenderOptions how_;
  Renderer renderer_;
};

}  // namespace mien::bench
