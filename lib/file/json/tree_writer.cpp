#include "lib/file/json/tree_writer.h"

#include <cmath>

namespace mien {

JsonNode& TreeWriter::add(JsonKind kind) {
  const std::int32_t index = next();
  JsonNode node;
  node.kind = kind;
  if (!open_.empty()) {
    Open& container = open_.back();
    JsonNode& parent = tree_.nodes[std::size_t(container.node)];
    node.parent = container.node;
    if (parent.kind == JsonKind::object) tree_.name(node, key_);
    (container.last < 0 ? parent.first : tree_.nodes[std::size_t(container.last)].next) = index;
    container.last = index;
    ++parent.count;
  }
  return tree_.nodes.emplace_back(node);
}

void TreeWriter::number(double value) {
  if (std::isfinite(value))
    add(JsonKind::number).number = value + 0.0;
  else
    add(JsonKind::null);
}

void TreeWriter::string(std::string_view text) {
  const std::int32_t index = tree_.refer(text);
  add(JsonKind::string).text = index;
}

void TreeWriter::kept_string(std::string_view text) {
  const std::int32_t index = tree_.keep(text);
  add(JsonKind::string).text = index;
}

void TreeWriter::arrange(std::int32_t array, std::span<const std::int32_t> elements) {
  std::int32_t* link = &tree_.nodes[std::size_t(array)].first;
  for (const std::int32_t element : elements) {
    *link = element;
    link = &tree_.nodes[std::size_t(element)].next;
  }
  *link = -1;
}

}  // namespace mien
