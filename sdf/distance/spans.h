#pragma once
// What batch functions ask of the spans they are given, refused aloud.

#include <cstddef>

namespace mien::batch {

/// A run of numbers in memory, for the check below.
struct Span {
  const void* begin;
  size_t size;         ///< in numbers
  size_t number_size;  ///< in bytes
};

/// Ends the program with a sentence on stderr unless all inputs are as long as the output and each
/// of them is either exactly the output or clear of it. A caller who breaks this has no answer to
/// be given.
void require_spans(const char* function, Span x, Span y, Span out);

}  // namespace mien::batch
