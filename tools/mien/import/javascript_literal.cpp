// Longer than other files: the words of one grammar and what is made of them. JavaScript's object literals as a
// tree, without running anything. The grammar is that of ECMAScript's literals (ECMA-262, 12.9 and 13.2.5) without
// anything that computes: no functions, operators, spreads or templates with ${…}.

#include "tools/mien/import/javascript_literal.h"

#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <unordered_set>
#include "lib/base/from_chars.h"

namespace mien {
namespace {

struct Malformed {
  std::size_t offset;
  std::string what;
};

bool is_word_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' || (c & 0x80);
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void append_utf8(std::string& to, std::uint32_t code) {
  if (code >= 0xD800 && code < 0xE000) code = 0xFFFD;  // half of a pair
  if (code < 0x80) {
    to += char(code);
  } else if (code < 0x800) {
    to += char(0xC0 | code >> 6), to += char(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    to += char(0xE0 | code >> 12), to += char(0x80 | (code >> 6 & 0x3F));
    to += char(0x80 | (code & 0x3F));
  } else {
    to += char(0xF0 | code >> 18), to += char(0x80 | (code >> 12 & 0x3F));
    to += char(0x80 | (code >> 6 & 0x3F)), to += char(0x80 | (code & 0x3F));
  }
}

/// Splits the text into words, strings, numbers and marks.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  std::size_t at() const { return at_; }
  bool ended() const { return at_ == text_.size(); }
  char mark() const { return ended() ? '\0' : text_[at_]; }
  void step() { ++at_; }

  /// Skips spaces and comments.
  void skip() {
    for (;;) {
      while (!ended() && std::string_view{" \t\r\n\v\f"}.find(text_[at_]) != std::string_view::npos)
        ++at_;
      if (!skip_comment()) return;
    }
  }

  /// Skips one, without the end of its line; false: none begins here.
  bool skip_comment() {
    if (text_.substr(at_, 2) == "//") {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return true;
    }
    if (text_.substr(at_, 2) != "/*") return false;
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) throw Malformed{at_, "this comment does not end"};
    at_ = end + 2;
    return true;
  }

