#include <mien/names.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace mien {

std::string_view Names::keep(std::initializer_list<std::string_view> parts) {
  constexpr std::size_t kBlock = 4096, kMostBlock = 65536;  // [bytes]
  std::size_t size = 0;
  for (const std::string_view part : parts) size += part.size();
  if (size > left_ || !next_) {
    const std::size_t usual =
        std::min(kBlock << std::min<std::size_t>(blocks_.size(), 4), kMostBlock);
    const std::size_t room = std::max(size, usual);
    std::shared_ptr<char[]> block(new char[room]);  // it has an owner before the list grows
    blocks_.push_back(std::move(block));
    next_ = blocks_.back().get();
    left_ = room;
  }
  const std::string_view kept{next_, size};
  for (const std::string_view part : parts) next_ = std::copy(part.begin(), part.end(), next_);
  left_ -= size;
  return kept;
}

}  // namespace mien
