#pragma once
// The names of a face. A thousand of them take a few blocks of memory, and what they name refers to them.

#include <mien/api.h>

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace mien {

/// Keeps texts where they are. A copy has all that were kept before it was made, at the same places; what is kept in
/// one of the two from then on is its own.
class MIEN_API Names {
 public:
  Names() = default;
  Names(const Names& other) : blocks_(other.blocks_) {}
  Names(Names&& other) noexcept { take(other); }
  Names& operator=(const Names& other) {
    if (this != &other) blocks_ = other.blocks_, next_ = nullptr, left_ = 0;
    return *this;
  }
  Names& operator=(Names&& other) noexcept {
    if (this != &other) take(other);
    return *this;
  }
  ~Names() = default;

  /// Keeps the parts, one after the other, as one text. It stays as long as this does, or a copy that was made later.
  std::string_view keep(std::initializer_list<std::string_view> parts);
  std::string_view keep(std::string_view name) { return keep({name}); }

 private:
  void take(Names& other) {
    blocks_ = std::exchange(other.blocks_, {});
    next_ = std::exchange(other.next_, nullptr), left_ = std::exchange(other.left_, 0);
  }

  std::vector<std::shared_ptr<char[]>> blocks_;
  char* next_ = nullptr;  ///< in the last block; null: in none
  std::size_t left_ = 0;
};

}  // namespace mien
