#pragma once
// A tape made ready for tiles: what depends on the frame alone, once per frame.

#include <mien/lib/geom/box2.h>
#include <mien/render/tile/tape.h>
#include <mien/sdf/edge/classify.h>
#include <mien/sdf/edge/leaf_edges.h>

#include <cstdint>
#include <vector>

namespace mien {

/// A colour as a pixel of 8 bits a channel.
std::uint32_t packed_pixel(const Mix& mix, Blend blend);

struct Plan {
  Plan(const Tape& tape, Depth depth);
  /// Again, after the tape was made anew; memory is kept.
  void make(Depth depth);

  const Tape& tape;
  Depth depth;
  long made = 0;                       ///< how often
  std::vector<Classifier> squares;     ///< by outline
  std::vector<LeafOutlines> outlines;  ///< by outline
  std::vector<Box2> outline_boxes;  ///< nothing of the outline's inside is beyond; may be infinite
  std::vector<Box2> layer_boxes;    ///< by layer, the same
  std::vector<std::uint32_t> packed;  ///< by layer: its colour as a pixel of 8 bits, if opaque
  std::uint32_t background;
  bool plain;        ///< all layers are
  double tolerance;  ///< [px] how far an outline may be off in a leaf

 private:
  std::vector<Box2> stack_;
};

}  // namespace mien
