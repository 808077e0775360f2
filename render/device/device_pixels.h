#pragma once
// Pictures for small displays: rows as a controller takes them, in the caller's buffer.
//
//   std::vector<std::uint16_t> frame(240 * 240);
//   mien::render_for_device({frame.data(), 480, mien::DeviceFormat::rgb565}, scene, {.width = 240, .height = 240});

#include <mien/api.h>
#include <mien/render.h>

#include <cstddef>

namespace mien {

/// How a display's memory holds a pixel. No format has alpha: what a picture leaves open is black.
enum class DeviceFormat {
  rgb565,          ///< red in the five upper bits of 16, in the machine's byte order
  rgb565_swapped,  ///< the same with its two bytes exchanged, as most displays on a serial bus want it
  bgrx,            ///< blue, green, red and a byte of 255, the levels of Depth::u8
  mono  ///< a bit a pixel, 1 for white, the leftmost in a byte's uppermost; rows begin on whole bytes
};

/// Rows that the caller owns, `stride` bytes apart.
struct DeviceBuffer {
  void* data = nullptr;    ///< aligned for 16 bits where the format is
  std::size_t stride = 0;  ///< [bytes]
  DeviceFormat format = DeviceFormat::rgb565;
};

/// The bytes of a row of `width` pixels.
MIEN_API std::size_t device_row_bytes(DeviceFormat format, int width);

/// Draws drawn_rect(view) as render (render.h) does, in bands, and never holds the whole picture in any other format.
/// With View::dither every pixel of rgb565 and mono is rounded by the ordered dither of 8 × 8 pixels, flat colours too:
/// over each 8 × 8 pixels of one colour the mean is right to 1/128 of a step between levels. Those of rgb565 are
/// sRGB-encoded; the step of mono is one of linear light, which is how far white and black pixels mix in the eye. Without
/// it levels are rounded to the nearest, and mono is white from an encoded luminance of one half. `how.depth` does not
/// count. Errors as for render.
MIEN_API Expected<Done> render_for_device(const DeviceBuffer& out, const Scene& scene,
                                          const View& view, const RenderOptions& how = {});

}  // namespace mien
