#pragma once
// `mien pca …` on the command line.

#include "tools/mien/cli/pca_arguments.h"

#include <CLI/CLI.hpp>

namespace mien::command {

/// Adds the command with its verbs; they fill `to`.
void add_pca(CLI::App& app, PcaArguments& to);

}  // namespace mien::command
