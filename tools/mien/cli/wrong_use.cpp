// What was wrong with words that the command line could not read.

#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include "command_app_private.h"

namespace mien::command {
namespace {

std::vector<std::string_view> names_of(const std::vector<std::string>& words) {
  return {words.begin(), words.end()};
}

/// What could not be placed, in one sentence: an unknown option or command, or one argument too many.
std::string stray(const CLI::App& app) {
  const CLI::App* at = &app;
  for (bool deeper = true; deeper;) {
    deeper = false;
    for (const CLI::App* command : at->get_subcommands({}))
      if (command->parsed()) at = command, deeper = true;
  }
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return "arguments that mean nothing";
  const std::string& word = left.front();
  if (word.size() > 1 && word[0] == '-') {
    std::vector<std::string> known;
    for (const CLI::Option* option : visible_options(*at)) {
      for (const std::string& name : option_words(*option)) known.push_back(name);
    }
    return unknown_name("option", word.substr(0, word.find('=')), names_of(known));
  }
  if (!visible_commands(*at).empty() && (at == &app || at->get_require_subcommand_min() > 0)) {
    std::vector<std::string> known;
    for (const CLI::App* command : visible_commands(*at)) known.push_back(command->get_name());
    const std::string near(nearest_name(word, names_of(known)));
    const std::string inside = at == &app ? "" : " " + spoken_name(*at);
    return unknown_name("command", word, names_of(known)) +
           (near.empty() ? "; mien" + inside + " -h helps" : "");
  }
  return spoken_name(*at) + ": one argument too many: " + in_quotes(word);
}

/// CLI11's own messages in this command's style: after the name of the command they are about, in lower
/// case.
std::string retold(const CLI::App& app, const CLI::ParseError& wrong) {
  std::string text = wrong.what();
  const std::string option = text.substr(0, text.find(':'));
  if (text.find("subcommand is required") != std::string::npos)
    text = "one of its commands is needed: " + command_list(innermost_command(app));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&wrong)) {
    text = option + (text.find("At Most") == std::string::npos ? " needs a value"
                                                               : " may be given only once");
  }
  return app.get_subcommands().empty() ? text : spoken_name(innermost_command(app)) + ": " + text;
}

}  // namespace

const CLI::App& innermost_command(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().back();
  return *at;
}

std::string command_list(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : visible_commands(app))
    text += (text.empty() ? "" : ", ") + command->get_name();
  return text;
}

std::string wrong_use(const CLI::App& app, const CLI::ParseError& wrong) {
  // A mistyped option explains more than the argument that is missing because of it.
  return app.remaining_size(true) > 0 ? stray(app) : retold(app, wrong);
}

}  // namespace mien::command
