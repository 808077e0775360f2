#pragma once
// The only use of threads in mien. Results never depend on how many there are.

#include <mien/api.h>

#include <functional>

namespace mien {

/// Runs jobs on the caller's own threads. It must run each of job(0) … job(count − 1) once, in any order and
/// on any threads, and return when all are done.
using Executor = std::function<void(int count, const std::function<void(int)>& job)>;

/// The threads that work is spread over.
struct Threads {
  int count = 0;           ///< 1: the caller's alone; 0, or more than the machine has: all of them
  Executor executor = {};  ///< if set, replaces mien's own pool; `count` is ignored then
};

/// Runs job(0) … job(count − 1), in any order, and returns when all are done.
MIEN_API void parallel_for(int count, const Threads& threads, const std::function<void(int)>& job);

}  // namespace mien
