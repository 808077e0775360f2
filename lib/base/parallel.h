#pragma once
// The one door to threads. Results never depend on how many there are.

#include <mien/api.h>

#include <functional>

namespace mien {

/// The caller's own threads: must run job(0) … job(count − 1), each once, in any order and on any
/// threads, and return when all are done.
using Executor = std::function<void(int count, const std::function<void(int)>& job)>;

/// Which threads work is spread over.
struct Threads {
  int count = 0;      ///< 0, or more than the machine has: as many as it has; 1: the caller's alone
  Executor executor;  ///< if set, used instead of mien's own pool, and `count` is ignored
};

/// Runs job(0) … job(count − 1), in any order, and returns when all are done.
MIEN_API void parallel_for(int count, const Threads& threads, const std::function<void(int)>& job);

}  // namespace mien
