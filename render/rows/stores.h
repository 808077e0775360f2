#pragma once
// How pixels of 8 bits go to memory, many at a time.

#include <cstddef>
#include <cstdint>

namespace mien {

/// `streamed` stores pass the caches by. Right for buffers that are larger than those, wrong for
/// smaller ones.
enum class Stores { ordinary, streamed };

/// Fills `rows` rows of `count` pixels, rows `stride` pixels apart.
void fill_rows(std::uint32_t* pixels, std::size_t stride, int rows, int count, std::uint32_t value,
               Stores stores);

/// Copies `rows` rows of `count` pixels, one after the other, to memory by streamed stores. The count is a
/// multiple of 16, and rows of the target begin at multiples of 64 bytes.
void stream_rows(const std::uint32_t* from, int count, int rows, std::uint32_t* pixels,
                 std::size_t stride);

/// Call before other threads read what was streamed.
void finish_streams();

}  // namespace mien
