#pragma once
// Key shapes: a table of slice values at certain values of a control, with straight lines between.

#include <vector>

namespace mien {

/// What a slice is at one key: numbers, or wherever a slice of the same size is before the table
/// acts (its own index: it stays as it is).
struct KeyValue {
  int from = -1;  ///< a slice; −1: `numbers`
  std::vector<double> numbers;
};

struct KeyTrack {
  int slice;
  std::vector<KeyValue> values;  ///< one per key
};

/// Sets its slices to a mix of two neighbouring keys; at a key, to that key's values exactly;
/// beyond the first or last key, to its values.
struct KeyShapes {
  std::vector<double> at;  ///< control values of the keys, rising; at least 1
  std::vector<KeyTrack> tracks;
};

}  // namespace mien
