#pragma once
// Work made on many threads, taken in order.

#include <mien/parallel.h>

#include <functional>

namespace mien {

/// Runs make(i, slot) for i = 0 … count − 1, several at once, and take(i, slot) in that order, one at
/// a time and each after its make. A slot (0 … slots − 1) is one piece of work's alone from its make
/// to the end of its take: what they hand over lies there, so no more than `slots` are held at once.
/// Either may return false: then nothing more begins. Returns whether all was taken.
///
/// Takes run on whichever thread has the next one ready, while others make. With the caller's own
/// executor it is right in any order, even one after the other.
bool ordered_pipeline(int count, int slots, const Threads& threads,
                      const std::function<bool(int i, int slot)>& make,
                      const std::function<bool(int i, int slot)>& take);

/// How many threads those are.
int thread_count(const Threads& threads);

}  // namespace mien
