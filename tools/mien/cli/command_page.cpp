// docs/command.md, made from the definition: mien manual --markdown.

#include <fmt/format.h>

#include <algorithm>

#include "command_app_private.h"

namespace mien::command {
namespace {

constexpr const char* kPageStart =
    R"(# The command `mien`

This page is made from the command's own definition: `mien manual --markdown`. `mien COMMAND -h` prints the same, and
`cmake --install` adds a man page and completion for bash, zsh and fish.

A FACE is a face file, a recipe, or a code that `mien new` printed. Names that `--set` takes have a unit, a range and a
value; `mien list FACE` prints them all. Where several options move the same thing, `--set` wins.

A picture appears whole or not at all: it is written beside its target as `.mien-….part`, flushed and renamed. Ctrl-C
leaves the old picture and nothing else. If a run is killed, the next run into that folder removes its leftovers. The
picture's metadata tell how it was made (ImageDescription, or in PNG the text "Description").

Every error is one line on standard error. The exit code is 0 for success, 1 for failure and 2 for wrong usage. Work of
over a second shows a bar on a terminal.

)";
constexpr std::size_t kPageWidth = 120;  // of a page

/// `text` in lines of at most kPageWidth characters, the first one after `lead`, the others as far in as a list's.
std::string wrapped(std::string lead, const std::string& text) {
  const std::string indent = lead.empty() ? "" : "  ";
  std::string out, line = std::move(lead);
  bool bare = true;  // no word on this line yet
  for (const std::string& word : CLI::detail::split(text, ' ')) {
    if (!bare && line.size() + 1 + word.size() > kPageWidth) {
      out += line + "\n";
      line = indent + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    bare = false;
  }
  return out + line + "\n";
}

/// Text in which no word, such as FILE.*, means something to Markdown.
std::string literal(const std::string& text) {
  std::string out;
  for (char c : text) out += std::string(c == '*' || c == '<' || c == '_' ? "\\" : "") + c;
  return out;
}

std::string entry(const CLI::Option& option) {
  std::string words;
  for (const std::string& word : option_words(option))
    words += (words.empty() ? "`" : "`, `") + word;
  if (words.empty()) words = "`" + option.get_name();
  if (!option.get_type_name().empty()) words += " " + option.get_type_name();
  const bool needed = option.get_required() && option.nonpositional();
  return wrapped("* " + words + "`" + (needed ? " (required)" : "") + ":",
                 literal(option.get_description()));
}

/// Whether `render` has the same option, meaning the same.
bool shared(const CLI::Option& option, const CLI::App& render) {
  const auto known = visible_options(render);
  return option.nonpositional() &&
         std::any_of(known.begin(), known.end(), [&](const CLI::Option* other) {
           return other->get_name() == option.get_name() &&
                  other->get_description() == option.get_description();
         });
}

std::string section(const CLI::App& command, const CLI::App& render) {
  const std::string name = spoken_name(command);
  std::string text = fmt::format("## mien {}\n\n", name), options, known;
  text += wrapped("", literal(command.get_description()) + ".");
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_name() == "--help") continue;
    if (&command != &render && shared(*option, render))
      known += (known.empty() ? "`" : ", `") + option_words(*option).back() + "`";
    else
      options += entry(*option);
  }
  if (!known.empty()) known = "\n" + wrapped("", "As for `mien render`: " + known + ".");
  return text + (options.empty() ? "" : "\n" + options) + known + "\n";
}

/// The address of a heading within the page.
std::string anchor(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return "#mien-" + name;
}

}  // namespace

std::string command_page(const CLI::App& app) {
  const CLI::App& render = *app.get_subcommand("render");
  std::string list, sections;
  for (const CLI::App* command : leaf_commands(app)) {
    const std::string name = spoken_name(*command);
    list += (list.empty() ? "" : " · ") + fmt::format("[{}]({})", name, anchor(name));
    sections += section(*command, render);
  }
  sections.pop_back();
  return kPageStart + wrapped("", list) + "\n" + sections;
}

}  // namespace mien::command
