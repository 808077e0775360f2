#pragma once
// The command line: one definition, from which reading, help, man page and completion are made.

#include "tools/mien/cli/animate_arguments.h"
#include "tools/mien/cli/arguments.h"
#include "tools/mien/cli/batch_arguments.h"
#include "tools/mien/cli/pca_arguments.h"
#include "tools/mien/cli/serve_arguments.h"
#include "tools/mien/cli/studio_arguments.h"

#include <string>
#include <variant>

namespace mien::command {

/// Nothing to run: text for standard output ("--help"), or what was wrong with the line.
struct Help {
  std::string text;
};
struct WrongUse {
  std::string sentence;
};

using CommandLine =
    std::variant<Help, WrongUse, RenderArguments, BenchArguments, CheckArguments, SceneArguments,
                 ListArguments, SetArguments, PcaArguments, MorphArguments, MeshArguments,
                 AnimateArguments, SayArguments, ImportArguments, FitArguments, SheetArguments,
                 NewArguments, CodeArguments, PartsArguments, ChernoffArguments, StimuliArguments,
                 StudioArguments, ServeArguments, BatchArguments, JoinArguments>;

CommandLine read_command_line(int count, const char* const* words);

}  // namespace mien::command
