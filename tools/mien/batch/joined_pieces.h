#pragma once
// One file of pieces that are all there.

#include "tools/mien/batch/items.h"
#include "tools/mien/batch/opened_batch.h"

#include <string>
#include <vector>

namespace mien::command {

/// Makes the file that `first`, the number of the first piece, and those after it are joined to: a picture of regions and a film of
/// frames with the bytes that one run of the command would have written, an experiment's manifest. `hashes`: of all items. Errors have
/// been printed; the exit code tells.
int join_pieces(const OpenedBatch& batch, long first, const std::vector<std::string>& hashes);

}  // namespace mien::command
