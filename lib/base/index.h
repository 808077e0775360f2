#pragma once
// The position of something in the list of its kind. The type names the list, so that a feature's index
// cannot be taken for a gradient's.
//
//   const Index<Motion> clip = …;
//   if (clip) play(clip.in(model.clips));

#include <cstddef>
#include <vector>

namespace mien {

template <class T>
struct Index {
  int at = -1;  ///< −1: none

  explicit operator bool() const { return at >= 0; }
  /// The element at this position. There must be one: the index is not none, and the list is long enough.
  const T& in(const std::vector<T>& list) const { return list[std::size_t(at)]; }
  T& in(std::vector<T>& list) const { return list[std::size_t(at)]; }

  friend bool operator==(const Index&, const Index&) = default;
};

/// The index of the last element; none in an empty list.
template <class T>
Index<T> last_of(const std::vector<T>& list) {
  return {int(list.size()) - 1};
}

}  // namespace mien
