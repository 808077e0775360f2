#pragma once
// A face as a short word: twelve signs that mean one face, and values held against them.

#include <mien/api.h>
#include <mien/expected.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// A value that a code holds whatever its seed says.
struct HeldValue {
  int field = 0;  ///< permanent number of a family or of a number, 0 … 1023
  int value = 0;  ///< permanent number of a part, or 1/1023 of a number's range, 0 … 1023

  friend bool operator==(const HeldValue&, const HeldValue&) = default;
};

/// What a code says: the seed of a face, and what is held against it.
struct FaceCode {
  static constexpr int kSeedBits = 50;

  std::uint64_t seed = 0;  ///< below 2^50
  std::vector<HeldValue> held;

  friend bool operator==(const FaceCode&, const FaceCode&) = default;
};

/// "AA7Q2-MKX4T-BY": the sign A of this library of parts, ten signs of the seed in Crockford's base 32, and a check sign that
/// finds any one wrong sign and any swap of neighbours. Held values follow as "~0H0C", field and value
/// in two signs each, and are checked too.
MIEN_API std::string face_code_text(const FaceCode& code);

/// Reads a code. Case and hyphens do not count, and O, I and L are read as 0, 1 and 1. The error says
/// what is wrong with it.
MIEN_API Expected<FaceCode> read_face_code(std::string_view text);

/// Whether a text looks like a code, right or wrong, rather than like the name of a file.
MIEN_API bool looks_like_face_code(std::string_view text);

/// The seed that a word stands for: the same word, the same seed.
MIEN_API std::uint64_t seed_from_word(std::string_view word);

}  // namespace mien
