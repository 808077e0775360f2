#include "render/image/png/deflate_writer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

namespace mien {
namespace {

constexpr std::size_t kBlock = std::size_t(1)
                               << 14;  // tokens: codes are 90 bytes, so few want more

struct Package {
  std::uint64_t weight;
  int first, second;  // packages of the level before; second < 0: a symbol

  friend bool operator<(const Package& a, const Package& b) { return a.weight < b.weight; }
};

/// `most` levels of packages, cheapest first: the symbols, merged with pairs of the level before.
std::vector<std::vector<Package>> package_levels(const std::vector<Package>& symbols, int most) {
  std::vector<std::vector<Package>> levels{symbols};
  while (int(levels.size()) < most) {
    const auto& below = levels.back();
    std::vector<Package> pairs, both;
    for (std::size_t i = 0; i + 1 < below.size(); i += 2)
      pairs.push_back({below[i].weight + below[i + 1].weight, int(i), int(i + 1)});
    std::merge(symbols.begin(), symbols.end(), pairs.begin(), pairs.end(),
               std::back_inserter(both));
    levels.push_back(std::move(both));
  }
  return levels;
}

/// The lengths of a prefix code's words, none longer than `most`; 0: the symbol does not occur. By
/// package-merge (Larmore and Hirschberg 1990), which is optimal: each of the 2n − 2 cheapest packages
/// of n symbols adds a bit to the words it holds.
void code_lengths(std::span<const std::uint32_t> counts, int most,
                  std::span<std::uint8_t> lengths) {
  std::vector<Package> symbols;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    lengths[i] = 0;
    if (counts[i]) symbols.push_back({counts[i], int(i), -1});
  }
  std::stable_sort(symbols.begin(), symbols.end());
  if (symbols.size() < 2) {  // a code of one word still takes a bit
    for (const Package& symbol : symbols) lengths[std::size_t(symbol.first)] = 1;
    return;
  }
  const auto levels = package_levels(symbols, most);
  // Packages are taken cheapest first, so the first ones of a level hold the first ones below.
  std::size_t taken = 2 * symbols.size() - 2;
  for (std::size_t level = levels.size(); level-- > 0 && taken > 0;) {
    std::size_t held = 0;
    for (std::size_t i = 0; i < taken; ++i) {
      const Package& p = levels[level][i];
      if (p.second < 0)
        ++lengths[std::size_t(p.first)];
      else
        held += 2;
    }
    taken = held;
  }
}

/// Canonical words, their highest bit first as they are written.
template <std::size_t kSize>
struct CodeWords {
  std::array<std::uint8_t, kSize> lengths{};
  std::array<std::uint16_t, kSize> words{};

  CodeWords(std::span<const std::uint32_t> counts, int most) {
    code_lengths(counts, most, lengths);
    std::uint32_t word = 0;
    for (int length = 1; length <= most; ++length, word <<= 1) {
      for (std::size_t i = 0; i < kSize; ++i) {
        if (lengths[i] != length) continue;
        for (int k = 0; k < length; ++k) {
          words[i] = std::uint16_t(words[i] | (word >> k & 1) << (length - 1 - k));
        }
        ++word;
      }
    }
  }
};

/// The lengths of words as a header gives them: symbol, extra bits.
struct HeaderWord {
  std::uint8_t symbol, extra, value;
};
std::vector<HeaderWord> header_words(std::span<const std::uint8_t> lengths) {
  std::vector<HeaderWord> words;
  for (std::size_t i = 0, end; i < lengths.size(); i = end) {
    end = i + 1;
    while (end < lengths.size() && lengths[end] == lengths[i]) ++end;
    std::size_t left = end - i;
    if (lengths[i] != 0) words.push_back({lengths[i], 0, 0}), --left;
    while (left >= 3) {
      const std::size_t most = lengths[i] != 0 ? 6 : left < 11 ? 10 : 138;
      const std::size_t now = std::min(left, most);
      if (lengths[i] != 0)
        words.push_back({16, 2, std::uint8_t(now - 3)});
      else if (now < 11)
        words.push_back({17, 3, std::uint8_t(now - 3)});
      else
        words.push_back({18, 7, std::uint8_t(now - 11)});
      left -= now;
    }
    while (left-- > 0) words.push_back({lengths[i], 0, 0});
  }
  return words;
}

}  // namespace

