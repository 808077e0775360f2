#pragma once
// A malloc that fails when it is asked to: linked into a test, or loaded before a program, where MIEN_FAIL_ALLOCATION=N
// makes the Nth allocation fail, and MIEN_COUNT_ALLOCATIONS=FILE writes down how many there were. Operator new comes
// here as well, as the standard library's calls malloc.

#include "tests/support/process/effort.h"

namespace mien::test {

/// Sanitizers have allocators of their own.
inline constexpr bool kFailsAllocations = !kSanitized;

/// The `index`th allocation from now on fails, counted from 1, and with `ever_after` all that follow. 0: none.
void fail_allocation(long index, bool ever_after = false);
/// From here on none fails and none is counted.
void stop_failing();
/// Between fail_allocation and stop_failing, those that failed too.
long allocations_tried();
/// Blocks that are allocated now.
long blocks_held();

}  // namespace mien::test
