// Scenes as SVG files.

#include <mien/svg.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "bind/c/view_private.h"

#include <iterator>

using namespace mien::c;

extern "C" {

mien_status mien_svg(const mien_scene* scene, const mien_view* view, double tolerance,
                     const char* id_prefix, size_t length, const mien_render_options* options,
                     mien_texts** out, mien_error** error) {
  return pass("mien_svg", error, [&] {
    mien_texts*& made = place(out);
    const mien::View seen = view_of(view);
    if (seen.region) refuse("view.region", "is for pictures of pixels; an SVG file holds shapes");
    const mien::RenderOptions drawn = options_of(options);
    bool cancelled = false;
    mien::SvgOptions how{.width = double(seen.width),
                         .height = double(seen.height),
                         .fit = seen.fit,
                         .legible = seen.legible,
                         .background = seen.background,
                         .id_prefix = {},
                         .limits = drawn.limits};
    if (drawn.progress)
      how.progress = [&](double done) { return !(cancelled = !drawn.progress(done)); };
    if (id_prefix || length > 0)
      how.id_prefix = std::string(text_of(id_prefix, length, "id_prefix"));
    if (tolerance != 0) how.tolerance = tolerance;
    auto svg = mien::svg_text(need(scene, "scene").scene, how);
    if (!svg) fail(svg.error(), cancelled);
    std::vector<std::string> texts{std::move(svg->text)};
    std::move(svg->simplified.begin(), svg->simplified.end(), std::back_inserter(texts));
    made = new_texts(std::move(texts));
  });
}
}
