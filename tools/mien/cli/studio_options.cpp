#include "tools/mien/cli/studio_options.h"

#include "command_app_private.h"

namespace mien::command {

void add_studio(CLI::App& app, StudioArguments& to) {
  CLI::App* studio = app.add_subcommand(
      "studio",
      "Serve the studio, a page where faces are made, to browsers on this machine; its address is "
      "printed, and Ctrl-C ends it");
  studio
      ->add_option("--port", to.port,
                   "Port of the loopback; 0: any that is free; default 6436, or any if another "
                   "program has that one")
      ->type_name("N");
  studio
      ->add_option("--folder", to.folder,
                   "The web package's folder; default: where it is installed, share/mien/web")
      ->type_name("FOLDER");
}

}  // namespace mien::command
