#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"

namespace mien {

std::string json_copy(const Reading& in, const JsonNode& node, const JsonReplacement& replace) {
  if (replace)
    if (auto text = replace(node)) return *std::move(text);
  switch (node.kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return in.boolean(node) ? "true" : "false";
    case JsonKind::number:
      return json_number(node.number);
    case JsonKind::string:
      return json_string(in.string(node));
    default:
      break;
  }
  const bool object = node.kind == JsonKind::object;
  std::string text = object ? "{" : "[";
  in.for_each(node, [&](const JsonNode& child, int i) {
    if (i) text += ", ";
    if (object) text += json_string(in.tree.key(child)) + ": ";
    text += json_copy(in, child, replace);
  });
  return text + (object ? "}" : "]");
}

}  // namespace mien
