#include "tools/mien/cli/serve_options.h"

#include "command_app_private.h"

namespace mien::command {

void add_serve(CLI::App& app, ServeArguments& to) {
  CLI::App* serve = app.add_subcommand(
      "serve",
      "Serve pictures of faces over HTTP: /CODE.png and /seed/WORD.svg, posed and drawn as the "
      "keys behind a ? say, /A66CB-AA5S0-14.png?size=128&emotion=joy (docs/serve.md); the address "
      "is printed, and Ctrl-C ends it");
  serve
      ->add_option("--listen", to.listen,
                   "Where to listen; 0.0.0.0 is every address of this machine, port 0 any that is "
                   "free; default 127.0.0.1:6437")
      ->type_name("ADDRESS:PORT");
  serve
      ->add_option("--max-size", to.most_size,
                   "Pixels that a picture's side has at most; default 1024")
      ->type_name("N");
  serve->add_option("--cache", to.cache, "MiB of pictures that are kept; 0: none; default 64")
      ->type_name("MIB");
  serve->add_option("--threads", to.threads, "Threads that draw; 0, the default: all cores")
      ->type_name("N");
  serve
      ->add_option("--queue", to.queue,
                   "Pictures that may wait for a thread; whoever asks for more is told to ask "
                   "again; default 256")
      ->type_name("N");
  serve
      ->add_option("--timeout", to.timeout,
                   "Seconds that a picture may take, a request to arrive, and an answer to be "
                   "taken; default 10")
      ->type_name("SECONDS");
}

}  // namespace mien::command
