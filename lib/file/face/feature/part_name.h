#pragma once
// What a number of a feature is called in its feature: "half_width", "points/3", "patch/0/2".

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace mien {

/// Made without memory of its own, for a name that is put together and kept elsewhere.
class PartName {
 public:
  /// "KEY/3". A key of a feature, or the name of such a part: at most 40 bytes count.
  PartName(std::string_view key, int item) {
    key = key.substr(0, 40);
    char* at = std::copy(key.begin(), key.end(), text_.data());
    *at++ = '/';
    size_ = std::size_t(std::to_chars(at, text_.data() + text_.size(), item).ptr - text_.data());
  }

  operator std::string_view() const { return {text_.data(), size_}; }

 private:
  std::array<char, 64> text_;
  std::size_t size_ = 0;
};

}  // namespace mien
