#pragma once
// One command line, whichever command it names.

#include "tools/mien/cli/command_line.h"

namespace mien::command {

/// Looks at its files, and runs it; gives the exit code.
int run_command(const CommandLine& line);

}  // namespace mien::command
