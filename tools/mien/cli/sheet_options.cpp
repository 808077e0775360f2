#include "tools/mien/cli/sheet_options.h"
#include "lib/base/one_line.h"
#include "tools/mien/cli/motion_options.h"

#include "command_app_private.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace mien::command {
namespace {

constexpr std::string_view kBlanks = " \t\n";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

Error refuse(const std::string& text, std::string what) {
  return {"--picture " + one_line(text, 60), std::move(what)};
}

/// The words of a text, split at blanks, except inside '…' or "…".
Expected<std::vector<std::string>> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!(text = trimmed(text)).empty()) {
    std::string word;
    while (!text.empty() && kBlanks.find(text[0]) == std::string_view::npos) {
      const char first = text[0];
      text.remove_prefix(1);
      if (first != '\'' && first != '"') {
        word += first;
        continue;
      }
      const std::size_t end = text.find(first);
      if (end == std::string_view::npos) return Error{{}, "a quote is never closed"};
      word += text.substr(0, end);
      text.remove_prefix(end + 1);
    }
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace

void add_sheet(CLI::App& app, SheetArguments& to) {
  CLI::App* sheet = app.add_subcommand(
      "sheet", "Draw a grid of one face at many poses, of many people or of parts, with names");
  sheet->add_option("FACE", to.face, "Face file, or a code")->type_name("");
  sheet->add_option("--people", to.people, "Instead of one face: so many people, no two alike")
      ->type_name("N");
  sheet
      ->add_option("--parts", to.parts,
                   "Every part of this family, or of one's own in this file or folder, on the same "
                   "head: a plain one, or FACE's, which is a recipe or a code; 'mien parts' names "
                   "the families")
      ->type_name("FAMILY|FILE|FOLDER");
  add_seed(*sheet, to.seed, "The same word, the same people; default 1");
  sheet->add_option("--style", to.style, "How faces by code are painted; default soft")
      ->type_name("STYLE");
  sheet->add_flag("--neutral", to.neutral, "No smile, lips closed, heads ahead, all still");
  sheet
      ->add_option("--turned", to.turned,
                   "With --people and no --picture: how far heads turn to either side at most, by "
                   "the people's own chances, and tilt half as far; default 12")
      ->type_name("DEGREES");
  sheet->add_option("-o,--output", to.output, "Picture to write")->type_name("FILE");
  sheet->add_flag(
      "--statistics", to.statistics,
      "With --people: print how many of them have each part, how old they are and so on, "
      "beside what is asked of them; needs no picture");
  sheet->add_flag("--json", to.json, "With --statistics: print JSON instead of a table");
  sheet->add_flag(
      "--emotions", to.emotions,
      "Every emotion at full strength (default, unless there is a --picture, --people or --parts)");
  sheet->add_flag("--half", to.half, "And every emotion at half strength");
  sheet
      ->add_option("--picture", to.pictures,
                   "A picture drawn as by mien render with these options, instead of the "
                   "emotions; repeatable; options that pose, effects, --region and "
                   "such: 'far: --look-at 0,0,9 --region 10,20,80,60'")
      ->type_name("[NAME:] OPTIONS")
      ->allow_extra_args(false);
  sheet
      ->add_option("--columns", to.columns,
                   "Pictures in a row; default 3, with --people as many as there are rows")
      ->type_name("N");
  sheet->add_option("--gap", to.gap, "White pixels between pictures; default 0")->type_name("N");
  sheet
      ->add_option("--cell", to.cell,
                   "Pixels of a picture before --region, or of its longer side; default 320, with "
                   "--people less where the sheet would be wider than 4096")
      ->type_name("WxH");
}

Expected<SheetPicture> read_sheet_picture(const std::string& text) {
  SheetPicture picture;
  std::string_view rest = trimmed(text);
  if (!rest.empty() && rest[0] != '-') {
    const std::size_t colon = rest.find(':');
    if (colon == std::string_view::npos)
      return refuse(text, "expected options of mien render, perhaps after a name and a colon");
    picture.name = trimmed(rest.substr(0, colon));
    rest.remove_prefix(colon + 1);
  }
  auto words = words_of(rest);
  if (!words) return refuse(text, words.error().what);
  CLI::App app{"A picture of a sheet", "picture"};
  app.set_help_flag();
  add_pose(&app, picture.render.posed);
  add_picture(&app, picture.render);
  for (const char* option : {"--depth", "--size", "--style"})
    app.remove_option(app.get_option(option));
  words->insert(words->begin(), "FACE");  // the sheet's
  std::reverse(words->begin(), words->end());
  try {
    app.parse(*std::move(words));
  } catch (const CLI::ParseError& wrong) {
    return refuse(text, wrong_use(app, wrong));
  }
  return picture;
}

}  // namespace mien::command
