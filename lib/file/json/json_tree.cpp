#include "lib/file/json/json_tree.h"

#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>

namespace mien {
namespace {

/// Follows the parser's events through the text. The parser has accepted each token before its event comes,
/// so this need not guard against malformed ones.
class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) {
    if (text.starts_with("\xEF\xBB\xBF")) end_ = 3;  // a byte order mark
  }

  /// Steps over the next token and returns where it begins.
  std::size_t step() {
    end_ = std::min(text_.find_first_not_of(" \t\n\r,:", end_), text_.size());
    const std::size_t begin = end_;
    if (begin == text_.size()) return begin;
    if (text_[begin] == '"') {
      ++end_;
      while (end_ < text_.size() && text_[end_] != '"') end_ += text_[end_] == '\\' ? 2 : 1;
      ++end_;
    } else if (std::string_view{"[]{}"}.find(text_[begin]) != std::string_view::npos) {
      ++end_;
    } else {
      end_ = text_.find_first_of(" \t\n\r,:[]{}", begin);
    }
    end_ = std::min(end_, text_.size());
    return begin;
  }

 private:
  std::string_view text_;
  std::size_t end_ = 0;
};

/// nlohmann's message about malformed text, without its prefix.
std::string malformed(std::string_view words) {
  const std::size_t column = words.find("column ");
  const std::size_t colon = words.find(": ", column == std::string_view::npos ? 0 : column);
  if (colon != std::string_view::npos) words.remove_prefix(colon + 2);
  return fmt::format("malformed JSON: {}", one_line(words, 160));
}

std::string too_many(const FaceLimits& limits) {
  return fmt::format("more than {} JSON values (limit: values)", limits.values);
}
std::string too_large(double value, const FaceLimits& limits) {
  return fmt::format("{} is too large: numbers go from {} to {} (limit: magnitude)", value,
                     -limits.magnitude, limits.magnitude);
}
std::string too_deep(const FaceLimits& limits) {
  return fmt::format("arrays and objects nested more than {} deep (limit: nesting)",
                     limits.nesting);
}

constexpr char kNul[] = "a NUL character, which no text has";

bool has_nul(std::string_view text) {
  return text.find('\0') != std::string_view::npos;
}

