#pragma once
// The peer: Cairo's image surface, drawing what peer_drawing made of a scene.

#include <memory>

#include "bench/whole/peer_drawing.h"

namespace mien::bench {

/// Draws into the caller's pixels: 0xAARRGGBB each, rows of 4 · width bytes.
class CairoPicture {
 public:
  CairoPicture(const PeerDrawing& drawing, std::uint32_t* pixels);
  ~CairoPicture();

  /// A whole frame: background, then every figure, with new paths.
  void draw();

 private:
  struct Surface;
  const PeerDrawing& drawing_;
  std::unique_ptr<Surface> surface_;
};

}  // namespace mien::bench
