#pragma once
// What batch functions ask of the spans they are given.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mien::batch {

/// Whether two runs of numbers share memory without being the same run. Numbers of another size at the
/// same place are another run.
template <class A, class B>
bool overlap_partly(std::span<A> a, std::span<B> b) {
  const auto from_a = reinterpret_cast<std::uintptr_t>(a.data()), to_a = from_a + a.size_bytes();
  const auto from_b = reinterpret_cast<std::uintptr_t>(b.data()), to_b = from_b + b.size_bytes();
  const bool same = from_a == from_b && to_a == to_b && sizeof(A) == sizeof(B);
  return !same && from_a < to_b && from_b < to_a;
}

/// Asserts that the spans are equally long and that each input is either exactly the output or clear of
/// it. Without assertions all become as long as the shortest, so that nothing beyond it is touched.
template <class X, class D>
void fit_spans(std::span<const X>& x, std::span<const X>& y, std::span<D>& d) {
  assert(x.size() == d.size() && y.size() == d.size() && "spans of equal length");
  assert(!overlap_partly(x, d) && !overlap_partly(y, d) && "the output is an input or clear of it");
  const std::size_t size = std::min({x.size(), y.size(), d.size()});
  x = x.first(size), y = y.first(size), d = d.first(size);
}

}  // namespace mien::batch
