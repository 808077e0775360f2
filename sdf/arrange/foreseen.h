#pragma once
// What arranging outlines is certain to hold, known before one of them is made.

#include "sdf/outline/area_program.h"
#include "sdf/outline/outline_maker.h"

#include <cstdint>
#include <span>

namespace mien {

/// [bytes] A sweep over these outlines, among others perhaps, holds that much and mostly more: only paths count, whose
/// pieces follow from their sides.
std::uint64_t least_bytes(const AreaPrograms& programs, std::span<const OutlineSource> sources,
                          const OutlineFrame& frame);

/// Ends the watched work if these outlines are certain to take more memory than it may.
void foresee(const AreaPrograms& programs, std::span<const OutlineSource> sources,
             const OutlineFrame& frame);

/// The same of all the scene's layers.
void foresee(const Scene& scene, const OutlineFrame& frame);

}  // namespace mien
