#pragma once

#include <cstddef>
#include <cstdint>

namespace mien::bench {

/// Fills `count` pixels with one colour: what any picture of that size costs at least. Ordinary
/// stores go through the caches, streaming (non-temporal) ones past them.
void fill_ordinary(std::uint32_t* pixels, std::size_t count, std::uint32_t color);
void fill_streaming(std::uint32_t* pixels, std::size_t count, std::uint32_t color);

}  // namespace mien::bench
