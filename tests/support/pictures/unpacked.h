#pragma once
// What DEFLATE's streams and tokens unpack to, by zlib and by their meaning.

#include "render/image/png/deflate_writer.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <span>
#include <string>
#include <vector>

namespace mien::test {

/// A raw stream, whole.
inline std::string unpacked(std::span<const std::byte> stream, std::size_t size) {
  z_stream z{};
  ::inflateInit2(&z, -15);
  std::string to(size + 1, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(stream.data()));
  z.avail_in = uInt(stream.size());
  z.next_out = reinterpret_cast<Bytef*>(to.data());
  z.avail_out = uInt(to.size());
  EXPECT_EQ(::inflate(&z, Z_FINISH), Z_STREAM_END) << (z.msg ? z.msg : "");
  EXPECT_EQ(z.avail_in, 0u);
  to.resize(z.total_out);
  ::inflateEnd(&z);
  return to;
}

inline std::string expanded(std::span<const DeflateToken> tokens) {
  std::string to;
  for (const DeflateToken token : tokens) {
    if (token < 256) {
      to += char(token);
      continue;
    }
    const std::size_t length = token >> 16, distance = token & 0xffff;
    EXPECT_TRUE(3 <= length && length <= kDeflateLongest) << length;
    EXPECT_TRUE(1 <= distance && distance <= std::min(to.size(), kDeflateWindow)) << distance;
    if (distance < 1 || distance > to.size()) return to;
    for (std::size_t i = 0; i < length; ++i) to += to[to.size() - distance];
  }
  return to;
}

}  // namespace mien::test
