#include "tools/mien/cli/command_line.h"
#include <mien/version.h>
#include "render/image/file_type.h"
#include "tools/mien/cli/batch_options.h"
#include "tools/mien/cli/data_options.h"
#include "tools/mien/cli/motion_options.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/cli/parts_options.h"
#include "tools/mien/cli/pca_options.h"
#include "tools/mien/cli/serve_options.h"
#include "tools/mien/cli/studio_options.h"
#include "tools/mien/commands/render_plan.h"
#include "tools/mien/terminal/progress_display.h"

#include "command_app_private.h"

namespace mien::command {

namespace {

void add_debug(CLI::App* to, std::optional<std::string>& debug) {
  to->add_option("--debug", debug,
                 "Draw over the face what moves it: its muscles by their pull, or its points and "
                 "handles by name")
      ->type_name(std::string(kFaceDebugs));
}

void add_muscle_commands(CLI::App& app, CommandApp& command) {
  CLI::App* import = app.add_subcommand(
      "import",
      "Take in another program's face: facemotion FILE (a morphology in JavaScript) makes a face "
      "file; obj-targets FACE MAP NEUTRAL TARGETS... makes morph targets, as morph from-obj does");
  import->add_option("FORMAT", command.import.format, "facemotion or obj-targets")
      ->required()
      ->type_name("");
  import->add_option("FILES", command.import.files, "Files to read")
      ->required()
      ->type_name("")
      ->expected(1, 1 << 10);
  import->add_option("-o,--output", command.import.output, "File to write; - is standard output")
      ->required()
      ->type_name("FILE");
  import->add_option("--morphology", command.import.morphology, "Which one, if there are several")
      ->type_name("NAME");
  import->add_flag("--smooth", command.import.smooth, "Draw polylines as smooth curves");

  CLI::App* fit = app.add_subcommand(
      "fit", "Find the muscle pulls that bring a face's points nearest to targets");
  fit->add_option("FACE", command.fit.face, "Face file")->required()->type_name("");
  fit->add_option("TARGETS", command.fit.targets,
                  "JSON: points by name, or a frame of ARKit's blend shapes")
      ->required()
      ->type_name("");
}

void add_output(CLI::App* to, RenderArguments& render) {
  to->add_option("-o,--output", render.output,
                 "Picture to write: " + known_extensions() +
                     ", or .svg for shapes; - is a PNG on standard output; a JPEG must be opaque")
      ->required()
      ->type_name("FILE");
}

}  // namespace

void add_picture(CLI::App* to, RenderArguments& render) {
  to->add_option("--size", render.size,
                 "Pixels of the whole picture, or of its longer side; default: longer side " +
                     std::to_string(kDefaultSide))
      ->type_name("WxH");
  to->add_option("--fit", render.fit,
                 "Show the whole canvas, centred, or fill the whole picture; default meet")
      ->type_name(std::string(kFits));
  to->add_option("--region", render.region,
                 "Draw only this part of the picture, with the same pixels")
      ->type_name("X,Y,W,H");
  to->add_option("--background", render.background,
                 "#rrggbb, #rrggbbaa or transparent, instead of the face's own")
      ->type_name("COLOUR");
  to->add_option("--blend", render.blend,
                 "Mix colours in linear light or as encoded; default linear")
      ->type_name(std::string(kBlends));
  to->add_option("--light", render.light,
                 "Where the lamp of reliefs is: x right, y up, z > 0 towards the viewer")
      ->type_name("X,Y,Z");
  to->add_option("--legible", render.legible,
                 "Lines at least so wide, for small pictures: thinner ones are drawn wider, up to "
                 "three times, or fade")
      ->type_name("PX");
  to->add_option("--dither", render.dither,
                 "Dither gradients and lit surfaces of 8 and 16 bits; default on")
      ->type_name(std::string(kDithers));
  to->add_option("--depth", render.depth,
                 "Bits of a channel: " + known_depths() + "; default the first")
      ->type_name(std::string(kDepths));
  to->add_option(
        "--effect", render.effects,
        "Lay an effect over the picture: mosaic:TILES,BORDER,mean|center or "
        "grid:CELLS,WIDTH,COLOUR; repeatable, applied in order; none: not even the face's own")
      ->type_name("EFFECT")
      ->allow_extra_args(false);
}

void add_threads(CLI::App* to, RenderArguments& render) {
  to->add_option("--threads", render.threads,
                 "Threads to draw with; 0, the default: all cores; does not change a byte")
      ->type_name("N");
}

namespace {

void add_insight(CLI::App* to, RenderArguments& render) {
  to->add_option("--debug", render.debug,
                 "Instead of the face: its outlines, regions, fragments or looks as they were "
                 "drawn, isolines "
                 "of distance, normals, or how far a pose moves each point; or over it: its "
                 "muscles, its points by name")
      ->type_name(std::string(kDebugs));
  to->add_option(
        "--error-map", render.error_map,
        "Also write a bound of every pixel's error, as grey, and print the largest; pixels "
        "whose light is not proven are half blue, and counted")
      ->type_name("FILE");
}

void add_work(CLI::App* to, RenderArguments& render) {
  to->add_option("--memory", render.memory,
                 "Most bytes that pieces of the picture hold, and that outlines hold, K M G T for "
                 "powers of 1024; default 256M, 1G")
      ->type_name("BYTES");
  to->add_option(
        "--most-steps", render.most_steps,
        "Most steps of work, each one or two nanoseconds, for one piece of the picture; default "
        "8000000000, and 1000 for each of its pixels")
      ->type_name("COUNT");
  to->add_option("--stats", render.stats,
                 "Print what drawing took, on standard output (standard error with -o -)")
      ->type_name(std::string(kStats));
}

void add_render(CLI::App& app, RenderArguments& to) {
  CLI::App* render = app.add_subcommand("render", "Draw a face into a picture");
  add_pose(render, to.posed);
  add_output(render, to);
  render
      ->add_option("--dpi", to.dpi,
                   "Pixels per inch on paper, 1 to 100000, for the file's metadata; default none, "
                   "in TIFF 72")
      ->type_name("N");
  render
      ->add_option("--id-prefix", to.id_prefix,
                   "Of an SVG file: what all ids begin with; default: made of the picture, so that "
                   "only equal pictures share ids")
      ->type_name("TEXT");
  add_picture(render, to);
  add_threads(render, to);
  add_insight(render, to);
  add_work(render, to);
}

void add_scene(CLI::App& app, CommandApp& command) {
  CLI::App* scene = app.add_subcommand("scene", "Print the shapes and layers a face is drawn with");
  add_pose(scene, command.scene.posed);
  add_debug(scene, command.scene.debug);
}

void add_list(CLI::App& app, CommandApp& command) {
  CLI::App* list = app.add_subcommand(
      "list",
      "Print every name that --set takes, with unit, range and value; then poses and clips");
  CLI::Option* face = list->add_option("FACE", command.list.face, "Face file")->type_name("");
  list->add_option(
          "--moves", command.list.moves,
          "Print what a standard name must do instead: of ARKit, FACS, VRM, visemes, Azure")
      ->type_name("NAME")
      ->excludes(face);
}

void add_set(CLI::App& app, SetArguments& to) {
  CLI::App* set = app.add_subcommand(
      "set", "Change points, numbers and colours in a face file and leave every other byte alone");
  set->add_option("FACE", to.face, "Face file")->required()->type_name("");
  set->add_option("SETTINGS", to.settings,
                  "NAME=VALUE..., as --set takes them; 'mien list FACE' names them all")
      ->required()
      ->type_name("")
      ->expected(1, 1 << 16);
  set->add_option("-o,--output", to.output, "File to write, FACE itself, too; - is standard output")
      ->required()
      ->type_name("FILE");
}

void add_bench(CLI::App& app, CommandApp& command) {
  CLI::App* bench =
      app.add_subcommand("bench", "Measure how long a frame takes, from pose to pixels");
  add_pose(bench, command.bench.render.posed);
  add_picture(bench, command.bench.render);
  add_threads(bench, command.bench.render);
  bench
      ->add_option("--repeat", command.bench.repeat,
                   "Frames to measure; default " + std::to_string(kDefaultRepeat))
      ->type_name("N");
  bench->add_flag("--json", command.bench.json, "Print JSON instead of a table");
}

/// What stands before a command's own name: "mien pca".
std::string prefix_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent->get_parent() ? "mien " + parent->get_name() : "mien";
}

CommandLine chosen(CommandApp& command) {
  const CLI::App& app = command.app;
  if (app.got_subcommand("render")) return std::move(command.render);
  if (app.got_subcommand("bench")) return std::move(command.bench);
  if (app.got_subcommand("check")) return std::move(command.check);
  if (app.got_subcommand("pca")) return std::move(command.pca);
  if (app.got_subcommand("morph")) return std::move(command.morph);
  if (app.got_subcommand("mesh")) return std::move(command.mesh);
  if (app.got_subcommand("animate")) return std::move(command.animate);
  if (app.got_subcommand("say")) return std::move(command.say);
  if (app.got_subcommand("scene")) return std::move(command.scene);
  if (app.got_subcommand("list")) return std::move(command.list);
  if (app.got_subcommand("set")) return std::move(command.set);
  if (app.got_subcommand("import")) return std::move(command.import);
  if (app.got_subcommand("fit")) return std::move(command.fit);
  if (app.got_subcommand("sheet")) return std::move(command.sheet);
  if (app.got_subcommand("new")) return std::move(command.make);
  if (app.got_subcommand("code")) return std::move(command.code);
  if (app.got_subcommand("parts")) return std::move(command.parts);
  if (app.got_subcommand("chernoff")) return std::move(command.chernoff);
  if (app.got_subcommand("stimuli")) return std::move(command.stimuli);
  if (app.got_subcommand("batch")) return std::move(command.batch);
  if (app.got_subcommand("join")) return std::move(command.join);
  if (app.got_subcommand("studio")) return std::move(command.studio);
  if (app.got_subcommand("serve")) return std::move(command.serve);
  if (app.got_subcommand("manual")) return Help{command.markdown ? command_page(app) : manual(app)};
  if (app.got_subcommand("completion")) {
    const auto shell = read_choice("completion", command.shell, kShells);
    if (!shell) return WrongUse{sentence(shell.error())};
    return Help{completion(app, command.shell)};
  }
  return WrongUse{"a command is needed: " + command_list(app) + "; mien -h helps"};
}

}  // namespace

