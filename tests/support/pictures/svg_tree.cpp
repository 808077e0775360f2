#include "tests/support/pictures/svg_tree.h"

#include <set>
#include <stdexcept>
#include <utility>

namespace mien::test {
namespace {

class TreeReader {
 public:
  explicit TreeReader(std::string_view text) : text_(text) {}

  SvgElement read() {
    for (const char c : text_)
      if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
        fail("a control character");
    skip_space();
    SvgElement root = element();
    skip_space();
    if (at_ != text_.size()) fail("something follows the root");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("byte " + std::to_string(at_) + ": " + what);
  }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(std::string_view token) {
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    return true;
  }
  void need(std::string_view token) {
    if (!take(token)) fail("expected " + std::string(token));
  }
  void skip_space() {
    while (peek() == ' ' || peek() == '\n' || peek() == '\t') ++at_;
  }
  std::string name() {
    const std::size_t begin = at_;
    const auto part = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '-' || c == ':';
    };
    while (part(peek())) ++at_;
    if (at_ == begin) fail("expected a name");
    return std::string(text_.substr(begin, at_ - begin));
  }
  /// Up to `end`, which is left.
  std::string characters(char end) {
    static const std::pair<const char*, char> kEntities[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    std::string made;
    while (peek() != end) {
      if (at_ == text_.size()) fail("the file ends");
      if (peek() == '<') fail("< within a value");
      if (peek() != '&') {
        made += text_[at_++];
        continue;
      }
      bool known = false;
      for (const auto& [entity, c] : kEntities)
        if (!known && take(entity)) made += c, known = true;
      if (!known) fail("an unknown entity");
    }
    return made;
  }

  void attribute(SvgElement& to) {
    const std::string key = name();
    need("=\"");
    const std::string value = characters('"');
    need("\"");
    if (!to.attributes.emplace(key, value).second) fail("twice: " + key);
    if (key == "id" && !ids_.insert(value).second) fail("an id twice: " + value);
  }

  SvgElement element() {
    need("<");
    SvgElement made;
    made.tag = name();
    for (;;) {
      skip_space();
      if (take("/>")) return made;
      if (take(">")) break;
      attribute(made);
    }
    for (;;) {
      made.text += characters('<');
      if (take("</")) break;
      made.children.push_back(element());
    }
    if (name() != made.tag) fail("another tag closes " + made.tag);
    need(">");
    return made;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::set<std::string> ids_;
};

}  // namespace

SvgElement read_svg_tree(std::string_view text) {
  return TreeReader(text).read();
}

}  // namespace mien::test
