#pragma once
// A number that stands for data: as good as never the same for two that differ.

#include <bit>
#include <cstdint>

namespace mien {

/// Taken of numbers one after the other, in their order. Two sequences share one with odds of 2⁻⁶⁴.
class Fingerprint {
 public:
  explicit Fingerprint(std::uint64_t seed = 0) : value_(seed) {}

  /// Every step can be undone when the number is known: what differs in one number differs.
  void add(std::uint64_t number) {
    value_ = (value_ ^ number) * 0x9e3779b97f4a7c15ull;
    value_ ^= value_ >> 32;
  }
  void add(int number) { add(std::uint64_t(std::int64_t(number))); }
  void add(bool yes) { add(std::uint64_t(yes)); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }  ///< −0 is not 0

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

}  // namespace mien
