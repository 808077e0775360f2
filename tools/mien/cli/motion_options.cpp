#include "tools/mien/cli/motion_options.h"
#include "tools/mien/cli/option_words.h"

namespace mien::command {

void add_animate(CLI::App& app, AnimateArguments& to) {
  CLI::App* animate =
      app.add_subcommand("animate", "Draw many moments of a face, as pictures or as a film");
  add_pose(animate, to.render.posed);
  animate
      ->add_option("-o,--output", to.render.output,
                   "Pictures like frames/%05d.png, or a film: .mp4 .webm .webp .apng .gif")
      ->required()
      ->type_name("FILE");
  animate->add_option("--frames", to.frames, "Which frames, FIRST-LAST, counted from 0")
      ->type_name("A-B");
  animate->add_option("--fps", to.fps, "Frames a second; default 30")->type_name("N");
  animate->add_flag("--again", to.again, "Draw pictures anew that an earlier run finished");
  add_picture(animate, to.render);
  add_threads(animate, to.render);
  animate
      ->add_option("--progress", to.render.progress,
                   "auto: a bar on a terminal for work of over a second; json: lines for programs")
      ->type_name(std::string(kProgress));
}

void add_morph(CLI::App& app, MorphArguments& to) {
  CLI::App* morph = app.add_subcommand("morph", "Morph targets");
  morph->require_subcommand(1);
  CLI::App* make = morph->add_subcommand(
      "make", "Make targets out of a face file and the same face in other shapes");
  make->add_option("REST", to.rest, "The face at rest")->required()->type_name("");
  make->add_option("TARGETS", to.targets, "Face files, or NAME=FILE")
      ->required()
      ->type_name("")
      ->expected(1, 1 << 10);
  make->add_option("-o,--output", to.output, "Targets to write")->required()->type_name("FILE");

  CLI::App* from_obj = morph->add_subcommand(
      "from-obj", "Make targets out of OBJ heads whose vertices a map binds to the face's points");
  from_obj->parse_complete_callback([&to] { to.from_obj = true; });
  from_obj->add_option("FACE", to.rest, "The face at rest")->required()->type_name("");
  from_obj->add_option("MAP", to.map, "Which vertices move which points")
      ->required()
      ->type_name("");
  from_obj->add_option("NEUTRAL", to.neutral, "The head at rest, OBJ")->required()->type_name("");
  from_obj->add_option("TARGETS", to.targets, "The head in other shapes, OBJ files or NAME=FILE")
      ->required()
      ->type_name("")
      ->expected(1, 1 << 10);
  from_obj->add_option("-o,--output", to.output, "Targets to write")->required()->type_name("FILE");
}

void add_mesh(CLI::App& app, MeshArguments& to) {
  CLI::App* mesh = app.add_subcommand(
      "mesh", "Draw a head of triangles, its targets, and how far each point goes");
  mesh->add_option("NEUTRAL", to.neutral, "The head at rest, OBJ")->required()->type_name("");
  mesh->add_option("TARGETS", to.targets, "The head in other shapes, OBJ files or NAME=FILE")
      ->type_name("")
      ->expected(0, 1 << 10);
  mesh->add_option("-o,--output", to.output, "Picture to write")->required()->type_name("FILE");
  mesh->add_option("--weight", to.weights,
                   "Draw a mix instead of all targets: this one by so much, 1 if none is said; may "
                   "be given many times")
      ->type_name("NAME[=WEIGHT]")
      ->allow_extra_args(false);
  mesh->add_option("--yaw", to.yaw, "Turn the head to its left by so many degrees")->type_name("A");
  mesh->add_option("--pitch", to.pitch, "Tip its face down by so many degrees")->type_name("A");
  mesh->add_option("--size", to.size, "Pixels of the longer side of each picture; default 320")
      ->type_name("N");
}

}  // namespace mien::command
