#include "render/image/png/deflate_reader.h"

#include <gtest/gtest.h>
#include <libdeflate.h>
#include <zlib.h>

#include <random>
#include <string>
#include <vector>

#include "tests/support/pictures/unpacked.h"

namespace mien {
namespace {

using Bytes = std::vector<std::byte>;

Bytes packed_by_libdeflate(const std::string& data, int level) {
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(level);
  Bytes to(libdeflate_deflate_compress_bound(compressor, data.size()));
  to.resize(
      libdeflate_deflate_compress(compressor, data.data(), data.size(), to.data(), to.size()));
  libdeflate_free_compressor(compressor);
  return to;
}

Bytes packed_by_zlib(const std::string& data, int level, int strategy) {
  z_stream z{};
  ::deflateInit2(&z, level, Z_DEFLATED, -15, 8, strategy);
  Bytes to(::deflateBound(&z, data.size()));
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  z.avail_in = uInt(data.size());
  z.next_out = reinterpret_cast<Bytef*>(to.data());
  z.avail_out = uInt(to.size());
  ::deflate(&z, Z_FINISH);
  to.resize(z.total_out);
  ::deflateEnd(&z);
  return to;
}

std::vector<std::string> samples() {
  std::mt19937 dice(7);
  std::vector<std::string> samples{"", "a", std::string(100'000, '\0')};
  std::string noise, mixed, words;
  for (int i = 0; i < 70'000; ++i) noise += char(dice());
  for (int i = 0; i < 300; ++i) {
    mixed += std::string(dice() % 900, char('a' + dice() % 3));
    for (auto k = dice() % 700; k > 0; --k) mixed += char(dice() % (i % 2 ? 256 : 16));
    words += "line " + std::to_string(dice() % 1000) + (i % 7 ? " of text\n" : " and again\n");
  }
  samples.insert(samples.end(), {noise, mixed, words});
  return samples;
}

TEST(ReadDeflate, TokensAreWhatTheStreamUnpacksTo) {
  for (const std::string& data : samples()) {
    std::vector<Bytes> streams;
    for (int level : {0, 1, 2, 6, 9, 12}) streams.push_back(packed_by_libdeflate(data, level));
    for (int strategy : {Z_DEFAULT_STRATEGY, Z_HUFFMAN_ONLY, Z_RLE, Z_FIXED})
      streams.push_back(packed_by_zlib(data, 6, strategy));
    streams.push_back(packed_by_zlib(data, 0, Z_DEFAULT_STRATEGY));
    for (const Bytes& stream : streams) {
      std::vector<DeflateToken> tokens;
      ASSERT_TRUE(read_deflate(stream, tokens)) << data.size() << " in " << stream.size();
      EXPECT_TRUE(test::expanded(tokens) == data);
    }
  }
}

TEST(ReadDeflate, OfNoStreamIsFalse) {
  std::vector<DeflateToken> tokens;
  EXPECT_FALSE(read_deflate({}, tokens));
  EXPECT_FALSE(read_deflate(Bytes{std::byte(7)}, tokens)) << "the block type that does not exist";
  const Bytes whole = packed_by_libdeflate(samples()[4], 6);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 300) {
    EXPECT_FALSE(read_deflate(std::span(whole).first(size), tokens)) << size;
  }
}

TEST(ReadDeflate, OfAnyBytesComesBack) {
  std::mt19937 dice(11);
  for (int i = 0; i < 3000; ++i) {
    Bytes bytes(dice() % 200);
    for (std::byte& b : bytes) b = std::byte(dice() & 255);
    std::vector<DeflateToken> tokens;
    read_deflate(bytes, tokens);
    EXPECT_LE(tokens.size(), 8 * bytes.size());
  }
}

}  // namespace
}  // namespace mien
