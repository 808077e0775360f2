#pragma once
// The commands that make faces of parts: new, parts.

#include "tools/mien/cli/arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_new(CLI::App& app, NewArguments& to);
void add_parts(CLI::App& app, PartsArguments& to);

}  // namespace mien::command
