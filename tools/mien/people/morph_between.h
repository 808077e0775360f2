#pragma once
// mien morph between: pictures of one person becoming another.

#include "tools/mien/cli/animate_arguments.h"

namespace mien::command {

/// Returns the exit code.
int morph_between(const MorphArguments& arguments);

}  // namespace mien::command
