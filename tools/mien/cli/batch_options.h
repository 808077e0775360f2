#pragma once
// The options of `mien batch` and `mien join`.

#include "tools/mien/cli/batch_arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_batch(CLI::App& app, BatchArguments& to);
void add_join(CLI::App& app, JoinArguments& to);

}  // namespace mien::command