DeflateSymbol length_symbol(std::size_t length) {
  if (length == kDeflateLongest) return {285, 0, 258};
  const std::size_t n = length - 3;
  if (n < 8) return {std::uint16_t(257 + n), 0, std::uint16_t(length)};
  const int extra = int(std::bit_width(n)) - 3;  // four symbols to each number of bits
  const std::size_t step = n >> extra;
  return {std::uint16_t(257 + 4 * std::size_t(extra) + step), std::uint8_t(extra),
          std::uint16_t((step << extra) + 3)};
}

DeflateSymbol distance_symbol(std::size_t distance) {
  const std::size_t n = distance - 1;
  if (n < 4) return {std::uint16_t(n), 0, std::uint16_t(distance)};
  const int extra = int(std::bit_width(n)) - 2;  // two symbols to each
  const std::size_t step = n >> extra;
  return {std::uint16_t(2 * std::size_t(extra) + step), std::uint8_t(extra),
          std::uint16_t((step << extra) + 1)};
}

void DeflateCounts::add(DeflateToken token) {
  if (token < 256) {
    ++lengths[token];
  } else {
    ++lengths[length_symbol(token >> 16).symbol];
    ++distances[distance_symbol(token & 0xffff).symbol];
  }
}

void DeflateWriter::put(std::uint64_t bits, int count) {
  bits_ |= bits << filled_;
  filled_ += count;
  if (filled_ >= 32) write_bytes(4);
}

void DeflateWriter::write_bytes(int count) {
  const std::size_t at = bytes_.size();
  bytes_.resize(at + std::size_t(count));
  std::memcpy(&bytes_[at], &bits_, std::size_t(count));
  bits_ >>= 8 * count, filled_ -= 8 * count;
}

void DeflateWriter::add(std::span<const DeflateToken> tokens) {
  while (!tokens.empty()) {
    const std::size_t now = std::min(tokens.size(), kBlock - tokens_.size());
    tokens_.insert(tokens_.end(), tokens.begin(), tokens.begin() + std::ptrdiff_t(now));
    tokens = tokens.subspan(now);
    if (tokens_.size() == kBlock) write_block();
  }
}

void DeflateWriter::finish() {
  if (!tokens_.empty()) write_block();
  put(3, 10);  // the last block: of fixed codes, and empty
  filled_ = (filled_ + 7) & ~7;
  write_bytes(filled_ / 8);
}

void DeflateWriter::write_block() {
  DeflateCounts counts;
  counts.lengths[kDeflateEnd] = 1;
  for (const DeflateToken token : tokens_) counts.add(token);
  const CodeWords<DeflateCounts::kLengths> lengths(counts.lengths, 15);
  const CodeWords<DeflateCounts::kDistances> distances(counts.distances, 15);
  std::vector<std::uint8_t> all(lengths.lengths.begin(), lengths.lengths.end());
  all.insert(all.end(), distances.lengths.begin(), distances.lengths.end());
  const std::vector<HeaderWord> words = header_words(all);
  std::array<std::uint32_t, 19> header_counts{};
  for (const HeaderWord& w : words) ++header_counts[w.symbol];
  const CodeWords<19> header(header_counts, 7);

  put(4, 3);  // not the last, with codes of its own
  put(DeflateCounts::kLengths - 257, 5), put(DeflateCounts::kDistances - 1, 5), put(19 - 4, 4);
  for (const std::uint8_t symbol : kDeflateHeaderOrder) put(header.lengths[symbol], 3);
  for (const HeaderWord& w : words) {
    put(header.words[w.symbol], header.lengths[w.symbol]);
    put(w.value, w.extra);
  }
  const auto put_word = [&](const auto& code, const DeflateSymbol& s, std::size_t number) {
    const int length = code.lengths[s.symbol];
    put(code.words[s.symbol] | (number - s.base) << length, length + s.extra);
  };
  for (const DeflateToken token : tokens_) {
    if (token < 256) {
      put(lengths.words[token], lengths.lengths[token]);
      continue;
    }
    const std::size_t length = token >> 16, distance = token & 0xffff;
    put_word(lengths, length_symbol(length), length);
    put_word(distances, distance_symbol(distance), distance);
  }
  put(lengths.words[kDeflateEnd], lengths.lengths[kDeflateEnd]);
  tokens_.clear();
}

}  // namespace mien
