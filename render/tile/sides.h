#pragma once
// Layers' programs on many squares at once: a bit per square says whether it lies wholly inside an
// outline, another whether wholly outside; neither: it may be crossed.

#include <mien/render/tile/tape.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mien {

/// Up to 64 squares against one outline or area.
struct Sides {
  std::uint64_t in = 0, out = 0;
  std::uint64_t unknown() const { return ~(in | out); }
};

/// Runs a layer's program; `outlines` by index into Tape::outlines. An empty program is everywhere.
Sides sides_of(std::span<const Step> steps, std::span<const Sides> outlines,
               std::vector<Sides>& stack);

}  // namespace mien