  /// Whether one of these words comes next, and nothing more of a word.
  bool begins_with_word(std::initializer_list<std::string_view> words) const {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
      const std::size_t end = at_ + word.size();
      return text_.substr(at_, word.size()) == word &&
             (end >= text_.size() || !is_word_start(text_[end]));
    });
  }

  /// Passes over a type, up to the mark behind which the value stands.
  void pass_to_equals() { at_ = std::min(text_.find_first_of("=;\n", at_), text_.size()); }

  std::string_view word() {
    const std::size_t begin = at_;
    while (!ended() && (is_word_start(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string string() {
    const std::size_t begin = at_;
    const char quote = text_[at_++];
    std::string value;
    for (;;) {
      if (ended() || (quote != '`' && (text_[at_] == '\n' || text_[at_] == '\r')))
        throw Malformed{begin, "this string does not end"};
      const char c = text_[at_++];
      if (c == quote) return value;
      if (quote == '`' && c == '$' && mark() == '{')
        throw Malformed{at_ - 1, "a template with ${…}: no code is run"};
      if (c == '\\')
        escape(value);
      else
        value += c;
    }
  }

  double number() {
    const std::size_t begin = at_;
    double sign = 1;
    if (mark() == '-' || mark() == '+') sign = text_[at_++] == '-' ? -1 : 1;
    skip();
    if (text_.substr(at_, 2) == "0x" || text_.substr(at_, 2) == "0X")
      return at_ += 2, sign * double(hex(16, 1));
    double value = 0;
    const std::size_t digits = at_;
    while (!ended() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    if (!ended() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (mark() == '-' || mark() == '+') ++at_;
      while (!ended() && is_digit(text_[at_])) ++at_;
    }
    const char* const end = text_.data() + at_;
    const auto [stop, status] = from_chars(text_.data() + digits, end, value);
    if (status == std::errc::result_out_of_range)
      throw Malformed{begin, "this number is too large or too small"};
    const bool dot_last = stop + 1 == end && *stop == '.';
    if (status != std::errc{} || (stop != end && !dot_last) || is_word_start(mark()))
      throw Malformed{begin, "expected a number"};
    return sign * value;
  }

 private:
  std::uint64_t hex(std::size_t most, std::size_t least) {
    const std::size_t begin = at_;
    std::uint64_t value = 0;
    for (; at_ - begin < most && !ended(); ++at_) {
      const char c = text_[at_];
      const int digit = is_digit(c)              ? c - '0'
                        : (c >= 'a' && c <= 'f') ? c - 'a' + 10
                        : (c >= 'A' && c <= 'F') ? c - 'A' + 10
                                                 : -1;
      if (digit < 0) break;
      value = value * 16 + std::uint64_t(digit);
    }
    if (at_ - begin < least) throw Malformed{begin, "expected hexadecimal digits"};
    return value;
  }

  void escape(std::string& value) {
    if (ended()) throw Malformed{at_, "this string does not end"};
    const char c = text_[at_++];
    constexpr std::string_view kFrom = "nrtbfv0", kTo{"\n\r\t\b\f\v\0", 7};
    if (const std::size_t found = kFrom.find(c); found != std::string_view::npos) {
      value += kTo[found];
    } else if (c == 'x') {
      append_utf8(value, std::uint32_t(hex(2, 2)));
    } else if (c == 'u' && mark() == '{') {
      step();
      const std::uint64_t code = hex(6, 1);
      if (mark() != '}' || code > 0x10FFFF) throw Malformed{at_, "expected a code point and }"};
      step();
      append_utf8(value, std::uint32_t(code));
    } else if (c == 'u') {
      std::uint64_t code = hex(4, 4);
      if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_, 2) == "\\u") {
        at_ += 2;
        const std::uint64_t low = hex(4, 4);
        code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00)
                                             : 0xFFFD;
      }
      append_utf8(value, std::uint32_t(code));
    } else if (c == '\r') {
      if (mark() == '\n') step();
    } else if (c != '\n') {
      value += c;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Builds the tree. Containers stand on a list, not on the call stack.
class LiteralReader {
 public:
  LiteralReader(JsonTree& tree, std::string_view text, const FaceLimits& limits)
      : tree_(tree), scan_(text), limits_(limits) {}

  void read() {
    JsonNode root;
    root.kind = JsonKind::object;
    tree_.nodes.push_back(root);
    open_.push_back({0, -1});
    for (scan_.skip(); !scan_.ended(); scan_.skip()) {
      if (scan_.mark() == ';') {
        scan_.step();
        continue;
      }
      statement();
    }
  }

 private:
  struct Open {
    std::int32_t node, last;
  };

  /// `var NAME = LITERAL`, `export const NAME = LITERAL`, `export default LITERAL`, `module.exports = LITERAL`, a bare
  /// LITERAL, each perhaps in parentheses or with TypeScript's types; or anything else, which is passed over.
  void statement() {
    const std::size_t begin = scan_.at();
    std::string name;
    if (is_word_start(scan_.mark()) && !named(name)) return pass_over();
    int parentheses = 0;
    for (; scan_.mark() == '('; scan_.skip()) scan_.step(), ++parentheses;
    if (scan_.mark() != '{') return pass_over();
    set_key(std::move(name), begin);
    value();
    while (open_.size() > 1) item();
    keys_differ();
    for (scan_.skip(); parentheses > 0 && scan_.mark() == ')'; --parentheses, scan_.skip())
      scan_.step();
    if (parentheses > 0) throw Malformed{scan_.at(), "expected )"};
    if (is_word_start(scan_.mark()) && scan_.begins_with_word({"as", "satisfies"})) pass_over();
  }

  /// What the literal that comes next is assigned to; false: none comes next.
  bool named(std::string& name) {
    const auto next = [&] { name = scan_.word(), scan_.skip(); };
    next();
    if (name == "export") {
      next();
      if (name == "default") return name.clear(), true;
      if (name.empty()) return false;
    }
    if (name == "var" || name == "let" || name == "const") next();
    while (scan_.mark() == '.') scan_.step(), scan_.skip(), next();
    if (scan_.mark() == ':') scan_.pass_to_equals();
    if (scan_.mark() != '=') return false;
    scan_.step(), scan_.skip();
    return true;
  }

  /// Other code is not run: it ends with a semicolon, a line or a block.
  void pass_over() {
    int depth = 0;
    while (!scan_.ended()) {
      if (scan_.skip_comment()) continue;
      const char c = scan_.mark();
      if (c == '\'' || c == '"' || c == '`') {
        scan_.string();
        continue;
      }
      const bool opens = c == '(' || c == '[' || c == '{',
                 closes = c == ')' || c == ']' || c == '}';
      depth += int(opens) - int(closes);
      if (depth < 0) throw Malformed{scan_.at(), fmt::format("a {} that nothing opens", c)};
      scan_.step();
      if (depth == 0 && (c == ';' || c == '\n' || c == '}')) return;
    }
    if (depth > 0) throw Malformed{scan_.at(), "the text ends too early"};
  }

  void set_key(std::string name, std::size_t offset) {
    key_ = keep(std::move(name)), key_offset_ = offset;
  }

  std::int32_t keep(std::string_view text) { return tree_.keep(text); }

  /// What comes next in the container that is open: a member or element, or its end.
  void item() {
    scan_.skip();
    const bool object = tree_.nodes[std::size_t(open_.back().node)].kind == JsonKind::object;
    const char end = object ? '}' : ']';
    if (scan_.mark() == end) {
      scan_.step();
      if (object) keys_differ();
      open_.pop_back();
      after_value();
      return;
    }
    if (object) {
      const std::size_t begin = scan_.at();
      set_key(key(), begin);
      scan_.skip();
      if (scan_.mark() != ':') throw Malformed{scan_.at(), "expected : after a key"};
      scan_.step(), scan_.skip();
    }
    value();
  }

  std::string key() {
    const char c = scan_.mark();
    if (c == '\'' || c == '"') return scan_.string();
    if (is_word_start(c)) return std::string{scan_.word()};
    if (is_digit(c)) return fmt::format("{}", scan_.number());
    throw Malformed{scan_.at(), scan_.ended() ? "the text ends in the middle of an object"
                                              : "expected a key or }"};
  }

  /// A comma, or the end of the container.
  void after_value() {
    if (open_.size() == 1) return;
    scan_.skip();
    const bool object = tree_.nodes[std::size_t(open_.back().node)].kind == JsonKind::object;
    const char end = object ? '}' : ']';
    if (scan_.mark() == ',')
      scan_.step();
    else if (scan_.mark() != end)
      throw Malformed{scan_.at(), scan_.ended() ? "the text ends too early"
                                                : fmt::format("expected , or {}", end)};
  }

  void value() {
    const std::size_t begin = scan_.at();
    const char c = scan_.mark();
    if (c == '{' || c == '[') {
      scan_.step();
      open_.push_back({add(c == '{' ? JsonKind::object : JsonKind::array, begin), -1});
      if (open_.size() > std::size_t(std::max(limits_.nesting, 0)) + 1)
        throw Malformed{begin, fmt::format("arrays and objects nested more than {} deep (limit: "
                                           "nesting)",
                                           limits_.nesting)};
      return;
    }
    if (c == '\'' || c == '"' || c == '`') {
      const std::int32_t text = keep(scan_.string());
      tree_.nodes[std::size_t(add(JsonKind::string, begin))].text = text;
    } else if (is_word_start(c)) {
      word_value(begin);
    } else if (is_digit(c) || c == '-' || c == '+' || c == '.') {
      const double number = scan_.number();
      if (!(std::abs(number) <= limits_.magnitude))
        throw Malformed{begin, fmt::format("{} is too large (limit: magnitude)", number)};
      tree_.nodes[std::size_t(add(JsonKind::number, begin))].number = number;
    } else {
      throw Malformed{begin, scan_.ended() ? "the text ends too early" : "expected a value"};
    }
    after_value();
  }

  void word_value(std::size_t begin) {
    const std::string_view word = scan_.word();
    if (word == "null") {
      add(JsonKind::null, begin);
    } else if (word == "true" || word == "false") {
      tree_.nodes[std::size_t(add(JsonKind::boolean, begin))].number = word == "true";
    } else {
      throw Malformed{begin, fmt::format("expected a value, got {}: no code is run",
                                         in_quotes(one_line(word, 40)))};
    }
  }

  std::int32_t add(JsonKind kind, std::size_t offset) {
    if (tree_.nodes.size() >= limits_.values)
      throw Malformed{offset, fmt::format("more than {} values (limit: values)", limits_.values)};
    const auto index = std::int32_t(tree_.nodes.size());
    Open& container = open_.back();
    JsonNode node;
    node.kind = kind;
    node.offset = std::uint32_t(offset);
    node.parent = container.node;
    JsonNode& parent = tree_.nodes[std::size_t(container.node)];
    if (parent.kind == JsonKind::object)
      tree_.name(node, key_), node.key_offset = std::uint32_t(key_offset_);
    (container.last < 0 ? parent.first : tree_.nodes[std::size_t(container.last)].next) = index;
    container.last = index;
    ++parent.count;
    tree_.nodes.push_back(node);
    return index;
  }

  void keys_differ() const {
    std::unordered_set<std::string_view> seen;
    const JsonNode& object = tree_.nodes[std::size_t(open_.back().node)];
    for (const JsonNode* child = tree_.first(object); child; child = tree_.next(*child))
      if (!seen.insert(tree_.key(*child)).second)
        throw Malformed{child->key_offset,
                        fmt::format("the key {} stands here twice", in_quotes(tree_.key(*child)))};
  }

  JsonTree& tree_;
  Scanner scan_;
  const FaceLimits& limits_;
  std::vector<Open> open_;
  std::int32_t key_ = -1;
  std::size_t key_offset_ = 0;
};

}  // namespace

Expected<JsonTree> read_javascript(std::string_view text, std::string_view name,
                                   const FaceLimits& limits) {
  JsonTree tree(text, one_line(name));
  try {
    LiteralReader(tree, text, limits).read();
  } catch (const Malformed& malformed) {
    return Error{tree.where(malformed.offset), malformed.what};
  }
  return tree;
}

}  // namespace mien
