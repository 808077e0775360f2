#include "tools/mien/cli/pca_options.h"
#include "tools/mien/cli/option_words.h"

namespace mien::command {
namespace {

using Verb = PcaArguments::Verb;

CLI::App* add_verb(CLI::App* pca, PcaArguments& to, Verb verb, const char* name,
                   const char* description) {
  CLI::App* command = pca->add_subcommand(name, description);
  command->parse_complete_callback([&to, verb] { to.verb = verb; });
  return command;
}

void add_input(CLI::App* to, PcaArguments& pca) {
  to->add_option("FRAMES", pca.input, "Frames: .npy [F, V, D] or [F, N], or a face (.json)")
      ->required()
      ->type_name("");
}

void add_basis(CLI::App* to, PcaArguments& pca) {
  to->add_option("BASIS", pca.basis, "A basis that `mien pca fit` wrote")
      ->required()
      ->type_name("");
}

void add_output(CLI::App* to, PcaArguments& pca, const char* what) {
  to->add_option("-o,--output", pca.output, what)->required()->type_name("FILE");
}

void add_frames_of_face(CLI::App* to, PcaArguments& pca) {
  to->add_option("--frames", pca.frames, "Of a face: frames FIRST-LAST; default 0-239")
      ->type_name("A-B");
  to->add_option("--fps", pca.fps, "Of a face: frames a second; default 30")->type_name("N");
  to->add_option("--set", pca.settings, "Of a face: hold a control or a number at a value")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_mesh(CLI::App* to, PcaArguments& pca) {
  to->add_option("--mesh", pca.mesh, "Of vertices: an OBJ file whose triangles are drawn")
      ->type_name("FILE");
  to->add_option("--face", pca.face, "Of a face's basis: the face file")->type_name("FILE");
  to->add_option("--size", pca.size, "Pixels of the longer side of each picture; default 512")
      ->type_name("N");
}

void add_fit(CLI::App* pca, PcaArguments& to) {
  CLI::App* fit = add_verb(pca, to, Verb::fit, "fit", "Find the basis of an animation");
  add_input(fit, to);
  add_output(fit, to, "Basis to write");
  fit->add_option("--components", to.components, "So many components")->type_name("N");
  fit->add_option("--variance", to.variance, "The fewest that hold this share of the variance")
      ->type_name("SHARE");
  fit->add_option("--max-error", to.max_error,
                  "The fewest with which no vertex of any frame is farther off than this")
      ->type_name("E");
  add_frames_of_face(fit, to);
  fit->add_option("--size", to.size,
                  "Of a face: errors are pixels of a picture with so many on its longer side")
      ->type_name("N");
}

}  // namespace

void add_pca(CLI::App& app, PcaArguments& to) {
  CLI::App* pca = app.add_subcommand("pca", "Principal components of an animation");
  pca->require_subcommand(1);
  add_fit(pca, to);

  CLI::App* info =
      add_verb(pca, to, Verb::info, "info", "Say what a basis holds: bytes, ratio, error curve");
  add_basis(info, to);
  info->add_option("--plot", to.plot, "Picture of the error curve to write")->type_name("FILE");

  CLI::App* encode = add_verb(pca, to, Verb::encode, "encode", "Weights of frames, as .npy [F, n]");
  add_basis(encode, to);
  add_input(encode, to);
  add_output(encode, to, "Weights to write");

  CLI::App* decode =
      add_verb(pca, to, Verb::decode, "decode", "Frames out of weights, as .npy [F, V, D]");
  add_basis(decode, to);
  decode->add_option("WEIGHTS", to.weights, "Weights, .npy [F, n]; default: the basis's own")
      ->type_name("");
  add_output(decode, to, "Frames to write");

  CLI::App* compare = add_verb(pca, to, Verb::compare, "compare",
                               "Draw a frame, its reconstruction and their difference");
  add_basis(compare, to);
  add_input(compare, to);
  compare->add_option("-o,--output", to.output, "Picture to write")->type_name("FILE");
  compare->add_option("--frame", to.frame, "Which frame; default: the worst")->type_name("N");
  add_frames_of_face(compare, to);
  add_mesh(compare, to);

  CLI::App* sheet =
      add_verb(pca, to, Verb::sheet, "sheet", "Draw the mean and what each component does");
  add_basis(sheet, to);
  add_output(sheet, to, "Picture to write");
  sheet->add_option("--spread", to.spread, "How many standard deviations to each side; default 2")
      ->type_name("K");
  add_mesh(sheet, to);
}

}  // namespace mien::command
