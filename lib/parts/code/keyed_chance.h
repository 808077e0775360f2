#pragma once
// Chance without an order: every answer is a function of a seed and of the question's permanent number. A question more
// or less changes no other answer.

#include "lib/base/mixed_bits.h"

#include <cstdint>

namespace mien {

/// Answers for one seed.
class KeyedChance {
 public:
  explicit KeyedChance(std::uint64_t seed) : seed_(mixed_bits(seed)) {}

  /// 64 random bits for a question and a further number.
  std::uint64_t bits(std::uint64_t question, std::uint64_t more = 0) const {
    return mixed_bits(mixed_bits(seed_ ^ mixed_bits(question)) ^ more);
  }
  /// A number in [0, 1): a multiple of 2^-53.
  double share(std::uint64_t question) const { return double(bits(question) >> 11) * 0x1p-53; }
  /// A number in (−1, 1), near 0 more often: the mean of four. Its standard deviation is 1/√12.
  double bell(std::uint64_t question) const {
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < 4; ++i) sum += bits(question, i + 1) >> 13;
    return double(sum) * 0x1p-52 - 1.0;
  }

 private:
  std::uint64_t seed_;
};

}  // namespace mien
