#pragma once
// One picture of its regions.

#include "tools/mien/batch/items.h"
#include "tools/mien/batch/opened_batch.h"

#include <filesystem>

namespace mien::command {

/// Writes the picture with the bytes that `mien render` would have written, strip by strip: of a picture of any size little is held.
/// `item` is the first region, whose number is `first`. Errors have been printed; the exit code tells.
int join_regions(const OpenedBatch& batch, const BatchItem& item, long first,
                 const std::filesystem::path& to);

}  // namespace mien::command