/// Builds the tree from the parser's events; any handler that returns false stops the parser.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(JsonTree& tree, std::string_view text, const FaceLimits& limits)
      : tree_(tree), text_(text), walker_(text), limits_(limits) {}

  std::optional<Error> error;

  bool null() override { return add(JsonKind::null) != nullptr; }
  bool boolean(bool value) override {
    JsonNode* node = add(JsonKind::boolean);
    if (node) node->number = value;
    return node != nullptr;
  }
  bool number_integer(number_integer_t value) override { return number(double(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(double(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override {
    JsonNode* node = add(JsonKind::string);
    if (!node) return false;
    if (has_nul(value)) return refuse(*node, kNul);
    node->text = keep(value);
    return true;
  }
  bool binary(binary_t&) override { return false; }  // not in text
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool start_array(std::size_t) override { return open(JsonKind::array); }
  bool end_array() override { return close(); }
  bool end_object() override { return keys_differ() && close(); }
  bool key(string_t& value) override {
    key_offset_ = walker_.step();
    if (has_nul(value)) {
      error = Error{tree_.where(key_offset_), kNul};
      return false;
    }
    key_ = keep(value);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& exception) override {
    const std::size_t at = std::min(position > 0 ? position - 1 : 0, text_.size());
    if (exception.id == 406)
      error = Error{tree_.where(at),
                    fmt::format("{} is too large for a number", one_line(last_token, 60))};
    else if (text_.find_first_not_of(" \t\n\r") == std::string_view::npos)
      error = Error{tree_.where(at), "the file is empty"};
    else
      error = Error{tree_.where(at), malformed(exception.what())};
    return false;
  }

 private:
  std::int32_t keep(const std::string& text) { return tree_.keep(text); }

  bool refuse(const JsonNode& node, std::string what) {
    error = Error{tree_.where(node), std::move(what)};
    return false;
  }

  /// Appends a value to the container that is open; null if there are too many.
  JsonNode* add(JsonKind kind) {
    const auto index = std::int32_t(tree_.nodes.size());
    JsonNode node;
    node.kind = kind;
    node.offset = std::uint32_t(walker_.step());
    if (!open_.empty()) {
      Open& container = open_.back();
      JsonNode& parent = tree_.nodes[std::size_t(container.node)];
      node.parent = container.node;
      if (parent.kind == JsonKind::object)
        tree_.name(node, key_), node.key_offset = std::uint32_t(key_offset_);
      (container.last < 0 ? parent.first : tree_.nodes[std::size_t(container.last)].next) = index;
      container.last = index;
      ++parent.count;
    }
    tree_.nodes.push_back(node);
    if (tree_.nodes.size() <= limits_.values) return &tree_.nodes.back();
    refuse(tree_.nodes.back(), too_many(limits_));
    return nullptr;
  }

  bool number(double value) {
    JsonNode* node = add(JsonKind::number);
    if (!node) return false;
    node->number = value;
    if (std::abs(value) <= limits_.magnitude) return true;
    return refuse(*node, too_large(value, limits_));
  }

  bool open(JsonKind kind) {
    JsonNode* node = add(kind);
    if (!node) return false;
    open_.push_back({std::int32_t(node - tree_.nodes.data()), -1});
    if (open_.size() <= std::size_t(std::max(limits_.nesting, 0))) return true;
    // Not refuse(): its message would be little more than the pointer of so deep a value.
    error = Error{tree_.where(std::size_t(node->offset)), too_deep(limits_)};
    return false;
  }

  bool close() {
    walker_.step();
    open_.pop_back();
    return true;
  }

  bool keys_differ() {
    const JsonNode& object = tree_.nodes[std::size_t(open_.back().node)];
    std::unordered_set<std::string_view> seen;
    for (const JsonNode* child = tree_.first(object); child; child = tree_.next(*child))
      if (!seen.insert(tree_.key(*child)).second) {
        error = Error{tree_.where(*child, true),
                      fmt::format("the key {} stands here twice", in_quotes(tree_.key(*child)))};
        return false;
      }
    return true;
  }

  struct Open {
    std::int32_t node, last;  ///< a container and its last child so far
  };
  JsonTree& tree_;
  std::string_view text_;
  Walker walker_;
  const FaceLimits& limits_;
  std::vector<Open> open_;
  std::int32_t key_ = -1;
  std::size_t key_offset_ = 0;
};

/// One step of a JSON pointer.
std::string escaped(std::string_view key) {
  std::string step;
  for (const char c : key) {
    if (c == '~')
      step += "~0";
    else if (c == '/')
      step += "~1";
    else
      step += c;
  }
  return step;
}

}  // namespace

Expected<JsonTree> JsonTree::read(std::string_view text, std::string_view name,
                                  const FaceLimits& limits, std::size_t first_line) {
  JsonTree tree(text, one_line(name));
  tree.first_line_ = first_line;
  Builder builder(tree, text, limits);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return *builder.error;
  return tree;
}

const JsonNode* JsonTree::member(const JsonNode& object, std::string_view key_wanted) const {
  if (object.kind != JsonKind::object) return nullptr;
  const std::uint32_t sign = key_sign(key_wanted);
  for (const JsonNode* child = first(object); child; child = next(*child))
    if (child->key_sign == sign && key(*child) == key_wanted) return child;
  return nullptr;
}

std::optional<Error> JsonTree::beyond(const FaceLimits& limits) const {
  if (nodes.size() > limits.values) return Error{name_, too_many(limits)};
  std::vector<int> depths(nodes.size(), 0);  // of containers; parents come before their children
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const JsonNode& node = nodes[i];
    if (node.kind == JsonKind::number && !(std::abs(node.number) <= limits.magnitude))
      return Error{where(node), too_large(node.number, limits)};
    if (node.kind != JsonKind::array && node.kind != JsonKind::object) continue;
    depths[i] = 1 + (node.parent < 0 ? 0 : depths[std::size_t(node.parent)]);
    if (depths[i] > std::max(limits.nesting, 0)) return Error{name_, too_deep(limits)};
  }
  return {};
}

std::string JsonTree::where(std::size_t offset) const {
  if (!has_text_) return name_;
  std::size_t line = first_line_, column = 1;
  for (std::size_t i = 0; i < std::min(offset, text_.size()); ++i) {
    if (text_[i] == '\n')
      ++line, column = 1;
    else if ((static_cast<unsigned char>(text_[i]) & 0xC0) != 0x80)
      ++column;  // not inside a character
  }
  return fmt::format("{}:{}:{}", name_, line, column);
}

const JsonTree::Origin* JsonTree::origin_of(const JsonNode& node) const {
  const auto found = std::find_if(origins_.begin(), origins_.end(),
                                  [&](const Origin& o) { return o.node == index(node); });
  return found == origins_.end() ? nullptr : &*found;
}

/// Goes down in the other tree by the same keys and numbers, as far as they lead.
std::string JsonTree::where_in(const Origin& origin, const JsonNode& node) const {
  std::vector<const JsonNode*> way;
  for (const JsonNode* step = &node; step != at(origin.node); step = at(step->parent))
    way.push_back(step);
  const JsonTree& other = *origin.tree;
  const JsonNode* place = origin.from;
  for (auto step = way.rbegin(); step != way.rend(); ++step) {
    const JsonNode* to = nullptr;
    if ((*step)->key >= 0) {
      to = other.member(*place, key(**step));
    } else if (place->kind == JsonKind::array) {
      to = other.first(*place);
      for (const JsonNode* before = first(*at((*step)->parent)); to && before != *step;
           before = next(*before))
        to = other.next(*to);
    }
    if (!to) break;
    place = to;
  }
  return other.where(*place);
}

std::string JsonTree::where(const JsonNode& node, bool at_key) const {
  if (!origins_.empty())
    for (const JsonNode* above = &node; above; above = at(above->parent))
      if (const Origin* origin = origin_of(*above)) return where_in(*origin, node);
  constexpr std::size_t kLongestKey = 60;
  const std::string steps = pointer(node, kLongestKey);
  const std::string place = where(std::size_t(at_key ? node.key_offset : node.offset));
  return steps.empty() ? place : place + ": " + steps;
}

std::string JsonTree::pointer(const JsonNode& node, std::optional<std::size_t> longest) const {
  std::vector<std::string> steps;
  for (const JsonNode* child = &node; child->parent >= 0; child = at(child->parent)) {
    if (child->key >= 0) {
      steps.push_back(escaped(longest ? one_line(key(*child), *longest) : key(*child)));
      continue;
    }
    int index = 0;
    for (const JsonNode* before = first(*at(child->parent)); before != child;
         before = next(*before))
      ++index;
    steps.push_back(std::to_string(index));
  }
  std::string whole;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) whole += "/" + *step;
  return whole;
}

}  // namespace mien
