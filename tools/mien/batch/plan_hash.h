#pragma once
// One hash for all that a plan says.

#include "tools/mien/batch/batch_plan.h"

#include <mien/expected.h>

#include <string>
#include <string_view>

namespace mien::command {

/// SHA-256 of the plan's text and of every file that its words name, so that pieces drawn before a face file was changed are not
/// taken for this plan's. Files that those files name in turn are not looked at.
Expected<std::string> plan_hash(const BatchPlan& plan, std::string_view text);

}  // namespace mien::command
