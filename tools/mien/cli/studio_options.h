#pragma once

#include "tools/mien/cli/studio_arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_studio(CLI::App& app, StudioArguments& to);

}  // namespace mien::command