std::string spoken_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent && parent->get_parent() ? parent->get_name() + " " + command.get_name()
                                        : command.get_name();
}

std::vector<const CLI::App*> leaf_commands(const CLI::App& app) {
  std::vector<const CLI::App*> leaves;
  for (const CLI::App* command : visible_commands(app)) {
    const auto inner = visible_commands(*command);
    if (command->get_require_subcommand_min() == 0) leaves.push_back(command);
    leaves.insert(leaves.end(), inner.begin(), inner.end());
  }
  return leaves;
}

std::vector<const CLI::App*> visible_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<const CLI::Option*> visible_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> option_words(const CLI::Option& option) {
  std::vector<std::string> words;
  for (const std::string& name : option.get_snames()) words.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.push_back("--" + name);
  return words;
}

namespace {

/// To all commands whose work may take long.
void add_progress(CommandApp& made) {
  CLI::App& app = made.app;
  for (CLI::App* command :
       {app.get_subcommand("render"), app.get_subcommand("check"), app.get_subcommand("animate"),
        app.get_subcommand("say"), app.get_subcommand("morph")->get_subcommand("between"),
        app.get_subcommand("mesh"), app.get_subcommand("pca")->get_subcommand("fit"),
        app.get_subcommand("pca")->get_subcommand("encode"),
        app.get_subcommand("pca")->get_subcommand("decode"),
        app.get_subcommand("pca")->get_subcommand("compare"),
        app.get_subcommand("pca")->get_subcommand("sheet"), app.get_subcommand("fit"),
        app.get_subcommand("sheet"), app.get_subcommand("parts"),
        app.get_subcommand("parts")->get_subcommand("check"), app.get_subcommand("chernoff"),
        app.get_subcommand("stimuli"), app.get_subcommand("batch"), app.get_subcommand("join")})
    command
        ->add_option(
            "--progress", made.progress,
            "auto: a bar on a terminal for work of over a second; json: lines for programs")
        ->type_name(std::string(kProgress));
}

}  // namespace

