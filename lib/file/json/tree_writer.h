#pragma once
// A JSON tree written value by value, as its text would be.
//
//   TreeWriter to(tree);
//   to.object(), to.key("at"), to.pair({1, 2}), to.close();       // {"at": [1, 2]}

#include "lib/file/json/json_tree.h"

#include <glm/vec2.hpp>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace mien {

class TreeWriter {
 public:
  /// Appends to `tree`, which must outlive this.
  explicit TreeWriter(JsonTree& tree) : tree_(tree) {}

  void object() { open(JsonKind::object); }
  void array() { open(JsonKind::array); }
  void close() { open_.pop_back(); }

  /// Of the member that comes next. Views must outlive the tree.
  void key(std::string_view name) { key_ = tree_.refer(name); }
  void kept_key(std::string_view name) { key_ = tree_.keep(name); }

  void number(double value);  ///< null if it is not finite; −0 is 0, as in text
  void pair(glm::dvec2 p) { array(), number(p.x), number(p.y), close(); }
  void boolean(bool value) { add(JsonKind::boolean).number = value; }
  void string(std::string_view text);  ///< must outlive the tree
  void kept_string(std::string_view text);
  /// A string in parts that stays as long as the tree: for names that are written again and again.
  std::string_view kept(std::initializer_list<std::string_view> parts) { return tree_.kept(parts); }

  /// A value of another tree, which must outlive this one.
  void copy(const JsonTree& from, const JsonNode& node) {
    copy(from, node, [](const JsonNode&) { return false; });
  }
  /// `replace` writes what stands for an object instead, and tells whether it did.
  template <class Replace>
  void copy(const JsonTree& from, const JsonNode& node, Replace&& replace);
  /// The same for its members or elements alone, into what is open.
  template <class Replace>
  void copy_children(const JsonTree& from, const JsonNode& node, Replace&& replace);

  /// Says what the value that is written next is made from, in a tree that must outlive this one.
  void stems_from(const JsonTree& from, const JsonNode& node) {
    tree_.stems_from(next(), from, node);
  }

  /// The index of the value that is written next.
  std::int32_t next() const { return std::int32_t(tree_.nodes.size()); }
  /// Puts the elements of an array, all of them, in another order.
  void arrange(std::int32_t array, std::span<const std::int32_t> elements);

 private:
  struct Open {
    std::int32_t node, last;  ///< a container and its last child so far
  };
  JsonNode& add(JsonKind kind);
  void open(JsonKind kind) { open_.push_back({std::int32_t(&add(kind) - tree_.nodes.data()), -1}); }

  JsonTree& tree_;
  std::vector<Open> open_;
  std::int32_t key_ = -1;
};

template <class Replace>
void TreeWriter::copy(const JsonTree& from, const JsonNode& node, Replace&& replace) {
  switch (node.kind) {
    case JsonKind::null:
      add(JsonKind::null);
      return;
    case JsonKind::boolean:
      return boolean(node.number != 0);
    case JsonKind::number:
      return number(node.number);
    case JsonKind::string:
      return string(from.string(node));
    default:
      break;
  }
  if (node.kind == JsonKind::object && replace(node)) return;
  open(node.kind);
  copy_children(from, node, replace);
  close();
}

template <class Replace>
void TreeWriter::copy_children(const JsonTree& from, const JsonNode& node, Replace&& replace) {
  for (const JsonNode* child = from.first(node); child; child = from.next(*child)) {
    if (node.kind == JsonKind::object) key(from.key(*child));
    copy(from, *child, replace);
  }
}

}  // namespace mien
