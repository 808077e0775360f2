#pragma once
// How often a test program has allocated so far. Counted by operators of its own; not under a
// sanitizer, which has its own.

#include "tests/support/effort.h"

namespace mien::test {

inline constexpr bool kCountsAllocations = !kSanitized;
long allocations();

}  // namespace mien::test
