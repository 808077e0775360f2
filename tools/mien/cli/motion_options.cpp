#include "tools/mien/cli/motion_options.h"
#include <mien/unwrap_mode.h>
#include "command_app_private.h"
#include "tools/mien/cli/option_words.h"

namespace mien::command {
namespace {

void add_face(CLI::App* to, PosedFace& posed) {
  to->add_option("FACE", posed.face,
                 "Face file, a code that `mien new` printed, or the name of a sample face")
      ->required()
      ->type_name("");
}

void add_paint(CLI::App* to, PosedFace& posed) {
  to->add_option("--style", posed.style,
                 "How a face by code or recipe is drawn: soft, flat, vinyl, sticker, pictogram, "
                 "peep or ink; "
                 "default soft")
      ->type_name("STYLE");
  to->add_flag("--neutral", posed.neutral,
               "No smile, lips closed, head ahead, all still, but for what other options ask");
}

/// What moves a face: clips, named poses, a basis.
void add_motion(CLI::App* to, PosedFace& posed) {
  to->add_option("--time", posed.time,
                 "Moment at which the face's clips are drawn; without one no clip runs")
      ->type_name("SECONDS");
  to->add_option(
        "--clip", posed.clips,
        "Run this clip instead of the face's default one, from BEGIN on; default weight 1, "
        "begin 0; repeatable, each acts on the result of those before it")
      ->type_name("NAME[=WEIGHT[@BEGIN]]")
      ->allow_extra_args(false);
  to->add_option("--motion", posed.motion,
                 "Follow a take of an actor: CSV of Live Link Face or OpenFace, JSON of ARKit or "
                 "MediaPipe, and others (docs/motion.md)")
      ->type_name("FILE");
  to->add_option("--speech", posed.speech,
                 "Speak a track: phones of a TextGrid, cues of Rhubarb, visemes of Azure, .pho, or "
                 "a line SECONDS<TAB>SOUND for each")
      ->type_name("FILE");
  add_seed(*to, posed.seed,
           "Blink and glance by this word's chances; default those of the face's own code, recipe "
           "or file");
  to->add_option("--liveliness", posed.liveliness,
                 "How far clips move the face, 0 (not at all) to 2; default 1")
      ->type_name("N");
  to->add_option("--gestures", posed.gestures,
                 "How far the head nods and brows rise with the stresses of speech, 0 (the mouth "
                 "alone speaks) to 2; default 1")
      ->type_name("N");
  to->add_option("--pose,--morph", posed.poses,
                 "Give a named pose (a morph target) a weight, default 1; repeatable")
      ->type_name("NAME[=WEIGHT]")
      ->allow_extra_args(false);
  to->add_option("--morphs", posed.morphs, "More poses, out of a file that `mien morph make` wrote")
      ->type_name("FILE")
      ->allow_extra_args(false);
  to->add_option("--basis", posed.basis,
                 "Pose by a basis that `mien pca fit` found for this face, at --time or --weights")
      ->type_name("FILE");
  to->add_option("--weights", posed.weights, "Weights of the basis's components")
      ->type_name("W,W,...");
}

void add_eyes_and_chart(CLI::App* to, PosedFace& posed) {
  to->add_option("--look-at", posed.look_at,
                 "The point both eyes look at, in face units, z towards the viewer")
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  to->add_option("--blink", posed.blink, "How far both eyes are shut, 0 to 1")->type_name("WEIGHT");
  to->add_option("--unwrap", posed.unwrap,
                 "How far the features have travelled from the face to a flat chart, 0 to 1")
      ->type_name("WEIGHT");
  to->add_option("--unwrap-mode", posed.unwrap_mode,
                 "All at once, the deep features first, or that and braking; default linear")
      ->type_name(std::string(kUnwrapModes));
  to->add_option("--bias", posed.bias,
                 "Where the lids meet: from -1, at the lower lid, to 1, at the upper one")
      ->type_name("BIAS");
}

void add_feelings(CLI::App* to, PosedFace& posed) {
  to->add_option(
        "--emotion", posed.emotions,
        "Give an emotion a strength from 0 to 1, default 1; left.joy and right.joy are the "
        "subject's halves; repeatable")
      ->type_name("NAME[=STRENGTH]")
      ->allow_extra_args(false);
  to->add_option("--muscle", posed.muscles,
                 "Pull a muscle by 0 to 1, whatever the emotions do; left.NAME is the subject's "
                 "left one; repeatable")
      ->type_name("NAME[=PULL]")
      ->allow_extra_args(false);
  to->add_option("--arkit", posed.arkit,
                 "A frame of ARKit's blend shapes as JSON, {\"jawOpen\": 0.4, …}; a take is as "
                 "for --motion")
      ->type_name("FILE");
  to->add_flag("--clamp", posed.clamp,
               "Take strengths and pulls beyond 0 to 1 as the nearer end instead of an error");
}

}  // namespace

namespace {

/// All that poses a face but for its name.
void add_pose_of_face(CLI::App* to, PosedFace& posed) {
  add_paint(to, posed);
  add_motion(to, posed);
  add_eyes_and_chart(to, posed);
  add_feelings(to, posed);
  to->add_option("--set", posed.settings,
                 "Hold a control or a number of the face at a value, whatever other options do; "
                 "repeatable, the last one wins; 'mien list FACE' names them all")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

}  // namespace

void add_pose(CLI::App* to, PosedFace& posed) {
  add_face(to, posed);
  add_pose_of_face(to, posed);
}

void add_animate(CLI::App& app, AnimateArguments& to) {
  CLI::App* animate =
      app.add_subcommand("animate", "Draw many moments of a face, as pictures or as a film");
  add_pose(animate, to.render.posed);
  animate
      ->add_option(
          "-o,--output", to.render.output,
          "Pictures like frames/%05d.png, or a film: .mp4 .webm .webp .apng .gif; a .png that "
          "is one file is an APNG")
      ->required()
      ->type_name("FILE");
  animate
      ->add_option(
          "--frames", to.frames,
          "Which frames, FIRST-LAST, counted from 0; default all of --motion, --speech and "
          "--sound")
      ->type_name("A-B");
  animate->add_option("--fps", to.fps, "Frames a second; default 30")->type_name("N");
  animate->add_option("--sound", to.sound, "The film's sound, from time 0 on: for .mp4 and .webm")
      ->type_name("FILE");
  animate->add_flag("--again", to.again, "Draw pictures again that an earlier run finished");
  add_picture(animate, to.render);
  add_threads(animate, to.render);
}

void add_say(CLI::App& app, SayArguments& to) {
  CLI::App* say = app.add_subcommand(
      "say", "Speak a text: a film of a face that says it, its sound, the track of its sounds");
  RenderArguments& render = to.animate.render;
  say->add_option("TEXT", to.text, "What is said; - is standard input")->type_name("");
  say->add_option("-o,--output", render.output,
                  "A film: .mp4 and .webm with the sound, .webp .apng .gif without; pictures like "
                  "frames/%05d.png; or .tsv, the track for --speech")
      ->type_name("FILE");
  say->add_option("--sound", to.animate.sound, "Also write the sound, as WAV")->type_name("FILE");
  say->add_option("--voice", to.voice,
                  "A language or voice of eSpeak NG, perhaps with a variant: en, pt-br, de+f3; "
                  "default en")
      ->type_name("VOICE");
  say->add_flag("--voices", to.voices, "Print languages and voices instead");
  say->add_option("--rate", to.rate, "Words a minute, 80 to 450; default 175")->type_name("N");
  say->add_option("--pitch", to.pitch, "How high, 0 to 100; default 50")->type_name("N");
  say->add_option("--face", render.posed.face,
                  "Who speaks: face file, code, or the name of a sample face; default toon")
      ->type_name("FACE");
  add_pose_of_face(say, render.posed);
  for (const char* whole : {"--time", "--speech"})  // the film is as long as the speech
    say->remove_option(say->get_option(whole));
  say->add_option("--fps", to.animate.fps, "Frames a second; default 30")->type_name("N");
  say->add_flag("--again", to.animate.again, "Draw pictures again that an earlier run finished");
  add_picture(say, render);
  add_threads(say, render);
}

namespace {

void add_between(CLI::App& morph, MorphArguments& to) {
  CLI::App* between = morph.add_subcommand(
      "between", "Draw one person becoming another: numbers and colours move, parts change");
  between->add_option("PEOPLE", to.people, "Two codes or recipe files")
      ->required()
      ->type_name("")
      ->expected(2);
  between
      ->add_option("-o,--output", to.output,
                   "A picture of all steps in rows, numbered pictures like frames/%03d.png, or a "
                   "film: .mp4 .webm .webp .apng .gif")
      ->required()
      ->type_name("FILE");
  between
      ->add_option("--steps", to.steps,
                   "So many, both people included; default 9, or 90 as pictures or a film")
      ->type_name("N");
  between->add_option("--at", to.at, "One picture instead: so far towards the second, 0 to 1")
      ->type_name("SHARE");
  between
      ->add_option("--parts-at", to.parts_at,
                   "Where all parts change, 0 to 1; default each at a place of its own")
      ->type_name("SHARE");
  between->add_option("--style", to.style, "How both are painted")->type_name("STYLE");
  between
      ->add_option("--size", to.size,
                   "Pixels of a step's picture, or of its longer side; default 320")
      ->type_name("WxH");
  between->add_option("--columns", to.columns, "Pictures in a row; default 9")->type_name("N");
  between->add_option("--gap", to.gap, "White pixels between pictures; default 0")->type_name("N");
  between->add_option("--fps", to.fps, "Frames a second of a film; default 30")->type_name("N");
}

}  // namespace

void add_morph(CLI::App& app, MorphArguments& to) {
  CLI::App* morph = app.add_subcommand("morph", "Morph targets; one person becoming another");
  morph->require_subcommand(1);
  CLI::App* make = morph->add_subcommand(
      "make", "Make targets out of a face file and the same face in other shapes");
  make->add_option("REST", to.rest, "The face at rest")->required()->type_name("");
  make->add_option("TARGETS", to.targets, "Face files, or NAME=FILE")
      ->required()
      ->type_name("")
      ->expected(1, 1 << 10);
  make->add_option("-o,--output", to.output, "Targets to write")->required()->type_name("FILE");

  add_between(*morph, to);
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
                   "Draw a mix instead of all targets: this one by so much, default 1; repeatable")
      ->type_name("NAME[=WEIGHT]")
      ->allow_extra_args(false);
  mesh->add_option("--yaw", to.yaw, "Turn the head to its left by so many degrees")->type_name("A");
  mesh->add_option("--pitch", to.pitch, "Tip its face down by so many degrees")->type_name("A");
  mesh->add_option("--size", to.size, "Pixels of the longer side of each picture; default 320")
      ->type_name("N");
}

}  // namespace mien::command
