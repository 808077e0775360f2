#include "tools/mien/cli/batch_options.h"

#include "command_app_private.h"

namespace mien::command {

void add_batch(CLI::App& app, BatchArguments& to) {
  CLI::App* batch = app.add_subcommand(
      "batch", "Draw a plan's many files, or one part of them, and go on where a run was ended");
  batch
      ->add_option("PLAN", to.plan,
                   "JSON: jobs, each a command and what varies in it (docs/scale.md)")
      ->required()
      ->type_name("");
  batch->add_option("-o,--output", to.output, "Folder for the files and what is recorded of them")
      ->required()
      ->type_name("FOLDER");
  batch
      ->add_option("--part", to.part,
                   "Only the K-th of N parts, for one of N workers; default 1/1, everything")
      ->type_name("K/N");
}

void add_join(CLI::App& app, JoinArguments& to) {
  CLI::App* join = app.add_subcommand(
      "join",
      "Check that every file of a plan is there and whole, and make one picture, film or "
      "experiment of pieces");
  join->add_option("PLAN", to.plan, "The plan that `mien batch` did")->required()->type_name("");
  join->add_option("FOLDER", to.folder, "Where all its parts are")->required()->type_name("");
}

}  // namespace mien::command
