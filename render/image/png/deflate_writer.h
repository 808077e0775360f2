#pragma once
// The writing half of DEFLATE (RFC 1951): tokens, what they cost, and blocks of them as bits.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mien {

/// A byte, or a match: length · 65536 + distance, of 3 to 258 and 1 to 32768.
using DeflateToken = std::uint32_t;
inline DeflateToken deflate_match(std::size_t length, std::size_t distance) {
  return DeflateToken(length << 16 | distance);
}

inline constexpr std::size_t kDeflateWindow = 32768, kDeflateLongest = 258;

/// The symbol that ends a block; and the order in which a block's header gives the lengths of the words that its
/// other lengths are coded in (3.2.7).
inline constexpr int kDeflateEnd = 256;
inline constexpr std::array<std::uint8_t, 19> kDeflateHeaderOrder{
    16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

/// The symbol that stands for a number, and how many bits of the number follow it.
struct DeflateSymbol {
  std::uint16_t symbol;
  std::uint8_t extra;
  std::uint16_t base;
};
DeflateSymbol length_symbol(std::size_t length);
DeflateSymbol distance_symbol(std::size_t distance);

/// How often symbols occur.
struct DeflateCounts {
  static constexpr std::size_t kLengths = 286, kDistances = 30;
  std::array<std::uint32_t, kLengths> lengths{};  ///< bytes, the block's end, lengths
  std::array<std::uint32_t, kDistances> distances{};
  void add(DeflateToken token);
};

/// Joins tokens to blocks of a fixed number, each with codes of its own: what the bytes are depends on
/// the tokens alone, not on how they come.
class DeflateWriter {
 public:
  void add(std::span<const DeflateToken> tokens);
  /// Writes what is left and the stream's end, up to a whole byte.
  void finish();

  /// Whole bytes written so far; the reader clears them.
  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  void write_block();
  void put(std::uint64_t bits, int count);  // up to 32
  void write_bytes(int count);

  std::vector<DeflateToken> tokens_;  // of the block at hand
  std::vector<std::byte> bytes_;
  std::uint64_t bits_ = 0;
  int filled_ = 0;  // fewer than 32
};

}  // namespace mien
