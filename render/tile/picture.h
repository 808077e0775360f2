#pragma once
// The picture cut into tiles, and tiles into quarters, until a square is one colour or one pixel.

#include <mien/render/image.h>
#include <mien/render/render_stats.h>
#include <mien/render/tile/tape.h>

#include <cstddef>

namespace mien {

/// Where the drawn pixels go.
struct Target {
  std::byte* data;
  std::size_t stride;  ///< [bytes]
  Depth depth;
  PixelRect rect;  ///< the part of the picture that `data` holds
};

/// Side of the squares that are handed to threads [px], at absolute positions of the whole picture:
/// larger makes fewer, longer jobs and less to decide again at the top; smaller spreads small
/// pictures over threads.
inline constexpr int kTile = 128;

/// Draws the tile whose top left pixel is (x, y) of a picture of width × height, as far as the
/// target shows it.
void draw_tile(const Tape& tape, int width, int height, int x, int y, const Target& target,
               RenderStats& stats);

}  // namespace mien
