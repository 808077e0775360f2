// What a standard name must do to a face, as a table.

#include "tools/mien/commands/list_moves.h"
#include "lib/base/nearest_name.h"
#include "lib/face/standard_moves.h"
#include "lib/face/standard_names.h"
#include "lib/file/json/reading.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace mien::command {
namespace {

constexpr std::string_view kSets[] = {"arkit", "facs", "vrm", "viseme", "azure"};

/// "arkit.jawOpen" of "jawOpen", "JawOpen", "arkit.jawOpen"; every set that has such a name.
std::vector<std::string> rows_meant(std::string_view given) {
  std::vector<std::string> rows;
  for (const std::string_view set : kSets) {
    const std::string prefix = std::string(set) + ".";
    const bool of_set = given.starts_with(prefix);
    const std::string name = standard_spelling(set, of_set ? given.substr(prefix.size()) : given);
    const auto names = standard_names(set);
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (of_set) return {prefix + name};
    rows.push_back(prefix + name);
  }
  return rows;
}

std::string row_text(const Reading& in, std::string_view name, const JsonNode& row) {
  std::string text = fmt::format("{}: {}\n", name, in.string(in.need(row, "says")));
  if (const JsonNode* moves = in.find(row, "moves"))
    in.for_each(*moves, [&](const JsonNode& landmark, int) {
      text += fmt::format("  {:<18}", in.tree.key(landmark));
      in.for_each(landmark, [&](const JsonNode& way, int) {
        const std::vector<double> range = in.numbers(way, 2, 2);
        text += fmt::format("  {} {:g} … {:g}", in.tree.key(way), range[0], range[1]);
      });
      text += "\n";
    });
  std::string kinds;
  in.for_each(in.need(row, "of"), [&](const JsonNode& kind, int) {
    kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", in.string(kind));
  });
  return text + fmt::format("  all but {} stays\n", kinds.empty() ? "nothing" : kinds);
}

}  // namespace

int list_moves(std::string_view name) {
  const auto tree = JsonTree::read(standard_moves(), "standard_moves.json", {});
  if (!tree) return complain(tree.error(), kFailed);
  const FaceLimits limits;
  const Reading in(*tree, limits, nullptr);
  const JsonNode& moves = in.need(tree->root(), "moves");
  std::string text;
  for (const std::string& row : rows_meant(name))
    if (const JsonNode* found = in.find(moves, row)) text += row_text(in, row, *found);
  if (!text.empty()) return print(text);
  std::vector<std::string_view> known;
  for (const std::string_view set : kSets)
    for (const std::string_view standard : standard_names(set)) known.push_back(standard);
  return complain({"--moves", unknown_name("standard name", name, known)}, kUsedWrongly);
}

}  // namespace mien::command
