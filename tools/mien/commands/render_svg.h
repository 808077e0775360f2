#pragma once
// mien render FACE -o FACE.svg: shapes instead of pixels.

#include <mien/expected.h>
#include <mien/svg.h>
#include "tools/mien/cli/arguments.h"
#include "tools/mien/commands/render_plan.h"

namespace mien::command {

/// By the extension, in any case.
bool asks_for_svg(const RenderArguments& arguments);

/// An error about an option that only means something for pixels.
Expected<Done> check_svg_options(const RenderArguments& arguments);

/// How a planned picture is written as shapes.
SvgOptions svg_options(const RenderArguments& arguments, const RenderPlan& plan,
                       const Progress& progress);

/// What the SVG file leaves out or simplifies is printed as warnings. Returns the exit code.
int render_svg(const RenderArguments& arguments);

}  // namespace mien::command
