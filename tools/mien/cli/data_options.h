#pragma once
// The commands that make faces of data and of experiments: chernoff, stimuli.

#include "tools/mien/cli/arguments.h"

namespace CLI {
class App;
}

namespace mien::command {

void add_chernoff(CLI::App& app, ChernoffArguments& to);
void add_stimuli(CLI::App& app, StimuliArguments& to);

}  // namespace mien::command
