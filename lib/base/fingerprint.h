#pragma once
// A 64-bit hash of data: different data practically never share one.

#include <cstdint>
#include "lib/base/bit_cast.h"

namespace mien {

/// The hash of a sequence of numbers, in their order. Two sequences share one with a probability of 2⁻⁶⁴.
class Fingerprint {
 public:
  explicit Fingerprint(std::uint64_t seed = 0) : value_(seed) {}

  /// Each step is invertible once the number is known, so sequences that differ in one number differ in the
  /// hash.
  void add(std::uint64_t number) {
    value_ = (value_ ^ number) * 0x9e3779b97f4a7c15ull;
    value_ ^= value_ >> 32;
  }
  void add(int number) { add(std::uint64_t(std::int64_t(number))); }
  void add(bool yes) { add(std::uint64_t(yes)); }
  void add(double number) { add(mien::bit_cast<std::uint64_t>(number)); }  ///< −0 and 0 differ

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace mien
