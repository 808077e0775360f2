#include "tools/mien/cli/parts_options.h"

#include "command_app_private.h"

namespace mien::command {

void add_seed(CLI::App& command, std::optional<std::string>& to, const std::string& help) {
  const auto why_not = [](const std::string& word) -> std::string {
    return word.empty() ? "an empty word is no seed" : "";
  };
  command.add_option("--seed", to, help)->type_name("WORD")->check(why_not);
}

void add_new(CLI::App& app, NewArguments& to) {
  CLI::App* made = app.add_subcommand("new", "Make a face of one's own; its code is printed");
  made->add_option("-o,--output", to.output, "Face file to write; - is standard output")
      ->type_name("FILE");
  add_seed(*made, to.seed, "The same word, the same face; default: another one each time");
  made->add_option("--code", to.code, "The person of this code or recipe file")->type_name("FACE");
  made->add_option("--near", to.near, "Somebody like this person, a code or recipe file")
      ->type_name("FACE");
  made->add_option("--by", to.by, "With --near: how far from them, 0 to 1; default 0.3")
      ->type_name("SHARE");
  made->add_option("--between", to.between, "Somebody between two people")
      ->type_name("FACE FACE")
      ->expected(2);
  made->add_option("--at", to.at, "With --between: how far towards the second, 0 to 1; default 0.5")
      ->type_name("SHARE");
  made->add_option("--child-of", to.child_of, "A child of two people")
      ->type_name("FACE FACE")
      ->expected(2);
  made->add_option("--hold", to.held,
                   "Hold a part or a number, whatever the seed chooses; repeatable; "
                   "'mien parts' names them all")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  made->add_option(
          "--style", to.style,
          "How it is drawn: soft, flat, vinyl, sticker, pictogram, peep or ink; default soft")
      ->type_name("STYLE");
  made->add_flag("--flat", to.flat,
                 "Write the face in full, all its points, instead of its recipe");
  made->add_flag("--clamp", to.clamp,
                 "Take numbers out of range as the nearer end instead of an error");
}

void add_parts(CLI::App& app, PartsArguments& to) {
  CLI::App* parts =
      app.add_subcommand("parts", "List the parts and numbers that faces are made of");
  parts->add_option("FAMILY", to.family, "Only this family's parts")->type_name("");
  parts
      ->add_option("-o,--output", to.output,
                   "Draw them, as 'mien sheet --parts FAMILY' does, instead of listing them")
      ->type_name("FILE");
  parts->require_subcommand(0, 1);
  CLI::App* begin =
      parts->add_subcommand("new", "Begin a part of one's own: a shipped one, explained");
  begin->parse_complete_callback([&to] { to.verb = PartsArguments::Verb::begin; });
  begin->add_option("FAMILY", to.family, "Of this family")->required()->type_name("");
  begin->add_option("NAME", to.name, "What it is called")->required()->type_name("");
  begin->add_option("-o,--output", to.output, "File to write; default NAME.part.json")
      ->type_name("FILE");
  CLI::App* check = parts->add_subcommand(
      "check",
      "Let people wear parts of one's own, and tell what is wrong with them in some 500 poses");
  check->parse_complete_callback([&to] { to.verb = PartsArguments::Verb::check; });
  check->add_option("FILE", to.files, "Part files, all worn at once")
      ->required()
      ->type_name("")
      ->expected(1, 64);
  check->add_option("--people", to.people, "So many people; default 100")->type_name("N");
  check->add_option("-o,--output", to.output, "Draw the worst case of everything that is wrong")
      ->type_name("FILE");
  add_seed(*check, to.seed, "The same word, the same people; default 1");
}

void add_code(CLI::App& app, CodeArguments& to) {
  CLI::App* code =
      app.add_subcommand("code", "Print the code of a recipe, or the parts and numbers of a code");
  code->add_option("FACE", to.face, "Recipe file: its code; a code: its parts and numbers")
      ->type_name("");
  add_seed(*code, to.seed, "Instead: the code of this word, as mien new has it");
}

void add_check(CLI::App& app, CheckArguments& to) {
  CLI::App* check =
      app.add_subcommand("check",
                         "Check face files, each fault as FILE:LINE:COLUMN: /pointer: "
                         "SENTENCE; with --nonsense, whether faces stay faces in "
                         "every pose");
  check->add_option("FACE", to.faces, "Face files, or codes")->type_name("")->expected(0, 1 << 20);
  check
      ->add_option(
          "--nonsense", to.people,
          "Pose each FACE, or N random people instead, some 500 times: lids that do not meet, "
          "lips on the nose, hair beside the head and the like; count the faults, tell where each "
          "came first, and name the parts behind them")
      ->type_name("N")
      ->expected(0, 1)
      ->allow_extra_args(false);
  add_seed(*check, to.seed, "The same word, the same people; default 1");
  check->add_option("--style", to.style, "How the N people are painted; default soft")
      ->type_name("STYLE");
  check->add_flag("--json", to.json, "Print JSON instead of a table");
  check
      ->add_option("-o,--output", to.output,
                   "With --nonsense: draw the worst case of everything that is wrong")
      ->type_name("FILE");
  check->final_callback([check, &to] { to.nonsense = check->count("--nonsense") > 0; });
}

}  // namespace mien::command
