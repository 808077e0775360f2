#pragma once
// Which number a name has, where the names themselves are kept elsewhere: eight bytes an entry, no memory for each.
//
//   table.enter("brow", 0);
//   table.find("brow", [&](int number) { return names[number]; })      // 0

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace mien {

class NameTable {
 public:
  /// The number that was entered with the name, or −1. `name_of(number)` is the name of one that was entered.
  template <class NameOf>
  int find(std::string_view name, NameOf&& name_of) const {
    if (table_.empty()) return -1;
    const std::uint32_t hash = hash_of(name);
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash & mask;
    for (; table_[at].number >= 0; at = (at + 1) & mask)
      if (table_[at].hash == hash && name_of(table_[at].number) == name) break;
    return table_[at].number;
  }

  /// The name must be new, and the number not negative.
  void enter(std::string_view name, int number) {
    if (2 * ++count_ > table_.size()) {
      const std::size_t more = table_.empty() ? 64 : 2 * table_.size();
      const std::vector<Place> old = std::exchange(table_, std::vector<Place>(more));
      for (const Place& known : old)
        if (known.number >= 0) put(known);
    }
    put({hash_of(name), number});
  }

 private:
  struct Place {
    std::uint32_t hash = 0;
    std::int32_t number = -1;  ///< −1: free
  };

  static std::uint32_t hash_of(std::string_view name) {
    return std::uint32_t(std::hash<std::string_view>{}(name));
  }
  void put(Place place) {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = place.hash & mask;
    while (table_[at].number >= 0) at = (at + 1) & mask;
    table_[at] = place;
  }

  std::vector<Place>
      table_;  ///< a power of two, at most half of them taken; searched from a name's hash on
  std::size_t count_ = 0;
};

}  // namespace mien
