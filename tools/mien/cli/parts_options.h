#pragma once
// The commands that make faces of parts, and try them: new, code, parts, check.

#include "tools/mien/cli/arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_new(CLI::App& app, NewArguments& to);
void add_code(CLI::App& app, CodeArguments& to);
void add_parts(CLI::App& app, PartsArguments& to);
void add_check(CLI::App& app, CheckArguments& to);

}  // namespace mien::command
