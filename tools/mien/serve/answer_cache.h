#pragma once
// Pictures that were drawn, as many as their memory allows; those asked for longest ago make room.

#include "tools/mien/serve/drawn_face.h"

#include <cstdint>
#include <list>
#include <string>
#include <string_view>
#include <unordered_map>

namespace mien::command {

class AnswerCache {
 public:
  explicit AnswerCache(std::uint64_t most_bytes) : most_bytes_(most_bytes) {}

  /// Null: it is not there. Valid until the next `put`.
  const DrawnFace* find(std::string_view meaning);
  void put(const std::string& meaning, const DrawnFace& drawn);

  std::uint64_t bytes() const { return bytes_; }
  std::size_t count() const { return entries_.size(); }

 private:
  struct Entry {
    std::string meaning;
    DrawnFace drawn;
    /// With what lists and tables need beside it, by and large.
    std::uint64_t bytes() const { return 256 + meaning.capacity() + drawn.bytes->capacity(); }
  };

  const std::uint64_t most_bytes_;
  std::uint64_t bytes_ = 0;
  std::list<Entry> entries_;  // the latest first
  std::unordered_map<std::string_view, std::list<Entry>::iterator> by_meaning_;
};

}  // namespace mien::command
