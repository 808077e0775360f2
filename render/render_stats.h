#pragma once
// Where the work of drawing went. Counted always: it costs nothing beside the drawing.

namespace mien {

/// What drawing a picture took.
struct RenderStats {
  long long pixels = 0;           ///< drawn
  long long fill_pixels = 0;      ///< in tiles of one colour
  long long one_edge_pixels = 0;  ///< by the one-edge closed form
  long long divided_pixels = 0;   ///< resolved per cell
  long long varied_pixels = 0;    ///< where a gradient, light or a group's opacity is seen
  long long cells = 0;            ///< cells those were divided into
  bool cancelled = false;

  void add(const RenderStats& part) {
    pixels += part.pixels;
    fill_pixels += part.fill_pixels;
    one_edge_pixels += part.one_edge_pixels;
    divided_pixels += part.divided_pixels;
    varied_pixels += part.varied_pixels;
    cells += part.cells;
  }
};

}  // namespace mien
