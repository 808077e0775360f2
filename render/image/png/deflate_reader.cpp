#include "render/image/png/deflate_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

namespace mien {
namespace {

constexpr int kLengths = 288, kDistances = 32;  // symbols a header can name

/// Bits from the lowest of each byte up; zeros behind the end.
class Bits {
 public:
  explicit Bits(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t peek(int count) const {
    std::uint32_t word = 0;
    const std::size_t byte = at / 8;
    if (byte < bytes_.size())
      std::memcpy(&word, &bytes_[byte], std::min<std::size_t>(4, bytes_.size() - byte));
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
    header[std::size_t(kDeflateHeaderOrder[i])] = std::uint8_t(bits.take(3));
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

/// What the symbols of a kind stand for, from the other way round.
template <std::size_t kSize>
std::array<DeflateSymbol, kSize> symbols(DeflateSymbol (*of)(std::size_t), std::size_t least,
                                         std::size_t most) {
  std::array<DeflateSymbol, kSize> table{};
  const std::size_t first = of(least).symbol;
  for (std::size_t n = least; n <= most; ++n) table[of(n).symbol - first] = of(n);
  return table;
}

bool read_codes(Bits& bits, const Codes& codes, std::vector<DeflateToken>& to) {
  static const auto lengths = symbols<29>(length_symbol, 3, kDeflateLongest);
  static const auto distances = symbols<30>(distance_symbol, 1, kDeflateWindow);
  while (!bits.over()) {
    const int symbol = codes.lengths.symbol(bits);
    if (symbol < 0) return false;
    if (symbol == kDeflateEnd) return true;
    if (symbol < kDeflateEnd) {
      to.push_back(DeflateToken(symbol));
      continue;
    }
    const std::size_t kind = std::size_t(symbol - kDeflateEnd - 1);
    if (kind >= lengths.size()) return false;
    const std::size_t length = lengths[kind].base + bits.take(lengths[kind].extra);
    const int far = codes.distances.symbol(bits);
    if (far < 0 || std::size_t(far) >= distances.size()) return false;
    const DeflateSymbol& d = distances[std::size_t(far)];
    to.push_back(deflate_match(length, d.base + bits.take(d.extra)));
  }
  return false;
}

bool read_block(Bits& bits, std::vector<DeflateToken>& to) {
  switch (bits.take(2)) {
    case 0: {
      bits.at = (bits.at + 7) / 8 * 8;
      const std::uint32_t length = bits.take(16);
      if ((bits.take(16) ^ length) != 0xffff) return false;
      for (std::uint32_t i = 0; i < length && !bits.over(); ++i) to.push_back(bits.take(8));
      return true;
    }
    case 1: {
      static const Codes fixed = fixed_codes();
      return read_codes(bits, fixed, to);
    }
    case 2: {
      const auto codes = own_codes(bits);
      return codes && read_codes(bits, *codes, to);
    }
    default:
      return false;
  }
}

}  // namespace

bool read_deflate(std::span<const std::byte> stream, std::vector<DeflateToken>& to) {
  Bits bits(stream);
  for (;;) {
    const bool last = bits.take(1) == 1;
    if (!read_block(bits, to) || bits.over()) return false;
    if (last) return true;
  }
}

}  // namespace mien
