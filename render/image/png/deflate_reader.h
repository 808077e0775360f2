#pragma once
// The reading half of DEFLATE (RFC 1951), as far as its tokens: what another compressor found.

#include "render/image/png/deflate_writer.h"

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

/// Appends a raw stream's tokens. It unpacks nothing, so it costs by the packed size. False if the bytes
/// are no whole stream.
bool read_deflate(std::span<const std::byte> stream, std::vector<DeflateToken>& to);

}  // namespace mien
