#pragma once
// The picture that regions are pieces of.

#include "tools/mien/cli/arguments.h"
#include "tools/mien/commands/render_plan.h"

namespace mien::command {

/// How `mien render` would draw it, without --region. Errors have the option's or the face's address.
Expected<RenderPlan> whole_picture(const RenderArguments& arguments);

}  // namespace mien::command
