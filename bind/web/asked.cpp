// How the page that draws is asked whether to go on: a call out of the module, to what mien.js answers.

#include "bind/c/mien_c.h"

extern "C" {

__attribute__((import_module("env"), import_name("mien_asks_to_go_on"))) int mien_asks_to_go_on(
    double done);

static int32_t ask(double done, void*) {
  return mien_asks_to_go_on(done) == 0;
}

/// Options of mien_render that ask.
const mien_render_options* mien_asking_options() {
  static mien_render_options options;
  mien_render_options_init(&options, sizeof options);
  options.progress = ask;
  return &options;
}
}
