#pragma once
// What batch and join begin with: a plan that was read in its own folder, and the folder of its files.

#include "tools/mien/batch/batch_plan.h"

#include <mien/expected.h>

#include <filesystem>
#include <string>

namespace mien::command {

struct OpenedBatch {
  BatchPlan plan;
  std::filesystem::path folder;  ///< absolute
};

/// Takes this process into the plan's folder, so that names in the plan lead from there.
Expected<OpenedBatch> open_batch(const std::string& plan, const std::string& folder);

}  // namespace mien::command
