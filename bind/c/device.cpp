// Pictures for small displays.

#include <mien/device_pixels.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "bind/c/view_private.h"

using namespace mien::c;

namespace {

constexpr mien_device_pixels kPixels{.size = sizeof(mien_device_pixels), .format = MIEN_RGB565};

mien::DeviceBuffer device_buffer(const mien_device_pixels* given, const mien::PixelRect& rect) {
  const mien_device_pixels p = whole_struct(given, kPixels, "pixels");
  if (p.format < MIEN_RGB565 || p.format > MIEN_MONO)
    misuse("pixels.format", "is " + std::to_string(p.format) + ", not 0 to 3");
  const auto format = mien::DeviceFormat(p.format);
  if (rect.width < 1 || rect.height < 1) refuse("view.region", "has no pixel in the picture");
  if (!p.data) misuse("pixels.data", "is NULL");
  const std::size_t row = mien::device_row_bytes(format, rect.width);
  const bool by_two = p.format == MIEN_RGB565 || p.format == MIEN_RGB565_SWAPPED;
  if (by_two && (reinterpret_cast<std::uintptr_t>(p.data) % 2 || p.stride % 2))
    misuse("pixels", "data and stride are multiples of 2 bytes");
  if (p.stride < row)
    misuse("pixels.stride", "is " + std::to_string(p.stride) + ", and a row needs " +
                                std::to_string(row) + " bytes");
  if (p.bytes < row || (p.bytes - row) / p.stride < std::size_t(rect.height) - 1)
    misuse("pixels.bytes", "is " + std::to_string(p.bytes) + ", too few for " +
                               std::to_string(rect.height) + " rows");
  return {p.data, p.stride, format};
}

}  // namespace

extern "C" {

void mien_device_pixels_init(mien_device_pixels* pixels, size_t size) {
  init_struct(pixels, size, kPixels);
}

mien_status mien_render_for_device(const mien_scene* scene, const mien_view* view,
                                   const mien_device_pixels* pixels,
                                   const mien_render_options* options, mien_error** error) {
  return pass("mien_render_for_device", error, [&] {
    const mien::View seen = view_of(view);
    const mien::DeviceBuffer out = device_buffer(pixels, mien::drawn_rect(seen));
    mien::RenderOptions how = options_of(options);
    bool cancelled = false;
    if (how.progress)
      how.progress = [&cancelled, ask = how.progress](double done) {
        return !(cancelled = !ask(done));
      };
    const auto done = mien::render_for_device(out, need(scene, "scene").scene, seen, how);
    if (!done) fail(done.error(), cancelled);
  });
}
}