std::unique_ptr<CommandApp> command_app() {
  auto made = std::make_unique<CommandApp>();
  CLI::App& app = made->app;
  app.set_help_flag("-h,--help", "Show this help and exit");
  app.set_version_flag("--version", "mien " MIEN_VERSION_STRING, "Show the version and exit");
  app.get_formatter()->column_width(34);
  app.require_subcommand(0, 1);  // what follows a command is its own, though it be a command's name
  // In the order in which help and the man page list them.
  add_render(app, made->render);
  add_check(app, made->check);
  add_scene(app, *made);
  add_list(app, *made);
  add_set(app, made->set);
  add_bench(app, *made);
  add_animate(app, made->animate);
  add_say(app, made->say);
  add_morph(app, made->morph);
  add_mesh(app, made->mesh);
  add_pca(app, made->pca);
  add_muscle_commands(app, *made);
  add_sheet(app, made->sheet);
  add_new(app, made->make);
  add_code(app, made->code);
  add_parts(app, made->parts);
  add_chernoff(app, made->chernoff);
  add_stimuli(app, made->stimuli);
  add_batch(app, made->batch);
  add_join(app, made->join);
  add_studio(app, made->studio);
  add_serve(app, made->serve);
  add_progress(*made);

  app.add_subcommand("manual", "Print the man page")
      ->group("")
      ->add_flag("--markdown", made->markdown, "Print docs/command.md instead");
  CLI::App* shells = app.add_subcommand("completion", "Print completion for a shell")->group("");
  shells->add_option("SHELL", made->shell, std::string(kShells))->required()->type_name("");
  return made;
}

CommandLine read_command_line(int count, const char* const* words) {
  const auto command = command_app();
  CLI::App& app = command->app;
  try {
    app.parse(count, words);
  } catch (const CLI::CallForHelp&) {
    const auto used = app.get_subcommands();
    return Help{used.empty() ? app.help()
                             : innermost_command(app).help(prefix_of(innermost_command(app)))};
  } catch (const CLI::CallForVersion&) {
    return Help{"mien " MIEN_VERSION_STRING "\n"};
  } catch (const CLI::ParseError& wrong) {
    return WrongUse{wrong_use(app, wrong)};
  }
  if (command->progress) {
    const auto style = read_choice("--progress", *command->progress, kProgress);
    if (!style) return WrongUse{sentence(style.error())};
    use_progress(ProgressStyle(*style));
  }
  return chosen(*command);
}

}  // namespace mien::command
