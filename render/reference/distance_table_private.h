#pragma once
// Distances at places of one pixel, each asked once: squares share corners with their neighbours and
// quarters.

#include <cstdint>
#include <vector>

namespace mien {

class DistanceTable {
 public:
  /// Forgets all.
  void begin() {
    if (entries_.empty()) entries_.resize(std::size_t{1} << 10);
    ++stamp_, used_ = 0;
  }

  /// The distance to a shape at a place, in 1/2048 px: the one already known, or else `ask()`.
  template <class Ask>
  double at(int shape, int x, int y, Ask&& ask) {
    if (2 * used_ > entries_.size()) grow();
    Entry& e = find(std::uint64_t(shape) << 24 | std::uint64_t(x) << 12 | std::uint64_t(y));
    if (e.stamp != stamp_) e.stamp = stamp_, ++used_, e.distance = ask();
    return e.distance;
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint64_t stamp = 0;  ///< of the pixel it is of
    double distance = 0;
  };

  /// That of a key, or the free one where it belongs.
  Entry& find(std::uint64_t key) {
    const std::size_t mask = entries_.size() - 1;
    std::size_t i = std::size_t(key * 0x9e3779b97f4a7c15ull >> 32) & mask;
    while (entries_[i].stamp == stamp_ && entries_[i].key != key) i = (i + 1) & mask;
    if (entries_[i].stamp != stamp_) entries_[i].key = key;
    return entries_[i];
  }

  void grow() {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& e : old)
      if (e.stamp == stamp_) find(e.key) = e;
  }

  std::vector<Entry> entries_;
  std::uint64_t stamp_ = 0;
  std::size_t used_ = 0;
};

}  // namespace mien
