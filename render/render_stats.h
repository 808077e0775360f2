#pragma once
// Where the work of drawing went. It is always counted; the cost is negligible.

#include <algorithm>

namespace mien {

/// The work that drawing a picture took.
struct RenderStats {
  long long pixels = 0;         ///< drawn
  long long fill_pixels = 0;    ///< in runs of one colour
  long long varied_pixels = 0;  ///< in runs of a colour that varies
  long long edge_pixels = 0;    ///< crossed by visible outlines
  long long resolved_pixels =
      0;  ///< those of them resolved by distances, because nothing else was proven
  long long recalled_pixels = 0;  ///< copied from the frame before (Renderer)
  long long pieces = 0;           ///< pieces of outline
  long long crossings = 0;        ///< of those pieces with each other
  long long regions = 0;          ///< different sets of outlines that places are inside of
  long long doubts = 0;           ///< places where the order of outlines could not be proven
  long long roots = 0;            ///< solved, where visible pieces meet rows and columns of pixels
  long long distances = 0;        ///< solved for light and for gradients along a distance
  long long steps = 0;            ///< of work, as RenderLimits counts them
  long long memory = 0;           ///< [bytes] that outlines, their order and regions held at most
  /// Time of these over all threads: of roots with summing, of distances with the means and light that ask for them.
  double root_seconds = 0, distance_seconds = 0;
  bool cancelled = false;

  /// Adds the work of another part of the same picture. Outlines and regions are counted for the whole.
  void add(const RenderStats& part) {
    cancelled = cancelled || part.cancelled;
    pixels += part.pixels, fill_pixels += part.fill_pixels, varied_pixels += part.varied_pixels;
    edge_pixels += part.edge_pixels, resolved_pixels += part.resolved_pixels, roots += part.roots;
    recalled_pixels += part.recalled_pixels, distances += part.distances;
    root_seconds += part.root_seconds, distance_seconds += part.distance_seconds;
    pieces = std::max(pieces, part.pieces), crossings = std::max(crossings, part.crossings);
    regions = std::max(regions, part.regions), doubts = std::max(doubts, part.doubts);
    steps += part.steps, memory = std::max(memory, part.memory);
  }
};

}  // namespace mien
