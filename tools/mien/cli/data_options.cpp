#include "tools/mien/cli/data_options.h"

#include "command_app_private.h"

namespace mien::command {

void add_chernoff(CLI::App& app, ChernoffArguments& to) {
  CLI::App* chernoff = app.add_subcommand("chernoff", "Draw each row of a table as a face");
  chernoff->add_option("TABLE", to.table, "CSV file with a heading")->required()->type_name("");
  chernoff->add_option("-o,--output", to.output, "Picture to write")->required()->type_name("FILE");
  chernoff
      ->add_option("--map", to.map,
                   "JSON: which column moves what; default: columns of numbers move, in their "
                   "order, what people read most exactly from faces")
      ->type_name("FILE");
  chernoff
      ->add_option("--legend", to.legend,
                   "Write what each column moves, too: its least, middle and largest value")
      ->type_name("FILE");
  chernoff
      ->add_option("--manifest", to.manifest,
                   "Write every value, too, with what it became and the SHA-256 of each face: CSV")
      ->type_name("FILE");
  chernoff->add_option("--style", to.style, "How faces are painted; default the map's")
      ->type_name("STYLE");
  chernoff->add_option("--cell", to.cell, "Pixels of a face's longer side; default 160")
      ->type_name("N");
  chernoff->add_option("--columns", to.columns, "Faces in a row; default 10")->type_name("N");
  chernoff->add_option("--gap", to.gap, "White pixels between faces; default 0")->type_name("N");
}

void add_stimuli(CLI::App& app, StimuliArguments& to) {
  CLI::App* stimuli = app.add_subcommand(
      "stimuli", "Draw the pictures of an experiment, and a manifest that can draw them again");
  stimuli
      ->add_option("PLAN", to.plan,
                   "JSON: factors, crossed or sampled; or a manifest: its pictures again, which "
                   "must be the same bytes")
      ->required()
      ->type_name("");
  stimuli->add_option("-o,--output", to.output, "Folder for pictures and manifest.json")
      ->required()
      ->type_name("FOLDER");
}

}  // namespace mien::command
