#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"

namespace mien {

void add_json(const JsonTree& tree, const JsonNode& node, std::string& to) {
  switch (node.kind) {
    case JsonKind::null:
      to += "null";
      return;
    case JsonKind::boolean:
      to += node.number != 0 ? "true" : "false";
      return;
    case JsonKind::number:
      to += json_number(node.number);
      return;
    case JsonKind::string:
      to += json_string(tree.string(node));
      return;
    default:
      break;
  }
  const bool object = node.kind == JsonKind::object;
  to += object ? '{' : '[';
  std::string_view before;
  for (const JsonNode* child = tree.first(node); child; child = tree.next(*child)) {
    to += before;
    if (object) to.append(json_string(tree.key(*child))).append(": ");
    add_json(tree, *child, to);
    before = ", ";
  }
  to += object ? '}' : ']';
}

}  // namespace mien
