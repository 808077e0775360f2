// Man page and shell completion, made from the definition.

#include <mien/version.h>

#include <fmt/format.h>

#include <algorithm>

#include "command_app_private.h"

namespace mien::command {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The words of "meet|slice"; none if the value is free.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const bool words =
      !type.empty() &&
      type.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789|") == std::string::npos;
  return words ? CLI::detail::split(type, '|') : std::vector<std::string>{};
}

bool takes_value(const CLI::Option& option) {
  return !option.get_type_name().empty();
}

/// Text that groff takes as it is.
std::string groff(const std::string& text) {
  std::string out;
  for (char c : text)
    out += c == '-' ? "\\-" : c == '\\' ? "\\e" : c == '\'' ? "\\(aq" : std::string(1, c);
  return out.starts_with('.') ? "\\&" + out : out;
}

/// Text inside single quotes of a shell.
std::string quoted(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out;
}

std::string manual_of_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : visible_options(command)) {
    text += fmt::format(".TP\n\\fB{}\\fR", groff(joined(option_words(*option), ", ")));
    if (takes_value(*option)) text += fmt::format(" \\fI{}\\fR", groff(option->get_type_name()));
    text += "\n" + groff(option->get_description()) + ".\n";
  }
  return text;
}

std::string positionals(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional()) continue;
    const std::string name =
        option->get_name() + (option->get_items_expected_max() > 1 ? " ..." : "");
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text;
}

/// A command's options and those of the commands below it, each name once.
std::vector<const CLI::Option*> options_below(const CLI::App& command) {
  std::vector<const CLI::Option*> options = visible_options(command);
  for (const CLI::App* below : visible_commands(command))
    for (const CLI::Option* option : visible_options(*below))
      if (std::none_of(options.begin(), options.end(), [&](const CLI::Option* other) {
            return other->get_name() == option->get_name();
          }))
        options.push_back(option);
  return options;
}

std::string bash(const CLI::App& app) {
  std::string cases, commands, after;
  for (const CLI::App* command : visible_commands(app)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    std::string words;
    for (const CLI::Option* option : options_below(*command)) {
      for (const std::string& word : option_words(*option))
        words += (words.empty() ? "" : " ") + word;
      const auto choices = choices_of(*option);
      if (!choices.empty()) {
        after += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$current\")); return ;;\n",
                             joined(option_words(*option), "|"), joined(choices, " "));
      }
    }
    cases += fmt::format("    {}) words='{}' ;;\n", command->get_name(), words);
  }
  return fmt::format(
      "# bash completion for mien, made by: mien completion bash\n"
      "_mien() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=\n"
      "  # bash splits --fit=meet at its equals sign\n"
      "  [[ $current == '=' ]] && current=\n"
      "  [[ $previous == '=' ]] && previous=${{COMP_WORDS[COMP_CWORD-2]}}\n"
      "  if ((COMP_CWORD == 1)); then COMPREPLY=($(compgen -W '{} -h --help --version' -- "
      "\"$current\")); return; fi\n"
      "  case $previous in\n{}  esac\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n"
      "  if [[ $current == -* ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "  else COMPREPLY=($(compgen -f -- \"$current\")); fi\n"
      "}}\n"
      "complete -o filenames -F _mien mien\n",
      commands, after, cases);
}

/// Escapes the colon and brackets, which mean something in zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (char c : quoted(text))
    out += c == ':' || c == '[' || c == ']' ? std::string("\\") + c : std::string(1, c);
  return out;
}

std::string zsh_option(const CLI::Option& option) {
  std::string text;
  for (const std::string& word : option_words(option)) {
    text += fmt::format(" \\\n        '{}{}{}[{}]", option.get_items_expected_max() > 1 ? "*" : "",
                        word, takes_value(option) && word.starts_with("--") ? "=" : "",
                        zsh_text(option.get_description()));
    if (takes_value(option)) {
      const auto choices = choices_of(option);
      text += fmt::format(":{}:{}", zsh_text(option.get_type_name()),
                          !choices.empty()                   ? "(" + joined(choices, " ") + ")"
                          : option.get_type_name() == "FILE" ? "_files"
                                                             : "");
    }
    text += "'";
  }
  return text;
}

std::string zsh(const CLI::App& app) {
  std::string commands, cases;
  for (const CLI::App* command : visible_commands(app)) {
    commands +=
        fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    cases += fmt::format("    {})\n      _arguments", command->get_name());
    for (const CLI::Option* option : options_below(*command)) cases += zsh_option(*option);
    cases += " \\\n        '*:face:_files' ;;\n";
  }
  return fmt::format(
      "#compdef mien\n# zsh completion for mien, made by: mien completion zsh\n"
      "_mien() {{\n  local -a commands\n  commands=(\n{}  )\n"
      "  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  local command=$words[2]\n  shift words\n  ((CURRENT--))\n"
      "  case $command in\n{}  esac\n}}\n_mien \"$@\"\n",
      commands, cases);
}

std::string fish(const CLI::App& app) {
  std::string text = "# fish completion for mien, made by: mien completion fish\n";
  for (const CLI::App* command : visible_commands(app)) {
    text += fmt::format("complete -c mien -n __fish_use_subcommand -f -a {} -d '{}'\n",
                        command->get_name(), quoted(command->get_description()));
    for (const CLI::Option* option : options_below(*command)) {
      text +=
          fmt::format("complete -c mien -n '__fish_seen_subcommand_from {}'", command->get_name());
      for (const std::string& name : option->get_snames()) text += " -s " + name;
      for (const std::string& name : option->get_lnames()) text += " -l " + name;
      if (takes_value(*option)) text += " -r";
      const auto choices = choices_of(*option);
      if (!choices.empty()) text += fmt::format(" -f -a '{}'", joined(choices, " "));
      text += fmt::format(" -d '{}'\n", quoted(option->get_description()));
    }
  }
  return text;
}

}  // namespace

std::string manual(const CLI::App& app) {
  std::string text = ".TH MIEN 1 \"\" \"mien " MIEN_VERSION_STRING "\" \"User commands\"\n";
  text += ".SH NAME\nmien \\- draws vector faces exactly\n.SH SYNOPSIS\n";
  for (const CLI::App* command : leaf_commands(app)) {
    const std::string after = positionals(*command) + " [\\fIoptions\\fR]";
    text += fmt::format(".B mien {}\n{}\n.br\n", spoken_name(*command), after.substr(1));
  }
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : leaf_commands(app)) {
    text += fmt::format(".SS mien {}{}\n{}.\n{}", spoken_name(*command), positionals(*command),
                        groff(command->get_description()), manual_of_options(*command));
  }
  text += ".SH OPTIONS\n" + manual_of_options(app);
  text +=
      ".SH FILES\nA picture is written beside its target as .mien\\-0123456789abcdef.part and "
      "renamed when it is whole. "
      "What a killed run leaves of these, the next run into that folder removes.\n";
  text += ".SH EXIT STATUS\n0 when done, 1 when something failed, 2 when used wrongly.\n";
  return text;
}

std::string completion(const CLI::App& app, const std::string& shell) {
  return shell == "bash" ? bash(app) : shell == "zsh" ? zsh(app) : fish(app);
}

}  // namespace mien::command
