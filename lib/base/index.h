#pragma once
// The place of something in the list of its kind. It counts for lists of that kind alone, so that a feature's
// index cannot be taken for a gradient's.
//
//   const Index<Clip> clip = …;
//   if (clip) play(clip.in(model.clips));

#include <cstddef>
#include <vector>

namespace mien {

template <class T>
struct Index {
  int at = -1;  ///< −1: none

  explicit operator bool() const { return at >= 0; }
  /// What stands there in a list that is long enough; not for none.
  const T& in(const std::vector<T>& list) const { return list[std::size_t(at)]; }
  T& in(std::vector<T>& list) const { return list[std::size_t(at)]; }

  friend bool operator==(const Index&, const Index&) = default;
};

/// Where the last of a list stands; none in an empty one.
template <class T>
Index<T> last_of(const std::vector<T>& list) {
  return {int(list.size()) - 1};
}

}  // namespace mien
