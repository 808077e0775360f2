#pragma once
// Whether all that parts recorded is the whole of a plan.

#include "tools/mien/batch/opened_batch.h"

#include <mien/expected.h>

#include <string>
#include <vector>

namespace mien::command {

/// The SHA-256 of each item, in the plan's order, once all manifests of the folder have been compared with the plan and with each
/// other. Splits into different numbers of parts may stand beside each other where they agree. Errors, with their file: parts of
/// another plan, version or class of instructions; items that are missing, that the plan does not have, that belong to another part
/// or stand there twice.
Expected<std::vector<std::string>> recorded_items(const OpenedBatch& batch);

}  // namespace mien::command
