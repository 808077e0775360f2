#pragma once
// Where a raw DEFLATE stream (RFC 1951) ends, to the bit: what it takes to append to it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace mien {

struct DeflateEnd {
  std::size_t last_block = 0;  ///< bit at which the last block begins: its "this is the last" flag
  std::size_t end = 0;         ///< bit behind the last block; the stream's last byte is padded
};

/// Walks over the codes without unpacking them, so it costs by the packed size. Nothing if the bytes
/// are no whole stream.
std::optional<DeflateEnd> deflate_end(std::span<const std::byte> stream);

}  // namespace mien
