#pragma once
// The sure way through a picture: squares cut into quarters until each is one colour or one pixel.
// For layers that the fast way (band.h) does not know.

#include <mien/render/image.h>
#include <mien/render/render_stats.h>
#include <mien/render/tile/tape.h>

#include <cstddef>
#include <span>

namespace mien {

/// Where the drawn pixels go.
struct Target {
  std::byte* data;
  std::size_t stride;  ///< [bytes]
  Depth depth;
  PixelRect rect;  ///< the part of the picture that `data` holds
};

/// Draws the square whose top left pixel is (x, y) of a picture of width × height, as far as the
/// target shows it. `side` is a power of 2.
void draw_square(const Tape& tape, int width, int height, int x, int y, int side,
                 const Target& target, RenderStats& stats);

/// The same where these layers alone, top to bottom, can be seen in the square.
void draw_square(const Tape& tape, std::span<const int> layers, int width, int height, int x, int y,
                 int side, const Target& target, RenderStats& stats);

}  // namespace mien
