#pragma once
// Changes of a JSON text at places of it: what is not changed keeps every byte.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Where the value that begins at `begin` ends: its last byte's offset and one. The text is one that was read.
std::size_t json_end(std::string_view text, std::size_t begin);

class TextEdits {
 public:
  /// `text` must outlive this.
  explicit TextEdits(std::string_view text) : text_(text) {}

  /// Says that `by` stands for the value that begins there.
  void replace(std::size_t begin, std::string by) {
    edits_.push_back({begin, json_end(text_, begin), std::move(by)});
  }
  /// Says that `what` stands before a byte; what was said first comes first.
  void insert(std::size_t at, std::string what) { edits_.push_back({at, at, std::move(what)}); }

  /// The text with all changes.
  std::string text() const { return text(0, text_.size()); }
  /// A part of it, with the changes that lie in it. Changes do not overlap.
  std::string text(std::size_t begin, std::size_t end) const;

 private:
  struct Edit {
    std::size_t begin, end;
    std::string by;
  };
  std::string_view text_;
  std::vector<Edit> edits_;
};

}  // namespace mien
