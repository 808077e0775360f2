#include "sdf/distance/spans.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace mien::batch {
namespace {

/// Numbers of another size at the same place are no replacement.
bool overlap_partly(const Span& a, const Span& b) {
  const auto from_a = reinterpret_cast<uintptr_t>(a.begin), to_a = from_a + a.size * a.number_size;
  const auto from_b = reinterpret_cast<uintptr_t>(b.begin), to_b = from_b + b.size * b.number_size;
  const bool same = from_a == from_b && to_a == to_b;
  return !same && from_a < to_b && from_b < to_a;
}

[[noreturn]] void refuse(const char* function, const char* why) {
  std::fprintf(stderr, "mien::%s: %s\n", function, why);
  std::abort();
}

}  // namespace

void require_spans(const char* function, Span x, Span y, Span out) {
  if (x.size != out.size || y.size != out.size) {
    refuse(function, "expected spans of equal length");
  }
  if (overlap_partly(x, out) || overlap_partly(y, out)) {
    refuse(function, "the output overlaps an input without being the same span");
  }
}

}  // namespace mien::batch
