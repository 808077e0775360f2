#pragma once
// Key shapes: a table of slice values at given values of a control, interpolated linearly.

#include <vector>

namespace mien {

/// The value of a slice at one key: numbers, or the value that a slice of the same size has before the table
/// acts. Its own index means that it stays as it is.
struct KeyValue {
  int from = -1;  ///< a slice; −1: `numbers`
  std::vector<double> numbers;
};

struct KeyTrack {
  int slice;
  std::vector<KeyValue> values;  ///< one per key
};

/// Sets its slices to a mix of the two neighbouring keys. At a key they have exactly that key's values;
/// before the first and after the last key, the values of that key.
struct KeyShapes {
  std::vector<double> at;  ///< control values of the keys, rising; at least 1
  std::vector<KeyTrack> tracks;
};

}  // namespace mien
