#include "lib/parts/compose/composed_text.h"
#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"

namespace mien {
namespace {

/// An array with its elements on lines of their own.
void add_lines(const JsonTree& tree, const JsonNode& array, std::string_view indent,
               std::string& to) {
  std::string_view before = "[";
  for (const JsonNode* one = tree.first(array); one; one = tree.next(*one)) {
    to.append(before).append(indent);
    add_json(tree, *one, to);
    before = ",";
  }
  to += "]";
}

void add_muscles(const JsonTree& tree, const JsonNode& muscles, std::string& to) {
  std::string_view before = "{";
  for (const JsonNode* member = tree.first(muscles); member; member = tree.next(*member)) {
    to.append(before).append(json_string(tree.key(*member))).append(": ");
    if (tree.key(*member) == "groups")
      add_lines(tree, *member, "\n    ", to);
    else
      add_json(tree, *member, to);
    before = ", ";
  }
  to += "}";
}

}  // namespace

std::string composed_text(const JsonTree& face) {
  std::string text;
  const auto add = [&](std::string_view before, std::string_view key) {
    const JsonNode& member = *face.member(face.root(), key);
    text.append(before).append(json_string(key)).append(": ");
    if (key == "features")
      add_lines(face, member, "\n  ", text);
    else if (key == "muscles")
      add_muscles(face, member, text);
    else
      add_json(face, member, text);
  };
  add("{", "format"), add(", ", "format_version"), add(",\n", "name"), add(", ", "credit");
  for (const char* key :
       {"canvas", "background", "light", "palette", "features", "controls", "eyes", "mouth", "turn",
        "muscles", "emotions", "expressions", "mood", "clips", "default_clip"})
    if (face.member(face.root(), key)) add(",\n", key);  // not every topology has a mood
  return text + "}\n";
}

}  // namespace mien
