#pragma once
// How often a test program has allocated so far, and what it holds. Counted by operators of its own; not under a
// sanitizer, which has its own.

#include "tests/support/process/effort.h"

namespace mien::test {

inline constexpr bool kCountsAllocations = !kSanitized;
long allocations();
/// Bytes that are allocated now, with what the allocator rounds up.
long held_bytes();

}  // namespace mien::test
