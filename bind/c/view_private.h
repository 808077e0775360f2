#pragma once
// Views, pixels and options of the C interface as those of the library.

#include <mien/render.h>
#include "bind/c/mien_c.h"

namespace mien::c {

View view_of(const mien_view* view);
Depth depth_of(int32_t depth, std::string_view argument);
/// The pixels, which hold at least `width` x `height`.
PixelBuffer buffer_of(const mien_pixels* pixels, int width, int height);
RenderOptions options_of(const mien_render_options* options);
/// Throws why a drawing did not succeed.
[[noreturn]] void fail(const Error& error, bool cancelled);

}  // namespace mien::c
