#include <mien/render/image/deflate_end.h>

#include <gtest/gtest.h>
#include <libdeflate.h>
#include <zlib.h>

#include <random>
#include <string>
#include <vector>

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

std::string unpacked(const Bytes& stream, std::size_t most) {
  z_stream z{};
  ::inflateInit2(&z, -15);
  std::string to(most + 1, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(stream.data()));
  z.avail_in = uInt(stream.size());
  z.next_out = reinterpret_cast<Bytef*>(to.data());
  z.avail_out = uInt(to.size());
  EXPECT_EQ(::inflate(&z, Z_FINISH), Z_STREAM_END);
  EXPECT_EQ(z.avail_in, 0u);
  to.resize(z.total_out);
  ::inflateEnd(&z);
  return to;
}

/// Appends a literal of the fixed code right behind the end, bit by bit: that works only if the end
/// is right and the flag is the last block's.
Bytes with_one_more(Bytes stream, const DeflateEnd& end) {
  const auto flip = [&](std::size_t bit) {
    if (stream.size() <= bit / 8) stream.resize(bit / 8 + 1, std::byte(0));
    stream[bit / 8] ^= std::byte(1) << bit % 8;
  };
  flip(end.last_block);
  // Last block 1, fixed code 01 (lowest bit first), 'A' = 0x30 + 65 = 01110001, end 0000000.
  const std::string bits =
      "1"
      "10"
      "01110001"
      "0000000";
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i] == '1') flip(end.end + i);
  }
  stream.resize((end.end + bits.size() + 7) / 8, std::byte(0));
  return stream;
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

TEST(DeflateEnd, IsWhereMoreCanBeAppended) {
  for (const std::string& data : samples()) {
    std::vector<Bytes> streams;
    for (int level : {0, 1, 2, 6, 9, 12}) streams.push_back(packed_by_libdeflate(data, level));
    for (int strategy : {Z_DEFAULT_STRATEGY, Z_HUFFMAN_ONLY, Z_RLE, Z_FIXED})
      streams.push_back(packed_by_zlib(data, 6, strategy));
    streams.push_back(packed_by_zlib(data, 0, Z_DEFAULT_STRATEGY));
    for (const Bytes& stream : streams) {
      const auto end = deflate_end(stream);
      ASSERT_TRUE(end) << data.size() << " in " << stream.size();
      EXPECT_LE(end->end, 8 * stream.size());
      EXPECT_GT(end->end + 8, 8 * stream.size());
      EXPECT_TRUE(unpacked(with_one_more(stream, *end), data.size() + 1) == data + "A");
    }
  }
}

TEST(DeflateEnd, OfNoStreamIsNothing) {
  EXPECT_FALSE(deflate_end({}));
  EXPECT_FALSE(deflate_end(Bytes{std::byte(7)})) << "the block type that does not exist";
  const Bytes whole = packed_by_libdeflate(samples()[4], 6);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 300) {
    EXPECT_FALSE(deflate_end(std::span(whole).first(size))) << size;
  }
}

TEST(DeflateEnd, OfAnyBytesComesBack) {
  std::mt19937 dice(11);
  for (int i = 0; i < 3000; ++i) {
    Bytes bytes(dice() % 200);
    for (std::byte& b : bytes) b = std::byte(dice() & 255);
    const auto end = deflate_end(bytes);
    EXPECT_LE(end ? end->end : 0, 8 * bytes.size());
  }
}

}  // namespace
}  // namespace mien
