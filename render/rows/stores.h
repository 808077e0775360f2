#pragma once
// How runs of one colour go to memory.

#include <array>
#include <cstddef>

namespace mien {

/// `streamed` stores bypass the caches. Right for pictures that are larger than the caches, wrong for smaller ones.
enum class Stores { ordinary, streamed };

/// A pixel again and again.
using RunPattern = std::array<std::byte, 64>;

/// Writes `count` pixels of `bytes` each: 4, 8 or 16. Short runs are never streamed.
void fill_run(std::byte* to, int count, const RunPattern& pattern, std::size_t bytes,
              Stores stores);

/// Call before other threads read what was streamed.
void finish_streams();

}  // namespace mien
