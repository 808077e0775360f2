#pragma once
// The definition itself. CLI11 compiles slowly: this header is for the files that need it.

#include "tools/mien/cli/animate_arguments.h"
#include "tools/mien/cli/arguments.h"
#include "tools/mien/cli/batch_arguments.h"
#include "tools/mien/cli/pca_arguments.h"
#include "tools/mien/cli/serve_arguments.h"
#include "tools/mien/cli/studio_arguments.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

namespace mien::command {

/// The application and what it fills.
struct CommandApp {
  CLI::App app{"mien draws vector faces exactly.", "mien"};
  RenderArguments render;
  BenchArguments bench;
  CheckArguments check;
  SceneArguments scene;
  ListArguments list;
  SetArguments set;
  PcaArguments pca;
  MorphArguments morph;
  MeshArguments mesh;
  AnimateArguments animate;
  SayArguments say;
  ImportArguments import;
  FitArguments fit;
  SheetArguments sheet;
  NewArguments make;
  CodeArguments code;
  PartsArguments parts;
  ChernoffArguments chernoff;
  StimuliArguments stimuli;
  BatchArguments batch;
  JoinArguments join;
  StudioArguments studio;
  ServeArguments serve;
  std::optional<std::string> progress;  ///< of every command that has it
  std::string shell;                    ///< of `mien completion`
  bool markdown = false;                ///< of `mien manual`
};

std::unique_ptr<CommandApp> command_app();

/// Adds --seed WORD. An empty word is refused: it is mostly a shell's variable that was never set.
void add_seed(CLI::App& command, std::optional<std::string>& to, const std::string& help);

/// The command that was typed: "fit" of `mien pca fit`.
const CLI::App& innermost_command(const CLI::App& app);
/// Names of its commands, after commas.
std::string command_list(const CLI::App& app);

/// What was wrong with words that `app` could not read, in one sentence.
std::string wrong_use(const CLI::App& app, const CLI::ParseError& wrong);

/// Made from the definition: a man page (groff), docs/command.md, and completion for bash, zsh or fish.
std::string manual(const CLI::App& app);
std::string command_page(const CLI::App& app);
std::string completion(const CLI::App& app, const std::string& shell);

/// Commands that people see, and an option's visible names.
std::vector<const CLI::App*> visible_commands(const CLI::App& app);
/// Those that run: `fit` of `pca` instead of `pca`; and how people say them, "pca fit".
std::vector<const CLI::App*> leaf_commands(const CLI::App& app);
std::string spoken_name(const CLI::App& command);
std::vector<const CLI::Option*> visible_options(const CLI::App& app);
std::vector<std::string> option_words(const CLI::Option& option);

}  // namespace mien::command
