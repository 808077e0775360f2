#include <mien/render/image/deflate_end.h>

#include <algorithm>
#include <array>
#include <vector>

namespace mien {
namespace {

constexpr int kEndOfBlock = 256;
constexpr int kLengths = 288, kDistances = 32;  // symbols a header can name
constexpr std::array<int, 29> kLengthExtra{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                           2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<int, 30> kDistanceExtra{0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                             6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
constexpr std::array<int, 19> kHeaderOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                           11, 4,  12, 3, 13, 2, 14, 1, 15};

/// Bits from the lowest of each byte up; zeros behind the end.
class Bits {
 public:
  explicit Bits(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t peek(int count) const {
    std::uint32_t word = 0;
    for (std::size_t i = 0, byte = at / 8; i < 4 && byte + i < bytes_.size(); ++i) {
      word |= std::uint32_t(bytes_[byte + i]) << 8 * i;
    }
    return word >> at % 8 & ((1u << count) - 1);
  }
  std::uint32_t take(int count) {
    const std::uint32_t bits = peek(count);
    at += std::size_t(count);
    return bits;
  }
  bool over() const { return at > 8 * bytes_.size(); }

  std::size_t at = 0;

 private:
  std::span<const std::byte> bytes_;
};

/// A prefix code, as a table over the next bits.
class Code {
 public:
  /// Canonical, from each symbol's length; 0: not used.
  explicit Code(std::span<const std::uint8_t> lengths) {
    for (const int length : lengths) bits_ = std::max(bits_, length);
    table_.assign(std::size_t(1) << bits_, 0);
    std::uint32_t code = 0;
    for (int length = 1; length <= bits_; ++length, code <<= 1) {
      for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
        if (lengths[symbol] == length) fill(code++, length, int(symbol));
      }
    }
  }

  /// The next symbol; −1 if the bits are no code.
  int symbol(Bits& bits) const {
    const std::uint16_t entry = table_[bits.peek(bits_)];
    bits.at += entry & 15;
    return (entry & 15) ? entry >> 4 : -1;
  }

 private:
  void fill(std::uint32_t code, int length, int symbol) {
    std::uint32_t first = 0;  // codes come with their highest bit first
    for (int i = 0; i < length; ++i) first |= (code >> i & 1) << (length - 1 - i);
    for (std::size_t i = first; i < table_.size(); i += std::size_t(1) << length) {
      table_[i] = std::uint16_t(symbol << 4 | length);
    }
  }

  int bits_ = 1;
  std::vector<std::uint16_t> table_;  // symbol · 16 + length
};

struct Codes {
  Code lengths, distances;
};

Codes fixed_codes() {
  std::array<std::uint8_t, kLengths> lengths;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  }
  std::array<std::uint8_t, kDistances> distances;
  distances.fill(5);
  return {Code(lengths), Code(distances)};
}

/// Reads a block's own codes; nothing if they make no sense.
std::optional<Codes> own_codes(Bits& bits) {
  const std::size_t lengths = bits.take(5) + 257, distances = bits.take(5) + 1;
  const std::size_t headers = bits.take(4) + 4;
  std::array<std::uint8_t, 19> header{};
  for (std::size_t i = 0; i < headers; ++i)
    header[std::size_t(kHeaderOrder[i])] = std::uint8_t(bits.take(3));
  const Code code(header);
  std::array<std::uint8_t, kLengths + kDistances> all{};
  for (std::size_t i = 0; i < lengths + distances;) {
    const int symbol = code.symbol(bits);
    if (symbol < 0 || bits.over() || (symbol == 16 && i == 0)) return {};
    if (symbol < 16) {
      all[i++] = std::uint8_t(symbol);
      continue;
    }
    const std::uint8_t value = symbol == 16 ? all[i - 1] : 0;
    std::size_t repeat = symbol == 16   ? 3 + bits.take(2)
                         : symbol == 17 ? 3 + bits.take(3)
                                        : 11 + bits.take(7);
    if (i + repeat > lengths + distances) return {};
    while (repeat--) all[i++] = value;
  }
  const std::span<const std::uint8_t> given(all);
  return Codes{Code(given.first(lengths)), Code(given.subspan(lengths, distances))};
}

bool skip_codes(Bits& bits, const Codes& codes) {
  while (!bits.over()) {
    const int symbol = codes.lengths.symbol(bits);
    if (symbol < 0) return false;
    if (symbol < kEndOfBlock) continue;
    if (symbol == kEndOfBlock) return true;
    const std::size_t length = std::size_t(symbol - kEndOfBlock - 1);
    if (length >= kLengthExtra.size()) return false;
    bits.at += std::size_t(kLengthExtra[length]);
    const int distance = codes.distances.symbol(bits);
    if (distance < 0 || std::size_t(distance) >= kDistanceExtra.size()) return false;
    bits.at += std::size_t(kDistanceExtra[std::size_t(distance)]);
  }
  return false;
}

bool skip_block(Bits& bits) {
  switch (bits.take(2)) {
    case 0: {
      bits.at = (bits.at + 7) / 8 * 8;
      const std::uint32_t length = bits.take(16);
      if ((bits.take(16) ^ length) != 0xffff) return false;
      bits.at += std::size_t(length) * 8;
      return true;
    }
    case 1: {
      static const Codes fixed = fixed_codes();
      return skip_codes(bits, fixed);
    }
    case 2: {
      const auto codes = own_codes(bits);
      return codes && skip_codes(bits, *codes);
    }
    default:
      return false;
  }
}

}  // namespace

std::optional<DeflateEnd> deflate_end(std::span<const std::byte> stream) {
  Bits bits(stream);
  for (;;) {
    const std::size_t begin = bits.at;
    const bool last = bits.take(1) == 1;
    if (!skip_block(bits) || bits.over()) return {};
    if (last) return DeflateEnd{begin, bits.at};
  }
}

}  // namespace mien
