#pragma once

#include "tools/mien/cli/serve_arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_serve(CLI::App& app, ServeArguments& to);

}  // namespace mien::command
